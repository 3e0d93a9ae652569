//! The numbers of a whole cook, as `saute cook --json` prints them.

use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

use saute_food::{Rules, Scale, Shares};
use serde::{Serialize, Serializer};

use crate::action;
use crate::cook::recorder::Recorder;
use crate::cook::runner::{Runner, StoppedBy};
use crate::cook::step_record::{StepRecord, rounded};
use crate::recipe::{Group, Recipe};
use crate::summary::group_summary::GroupSummary;
use saute_kitchen::celsius;
use saute_kitchen::data::library::DEFAULT_SCALE;
use saute_kitchen::doneness::{at_core, core_class, fitting};
use saute_kitchen::kitchen::Kitchen;
use saute_kitchen::liquids::butter::ButterModel;
use saute_kitchen::piece::piece_state::Piece;
use saute_kitchen::tick::energy::Energy;
use saute_kitchen::tick::event::Tally;

/// The result of one cook.
#[derive(Clone, Debug, Serialize)]
pub struct Summary {
    /// Title of the recipe.
    pub title: String,
    /// Rules of the simulation: "full" or "2013".
    pub rules: Rules,
    /// Simulated time [s].
    pub simulated_s: f64,
    /// Wall time of the simulation [s].
    pub wall_s: f64,
    /// Reason for which the cook stopped.
    pub stopped_by: StoppedBy,
    /// The next step, from 1, if `max_s` stopped the cook.
    pub waiting_step: Option<usize>,
    /// Foods.
    pub foods: Vec<FoodSummary>,
    /// Groups of foods.
    pub groups: Vec<GroupSummary>,
    /// Pan temperatures [°C].
    pub pan_c: PanSummary,
    /// Oil with which the cook began.
    pub oil_at_start: OilAtStart,
    /// Liquids of the pan [g].
    pub liquids_g: LiquidsSummary,
    /// Events by kind.
    pub events: Vec<Tally>,
    /// Energy [J].
    pub energy_j: Energy,
    /// Steps in the order they fired.
    pub steps: Vec<StepRecord>,
    /// Warnings.
    pub warnings: Vec<String>,
}

/// Pan temperatures [°C].
#[derive(Clone, Copy, Debug, Serialize)]
pub struct PanSummary {
    /// Highest.
    pub peak: f64,
    /// At the first `put`.
    pub at_first_put: Option<f64>,
    /// Lowest after that.
    pub lowest_after_first_put: Option<f64>,
    /// At the end.
    pub end: f64,
}

/// Oil with which a cook began.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct OilAtStart {
    /// Canola oil, or the film of a seasoned pan [g].
    pub g: f64,
    /// True if the recipe states it; false if it states none, and has the usual oil.
    pub stated: bool,
}

/// Liquids of the pan [g].
#[derive(Clone, Copy, Debug, Serialize)]
pub struct LiquidsSummary {
    /// Oil and fat of all kinds in the pan.
    pub oil: f64,
    /// Share of butter fat in it, without milk solids.
    pub butter_fat: f64,
    /// Water in the pan.
    pub water: f64,
    /// Oil lost as smoke.
    pub smoked: f64,
    /// Oil that burnt.
    pub burnt: f64,
    /// Oil that spattered out of the pan.
    pub spattered: f64,
    /// Liquid that ran over the rim.
    pub spilled: f64,
    /// Dried solids of juice on the pan.
    pub fond: f64,
    /// Browned part of them, mass × browning.
    pub fond_browned: f64,
    /// Charred part of them, mass × charring.
    pub fond_charred: f64,
    /// Solids of juice dissolved in the pan's water; not included in the water's mass.
    pub dissolved: f64,
}

impl OilAtStart {
    fn new(kitchen: &Kitchen, recipe: &Recipe) -> Self {
        let usual_g = kitchen.room().contact.oil_g;
        let film_g = kitchen.pan_model().description.surface.film_g;
        Self { g: recipe.oil.map_or(usual_g, |kg| 1e3 * kg).max(film_g), stated: recipe.oil.is_some() }
    }
}

impl LiquidsSummary {
    fn new(kitchen: &Kitchen) -> Self {
        let (model, liquids) = (&kitchen.pan_model().liquids, &kitchen.pan_state().liquids);
        let [dried, browned, charred] = liquids.fond.dried_kg(&model.bed);
        let fat = |b: &ButterModel| liquids.oil.total_of(b.kind) * (1.0 - b.solids_share());
        Self {
            oil: 1e3 * liquids.oil.total(),
            butter_fat: 1e3 * model.butter.as_ref().map_or(0.0, fat),
            water: 1e3 * liquids.water.total(),
            smoked: 1e3 * liquids.smoke.smoked,
            burnt: 1e3 * liquids.smoke.burnt,
            spattered: 1e3 * liquids.spatter.spattered,
            spilled: 1e3 * liquids.spilled,
            fond: 1e3 * dried,
            fond_browned: 1e3 * browned,
            fond_charred: 1e3 * charred,
            dissolved: 1e3 * liquids.fond.dissolved_kg(),
        }
    }
}

