//! The numbers of a whole cook, as `saute cook --json` prints them.

use std::collections::BTreeMap;

use saute_food::Rules;
use serde::Serialize;

use crate::celsius;
use crate::energy::Energy;
use crate::kitchen::Kitchen;
use crate::piece::Piece;
use crate::recorder::Recorder;
use crate::runner::{Runner, StepRecord, StoppedBy, rounded};

/// Everything about one cook.
#[derive(Clone, Debug, Serialize)]
pub struct Summary {
    /// Title of the recipe.
    pub title: String,
    /// Rules that were followed: "full" or "2013".
    pub rules: Rules,
    /// Simulated time [s].
    pub simulated_s: f64,
    /// Wall time of the simulation [s].
    pub wall_s: f64,
    /// Why it stopped.
    pub stopped_by: StoppedBy,
    /// Step that was still waited for, from 1, if `max_s` stopped it.
    pub waiting_step: Option<usize>,
    /// Foods.
    pub foods: Vec<FoodSummary>,
    /// Pan temperatures [°C].
    pub pan_c: PanSummary,
    /// Energy [J].
    pub energy_j: Energy,
    /// Steps in the order they fired.
    pub steps: Vec<StepRecord>,
    /// Warnings; empty if all went well.
    pub warnings: Vec<String>,
}

/// Pan temperatures [°C].
#[derive(Clone, Copy, Debug, Serialize)]
pub struct PanSummary {
    /// Highest.
    pub peak: f64,
    /// When the first food went in.
    pub at_first_put: Option<f64>,
    /// Lowest after that.
    pub lowest_after_first_put: Option<f64>,
    /// At the end.
    pub end: f64,
}

/// One food.
#[derive(Clone, Debug, Serialize)]
pub struct FoodSummary {
    /// Name in the recipe.
    pub id: String,
    /// Kind of food.
    pub kind: String,
    /// Nodes of its mesh.
    pub nodes: usize,
    /// Mass [g].
    pub mass_g: StartEnd,
    /// Mass lost over the mass at the start [%].
    pub lost_pct: f64,
    /// Water that left [g].
    pub water_g: WaterSummary,
    /// Fat that ran off into the pan's oil [g].
    pub fat_rendered_g: f64,
    /// Core temperature [°C].
    pub core_c: CoreSummary,
    /// Doneness of the section by area [%].
    pub section_pct: Doneness,
    /// Doneness by volume [%].
    pub volume_pct: Doneness,
    /// Shares of the first-order changes by name, volume means [-].
    pub denatured: BTreeMap<String, f64>,
    /// Volume mean of the elastic modulus [kPa].
    pub elastic_modulus_kpa: f64,
    /// Volume mean of the hardness on biting over that of the raw food [-].
    pub hardness_index: f64,
    /// Volume mean of juiciness, raw 100 [%].
    pub juiciness_pct: f64,
    /// How far it has contracted and bent.
    pub shape: Shape,
    /// Log₁₀ reduction of E. coli O157:H7 [-].
    pub log_reduction: LogReduction,
    /// Both faces, as they lie.
    pub surfaces: Surfaces,
}

/// Log₁₀ reduction of pathogens [-]; 6.5 and more count as safe for beef.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct LogReduction {
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
#[derive(Clone, Copy, Debug, Serialize)]
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

impl From<saute_food::Shares> for Doneness {
    fn from(s: saute_food::Shares) -> Self {
        let [raw, rare, medium, well_done] = s.0;
        Self { raw, rare, medium, well_done }
    }
}

/// Present shape.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Shape {
    /// Volume over the raw volume [%].
    pub volume_pct: f64,
    /// Lengths across the fibres over the raw ones [%].
    pub across_pct: f64,
    /// Mean thickness [mm].
    pub thickness_mm: f64,
    /// How far the middle of the lower face stands off its rim; negative where the rim stands off [mm].
    pub dome_mm: f64,
}

/// Both faces of a food.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Surfaces {
    /// The face that lies above.
    pub top: Surface,
    /// The face that lies below.
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
    /// Reads everything off a kitchen after a cook.
    pub fn new(
        kitchen: &Kitchen,
        recorder: &Recorder,
        runner: &Runner,
        steps: &[StepRecord],
        masses_at_start: &[f64],
        wall_s: f64,
    ) -> Self {
        let stopped_by = runner.stopped().unwrap_or(StoppedBy::MaxS);
        let foods = kitchen.pieces().iter().zip(masses_at_start).map(|(p, m)| FoodSummary::new(p, *m)).collect();
        let unhealthy = kitchen.pieces().iter().filter(|p| !p.state.healthy);
        Self {
            title: runner.recipe().title.clone(),
            rules: kitchen.rules(),
            simulated_s: rounded(kitchen.time_s()),
            wall_s,
            stopped_by,
            waiting_step: (stopped_by == StoppedBy::MaxS).then(|| runner.waiting_step() + 1),
            foods,
            pan_c: PanSummary {
                peak: recorder.pan_peak_c,
                at_first_put: recorder.pan_at_first_put_c,
                lowest_after_first_put: recorder.pan_lowest_after_c,
                end: celsius(kitchen.pan_temperature()),
            },
            energy_j: kitchen.energy(),
            steps: steps.to_vec(),
            warnings: unhealthy.map(|p| format!("{} became non-finite and was frozen", p.id)).collect(),
        }
    }
}

impl FoodSummary {
    fn new(piece: &Piece, mass_at_start: f64) -> Self {
        let (model, state) = (&piece.model, &piece.state);
        let surface = |side| {
            let face = model.face_reading(state, side);
            Surface {
                temperature_c: celsius(face.temperature),
                lab: face.lab.0,
                browned_pct: face.browned_pct,
                charred_pct: face.charred_pct,
            }
        };
        let (core, least) = model.log_reduction(state);
        let names = model.kinetics.names();
        let mean = |field: &Vec<f64>| model.volume_mean(field);
        let upwards = if state.down == saute_food::Side::Bottom { 1.0 } else { -1.0 };
        Self {
            id: piece.id.clone(),
            kind: piece.kind.clone(),
            nodes: model.mesh.node_count(),
            mass_g: StartEnd { start: 1e3 * mass_at_start, end: 1e3 * piece.mass() },
            lost_pct: 100.0 * (1.0 - piece.mass() / mass_at_start),
            water_g: WaterSummary { evaporated: 1e3 * state.evaporated, dripped: 1e3 * state.dripped },
            fat_rendered_g: 1e3 * state.rendered,
            core_c: CoreSummary {
                end: celsius(piece.core()),
                peak: celsius(piece.core_peak.0),
                peak_at_s: rounded(piece.core_peak.1),
            },
            section_pct: model.cut_shares(state, &model.cut_across(0.0)).into(),
            volume_pct: model.volume_shares(state).into(),
            denatured: names.into_iter().map(str::to_owned).zip(state.changed.iter().map(mean)).collect(),
            elastic_modulus_kpa: model.elastic_modulus_kpa(state),
            hardness_index: model.hardness_index(state),
            juiciness_pct: model.juiciness_pct(state),
            shape: Shape {
                volume_pct: 100.0 * model.relative_volume(state),
                across_pct: 100.0 * state.stretch.lateral,
                thickness_mm: 1e3 * model.thickness(state),
                dome_mm: 1e3 * upwards * state.stretch.dome,
            },
            log_reduction: LogReduction { core, surface: least },
            surfaces: Surfaces { top: surface(state.down.opposite()), bottom: surface(state.down) },
        }
    }
}