/// One food.
#[derive(Clone, Debug, Serialize)]
pub struct FoodSummary {
    /// Id in the recipe.
    pub id: String,
    /// Id of the food's kind.
    pub kind: String,
    /// Id of its group.
    pub group: Option<String>,
    /// Place: "waiting", "pan", "board", "rack" or "foil"; "several" for a group whose pieces are in different places.
    pub place: &'static str,
    /// Nodes of its mesh.
    pub nodes: usize,
    /// Mass [g].
    pub mass_g: StartEnd,
    /// Mass loss relative to the initial mass [%].
    pub lost_pct: f64,
    /// Water that left [g].
    pub water_g: WaterSummary,
    /// Fat rendered into the pan's oil [g].
    pub fat_rendered_g: f64,
    /// Heat that it took from the pan and from liquids and steam in it [J].
    pub heat_j: f64,
    /// Core temperature [°C].
    pub core_c: CoreSummary,
    /// Distance of the knife's cut from the middle of the long axis [mm]; null for a whole piece; the mean for a group
    /// whose pieces are all cut.
    pub halved_at_mm: Option<f64>,
    /// Doneness of the section by area, by the scale of 2013 [%].
    pub section_pct: Doneness,
    /// Doneness by volume, by the scale of 2013 [%].
    pub volume_pct: Doneness,
    /// Doneness by every scale that fits this food, by the scales' ids: its own, else those of its kind of flesh.
    pub doneness: ByScale,
    /// Shares of the first-order changes by name, volume means [-].
    pub denatured: BTreeMap<String, f64>,
    /// Volume mean of the elastic modulus [kPa].
    pub elastic_modulus_kpa: f64,
    /// Volume mean of the hardness on biting relative to the raw food [-].
    pub hardness_index: f64,
    /// Volume mean of juiciness relative to the raw food [%].
    pub juiciness_pct: f64,
    /// Present shape.
    pub shape: Shape,
    /// Log₁₀ reduction of germs [-].
    pub log_reduction: LogReduction,
    /// Upper and lower face.
    pub surfaces: Surfaces,
}

/// Log₁₀ reduction of a germ [-].
#[derive(Clone, Debug, Default, Serialize)]
pub struct LogReduction {
    /// The germ that the kinetics state the kill of.
    pub germ: String,
    /// Reduction from which the food is called pasteurised; none where the kinetics call it neither that nor otherwise.
    pub asked: Option<f64>,
    /// At the core.
    pub core: f64,
    /// At the least heated point of the surface.
    pub surface: f64,
}

/// First and last value.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct StartEnd {
    /// At the start.
    pub start: f64,
    /// At the end.
    pub end: f64,
}

/// Water that left a food [g].
#[derive(Clone, Copy, Debug, Serialize)]
pub struct WaterSummary {
    /// As vapour.
    pub evaporated: f64,
    /// As juice.
    pub dripped: f64,
}

/// Core temperature [°C].
#[derive(Clone, Copy, Debug, Serialize)]
pub struct CoreSummary {
    /// At the end.
    pub end: f64,
    /// Highest.
    pub peak: f64,
    /// When it was highest [s].
    pub peak_at_s: f64,
}

/// Shares by highest temperature so far [%].
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Doneness {
    /// Below 50 °C.
    pub raw: f64,
    /// 50–60 °C.
    pub rare: f64,
    /// 60–70 °C.
    pub medium: f64,
    /// Above 70 °C.
    pub well_done: f64,
}

impl From<Shares> for Doneness {
    fn from(s: Shares) -> Self {
        let [raw, rare, medium, well_done, _] = s.0;
        Self { raw, rare, medium, well_done }
    }
}

/// Doneness by each scale, in the order of the scales.
#[derive(Clone, Debug, Default)]
pub struct ByScale(pub Vec<(String, ScaleReading)>);

impl ByScale {
    /// Returns the reading in the food's words, with the id of its scale: by the scale with the given id if it covers the
    /// food, else by the first that does; none if no scale covers the food.
    pub fn in_words_of(&self, id: &str) -> Option<&(String, ScaleReading)> {
        self.0.iter().find(|(own, _)| own == id).or(self.0.first())
    }
}

impl Serialize for ByScale {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.collect_map(self.0.iter().map(|(id, reading)| (id, reading)))
    }
}

/// Doneness by one scale.
#[derive(Clone, Debug, Serialize)]
pub struct ScaleReading {
    /// Label of the scale.
    pub label: String,
    /// Class of the core: of its peak, or of the share of its change.
    pub class: String,
    /// What the scale measures at the core [K or -].
    #[serde(skip)]
    pub at_core: f64,
    /// Shares of the section by area [%].
    pub section_pct: ClassShares,
    /// Shares of the volume [%].
    pub volume_pct: ClassShares,
}

/// Classes with their shares, in the order of their scale [%].
#[derive(Clone, Debug)]
pub struct ClassShares(pub Vec<(String, f64)>);

impl ClassShares {
    fn new(scale: &Scale, shares: Shares) -> Self {
        Self(scale.class.iter().map(|c| c.name.clone()).zip(shares.0).collect())
    }
}

impl Serialize for ClassShares {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.collect_map(self.0.iter().map(|(name, share)| (name, share)))
    }
}

impl ScaleReading {
    fn new(piece: &Piece, scale: &Scale) -> Self {
        let (model, state) = (&piece.model, &piece.state);
        Self {
            label: scale.name.clone(),
            class: core_class(piece, scale).to_owned(),
            at_core: at_core(piece, scale),
            section_pct: ClassShares::new(scale, model.cut_shares(state, &model.cut_across(0.0), scale)),
            volume_pct: ClassShares::new(scale, model.volume_shares(state, scale)),
        }
    }
}

/// Present shape.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Shape {
    /// Volume relative to the raw volume [%].
    pub volume_pct: f64,
    /// Lengths across the fibres relative to the raw food [%].
    pub across_pct: f64,
    /// Mean thickness [mm].
    pub thickness_mm: f64,
    /// Height of the middle of the lower face above its rim [mm]; negative if the rim is higher.
    pub dome_mm: f64,
    /// Height of the waves of a thin slice from trough to crest [mm]; 0 for others.
    pub waves_mm: f64,
    /// Curl angle of a body that curls, such as a shrimp [°]; 0 for others.
    pub curl_deg: f64,
}

/// Both faces of a food.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Surfaces {
    /// Upper face.
    pub top: Surface,
    /// Lower face.
    pub bottom: Surface,
}

/// Area means and shares of a face.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Surface {
    /// Temperature [°C].
    pub temperature_c: f64,
    /// L*, a*, b*.
    pub lab: [f64; 3],
    /// Area with browning above 0.5 [%].
    pub browned_pct: f64,
    /// Area with charring above 0.2 [%].
    pub charred_pct: f64,
}

impl Summary {
    /// Summarises a cook. `masses_at_start` are the initial masses of the foods [kg].
    pub fn new(
        kitchen: &Kitchen,
        recorder: &Recorder,
        runner: &Runner,
        steps: &[StepRecord],
        masses_at_start: &[f64],
        scales: &[Arc<Scale>],
        wall_s: f64,
    ) -> Self {
        let stopped_by = runner.stopped().unwrap_or(StoppedBy::MaxS);
        // In a session pieces may have been removed: a group counts while it is whole.
        let ids = |g: &Group| (kitchen.pieces().get(g.members.clone()), runner.recipe().foods.get(g.members.clone()));
        let is_whole = |g: &&Group| match ids(g) {
            (Some(pieces), Some(foods)) => pieces.iter().map(|p| &p.id).eq(foods.iter().map(|f| &f.id)),
            _ => false,
        };
        let groups: Vec<&Group> = runner.recipe().groups.iter().filter(is_whole).collect();
        let group_of = |i: usize| groups.iter().find(|g| g.members.contains(&i)).map(|g| g.id.clone());
        let pieces = kitchen.pieces().iter().zip(masses_at_start).enumerate();
        let foods: Vec<FoodSummary> =
            pieces.map(|(i, (p, m))| FoodSummary { group: group_of(i), ..FoodSummary::new(p, *m, scales) }).collect();
        let dangers = kitchen.events().tallies().filter(|t| t.kind.warns()).filter_map(|t| t.kind.advice());
        let dangers = dangers.map(str::to_owned);
        let blocked = kitchen.blocked().into_iter();
        let blocked =
            blocked.map(|id| format!("{id} could not be moved as asked: something was in the way, or it is too heavy"));
        let unhealthy = kitchen.pieces().iter().filter(|p| !p.state.healthy);
        Self {
            title: runner.recipe().title.clone(),
            rules: kitchen.rules(),
            simulated_s: rounded(kitchen.time_s()),
            wall_s,
            stopped_by,
            waiting_step: (stopped_by == StoppedBy::MaxS).then(|| runner.waiting_step() + 1),
            groups: groups.iter().map(|g| GroupSummary::new(g, &foods[g.members.clone()], scales)).collect(),
            foods,
            pan_c: PanSummary {
                peak: recorder.pan_peak_c,
                at_first_put: recorder.pan_at_first_put_c,
                lowest_after_first_put: recorder.pan_lowest_after_c,
                end: celsius(kitchen.pan_temperature()),
            },
            oil_at_start: OilAtStart::new(kitchen, runner.recipe()),
            liquids_g: LiquidsSummary::new(kitchen),
            events: kitchen.events().tallies().copied().collect(),
            energy_j: kitchen.energy(),
            steps: steps.to_vec(),
            warnings: unhealthy
                .map(|p| format!("{} became non-finite and was frozen", p.id))
                .chain(dangers)
                .chain(blocked)
                .chain(runner.warnings().iter().cloned())
                .collect(),
        }
    }
}

/// A single food, or a group with its means.
#[derive(Clone, Debug)]
pub struct FoodOrGroup<'a> {
    /// Result of the food, or the means of the group.
    pub food: &'a FoodSummary,
    /// Indices into the foods.
    pub members: Range<usize>,
    /// True for a group.
    pub group: bool,
}

impl Summary {
    /// Returns the single foods and the groups in the order of the recipe.
    pub fn foods_and_groups(&self) -> Vec<FoodOrGroup<'_>> {
        let group_at = |i: usize| self.groups.iter().find(|g| g.members.start == i);
        let entry = |(i, food): (usize, _)| match group_at(i) {
            Some(group) => Some(FoodOrGroup { food: &group.mean, members: group.members.clone(), group: true }),
            None => self.foods[i].group.is_none().then_some(FoodOrGroup { food, members: i..i + 1, group: false }),
        };
        self.foods.iter().enumerate().filter_map(entry).collect()
    }
}

/// Name of the place in the pan.
pub(crate) const IN_PAN: &str = "pan";

impl FoodSummary {
    fn new(piece: &Piece, mass_at_start: f64, scales: &[Arc<Scale>]) -> Self {
        let (model, state) = (&piece.model, &piece.state);
        let surface = |up| {
            let face = model.face_reading(state, up);
            Surface {
                temperature_c: celsius(face.temperature),
                lab: face.lab.0,
                browned_pct: face.browned_pct,
                charred_pct: face.charred_pct,
            }
        };
        let (core, least) = model.log_reduction(state);
        let lethality = &model.kinetics().lethality;
        // The library does not load without the default scale.
        let default = scales.iter().find(|s| s.id == DEFAULT_SCALE);
        let names = model.kinetics().names();
        let mean = |field: &Vec<f64>| model.volume_mean(field);
        let upwards = if piece.upside_down() { -1.0 } else { 1.0 };
        Self {
            id: piece.id.clone(),
            kind: piece.kind.clone(),
            group: None,
            place: piece.place.name(),
            nodes: model.mesh().node_count(),
            mass_g: StartEnd { start: 1e3 * mass_at_start, end: 1e3 * piece.mass() },
            lost_pct: 100.0 * (1.0 - piece.mass() / mass_at_start),
            water_g: WaterSummary { evaporated: 1e3 * state.evaporated, dripped: 1e3 * state.dripped },
            fat_rendered_g: 1e3 * state.rendered,
            heat_j: piece.heat_taken,
            core_c: CoreSummary {
                end: celsius(piece.core()),
                peak: celsius(piece.core_peak.0),
                peak_at_s: rounded(piece.core_peak.1),
            },
            halved_at_mm: piece.halved().map(|cut| action::mm(cut.at)),
            section_pct: default.map(|s| model.cut_shares(state, &model.cut_across(0.0), s).into()).unwrap_or_default(),
            volume_pct: default.map(|s| model.volume_shares(state, s).into()).unwrap_or_default(),
            doneness: ByScale(
                fitting(scales, model).into_iter().map(|s| (s.id.clone(), ScaleReading::new(piece, s))).collect(),
            ),
            denatured: names.into_iter().map(str::to_owned).zip(state.changed.iter().map(mean)).collect(),
            elastic_modulus_kpa: model.elastic_modulus_kpa(state),
            hardness_index: model.hardness_index(state),
            juiciness_pct: model.juiciness_pct(state),
            shape: Shape {
                volume_pct: 100.0 * model.relative_volume(state),
                across_pct: 100.0 * state.stretch.lateral,
                thickness_mm: 1e3 * model.thickness(state),
                dome_mm: 1e3 * upwards * state.stretch.dome,
                waves_mm: 1e3 * state.stretch.waves,
                curl_deg: model.curl(state).to_degrees(),
            },
            log_reduction: LogReduction {
                germ: lethality.germ.clone(),
                asked: lethality.pasteurised_log,
                core,
                surface: least,
            },
            surfaces: Surfaces { top: surface(piece.up().map(|v| -v)), bottom: surface(piece.up()) },
        }
    }
}
