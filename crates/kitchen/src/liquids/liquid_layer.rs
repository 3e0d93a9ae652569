//! Liquids in the pan: flow, boiling, smoke and spatter of oil, water and butter.

use saute_food::{FreeAir, Rules, ZERO_C};
use saute_heat::Located;
use serde::{Deserialize, Serialize};

use crate::data::library::Library;
use crate::data::room::Room;
use crate::kelvin;
use crate::liquids::bath::{BathModel, Pool};
use crate::liquids::butter::{Butter, ButterModel};
use crate::liquids::drop_flight::Vessel;
use crate::liquids::film_flow::FilmFlow;
use crate::liquids::fond::{Fond, FondBed, FondModel};
use crate::liquids::oil::Oil;
use crate::liquids::oil_film::{Dose, Ground, OilFilm};
use crate::liquids::smoke::{OilFire, Smoke};
use crate::liquids::spatter::{DropSurroundings, Spatter};
use crate::liquids::water_film::{Vapour, WATER_DENSITY, WaterFilm, WaterModel};
use crate::pan::bed::Bed;
use crate::pan::pan_description::PanDescription;
use crate::tick::event::{Event, EventLog};

/// Immutable model of the liquids in a pan.
#[derive(Clone, Debug)]
pub struct LiquidModel {
    /// The pan's surface.
    pub bed: Bed,
    /// Kinds of oil, sorted by id.
    pub oils: Vec<Oil>,
    /// Water.
    pub water: WaterModel,
    /// Heat transfer to food in a liquid.
    pub bath: BathModel,
    /// Butter.
    pub butter: Option<ButterModel>,
    /// Fond.
    pub fond: FondModel,
    /// Volume up to the rim [m³].
    pub volume: f64,
    /// Number of floor nodes [-].
    floor_nodes: usize,
    floor_area: f64,
    /// Residual film of oil on a drained pan [m].
    clinging: f64,
    default: usize,
    rendered: usize,
}

/// Liquids in a pan.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Liquids {
    /// Oil and fat.
    pub oil: OilFilm,
    /// Water.
    pub water: WaterFilm,
    /// The part of the water that is deeper than a puddle.
    pub pool: Pool,
    /// Butter.
    pub butter: Butter,
    /// Fond: solids dried on the pan or dissolved in its water.
    pub fond: Fond,
    /// Smoke and fire.
    pub smoke: Smoke,
    /// Spatter.
    pub spatter: Spatter,
    /// Mass spilled over the rim or wiped off [kg].
    pub spilled: f64,
    /// Thickness of the oil film for contact and for drawing, at each node [m].
    pub film: Vec<f64>,
    oil_pace: Pace,
    water_pace: Pace,
    ticks: u64,
}

/// Depth from which a layer of oil that is heated from below turns over [m] (critical Rayleigh number 1100 under a free surface, oil
/// at 180 °C, 20 K), and from which it does so fully [m] (chosen).
const TURNS_OVER_M: f64 = 1.4e-3;
const POOL_M: f64 = 5e-3;
/// Pool of water that keeps the floor from getting hotter while it boils [kg] (chosen: it covers a floor of 26 cm by 1.6 mm).
const KEEPS_COOL_KG: f64 = 0.05;
/// Temperature from which it counts as boiling [°C] (chosen).
const POOL_BOILS_C: f64 = 99.5;

impl Liquids {
    /// Returns true if enough water boils in the pan to keep the floor from getting hotter.
    pub fn boils(&self) -> bool {
        self.pool.mass > KEEPS_COOL_KG && self.pool.temperature > kelvin(POOL_BOILS_C)
    }
}

/// Adaptive interval between updates of a liquid's flow: every tick while it flows fast, less often when slow.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Serialize)]
struct Pace {
    /// Time between two updates [s].
    interval: f64,
    /// Time since the last update [s].
    since: f64,
    /// Gravity in the pan's frame at the last update [m/s²].
    gravity: [f64; 3],
}

/// Target change of thickness between two updates [m] (chosen: two per cent of a film of 0.2 mm).
const CHANGE_PER_UPDATE: f64 = 4e-6;
/// Change of gravity's components below which the tilt is unchanged [m/s²] (chosen: a hundredth of a degree).
const SAME_LEAN: f64 = 2e-3;
/// Longest interval between two updates [s] (chosen).
const LONGEST_INTERVAL_S: f64 = 1.0;
/// Ticks between two updates of smoke, milk solids and fond [-] (chosen: half a second).
const SLOW_TICKS: u64 = 5;
/// Seed of the random numbers of spatter [-] (chosen).
const SPATTER_SEED: u64 = 0x5a17_7e55;

/// Scratch memory of the liquids' solver.
#[derive(Clone, Debug, Default)]
pub struct LiquidSolver {
    oil: FilmFlow,
    water: FilmFlow,
    /// Steam produced at each node in this tick [kg].
    pub steam: Vec<f64>,
    /// Water of the pan that boiled in this tick [kg].
    pub boiled: f64,
}

impl Pace {
    /// Time to integrate in this tick of `dt` [s]; 0 if no update is due.
    fn due(&mut self, gravity: [f64; 3], dt: f64) -> f64 {
        if (0..3).any(|k| libm::fabs(gravity[k] - self.gravity[k]) > SAME_LEAN) {
            *self = Self { gravity, ..Self::default() };
        }
        self.since += dt;
        if self.since < self.interval - 0.5 * dt {
            return 0.0;
        }
        core::mem::take(&mut self.since)
    }

    /// Sets the next interval after an update over `due` [s] that changed the thickness by `moved` [m].
    fn choose(&mut self, due: f64, moved: f64) {
        self.interval = (due * CHANGE_PER_UPDATE / moved.max(1e-30)).min(LONGEST_INTERVAL_S);
    }

    /// Requests an update in the next tick.
    fn stir(&mut self) {
        self.interval = 0.0;
    }
}

impl LiquidModel {
    /// Builds the model on a pan's mesh.
    pub fn new(bed: Bed, floor_nodes: usize, pan: &PanDescription, library: &Library) -> Self {
        let kinds = &library.oils;
        let oils: Vec<Oil> = kinds.iter().map(|(id, oil)| Oil::new(id, oil)).collect();
        // The library checks on loading that the kinds exist.
        let kind = |id: &String| kinds.keys().position(|k| k == id).unwrap_or(0);
        let use_of = &library.room.oil;
        let [floor, rim, height] = [pan.floor.radius_mm, pan.wall.rim_radius_mm, pan.wall.height_mm].map(|v| 1e-3 * v);
        Self {
            butter: ButterModel::new(&oils, kind(&use_of.butter), &library.room.foam),
            water: WaterModel::new(&library.room.puddle),
            bath: BathModel::new(&library.room.bath),
            fond: FondModel::new(&library.fond),
            volume: core::f64::consts::PI / 3.0 * height * (floor * floor + floor * rim + rim * rim),
            floor_area: bed.areas[..floor_nodes].iter().sum(),
            clinging: 1e-3 * use_of.clinging_mm,
            default: kind(&use_of.default),
            rendered: kind(&use_of.rendered),
            floor_nodes,
            oils,
            bed,
        }
    }

    /// The same liquids on another mesh of the pan.
    pub(crate) fn on(&self, bed: Bed, floor_nodes: usize) -> Self {
        Self { floor_area: bed.areas[..floor_nodes].iter().sum(), floor_nodes, bed, ..self.clone() }
    }

    /// Index of butter among the oils.
    pub fn butter_kind(&self) -> Option<usize> {
        self.butter.as_ref().map(|b| b.kind)
    }

    /// Initial state: oil [kg] on a dry pan of uniform temperature [K].
    pub fn fresh(&self, pan: f64, oil: f64, room: &Room) -> Liquids {
        let nodes = self.bed.areas.len();
        let mut liquids = Liquids {
            oil: OilFilm::none(nodes),
            water: WaterFilm::none(nodes),
            pool: Pool::default(),
            butter: Butter::default(),
            fond: Fond::none(nodes),
            smoke: Smoke::default(),
            spatter: Spatter::seeded(SPATTER_SEED),
            spilled: 0.0,
            film: vec![0.0; nodes],
            oil_pace: Pace::default(),
            water_pace: Pace::default(),
            ticks: 0,
        };
        let mut temperature = vec![pan; nodes];
        let dose = Dose { kind: self.default, mass: oil, temperature: pan };
        self.pour_oil(&mut liquids, dose, &vec![0.0; nodes], &mut temperature);
        self.refresh_film(&mut liquids, room);
        liquids
    }

    /// Adds oil evenly over the floor; `metal` contains the heat capacity of each node [J/K].
    pub fn pour_oil(&self, liquids: &mut Liquids, dose: Dose, metal: &[f64], temperature: &mut [f64]) {
        for i in 0..self.floor_nodes {
            let part = Dose { mass: dose.mass * self.bed.areas[i] / self.floor_area, ..dose };
            liquids.oil.add(&self.oils, i, part, metal[i], &mut temperature[i]);
        }
        liquids.oil_pace.stir();
    }

    /// Adds water with its enthalpy evenly over the floor.
    pub fn pour_water(&self, liquids: &mut Liquids, water: Vapour) {
        for i in 0..self.floor_nodes {
            let share = self.bed.areas[i] / self.floor_area;
            liquids.water.add(i, share * water.mass, share * water.enthalpy);
        }
        liquids.water_pace.stir();
    }

    /// Adds rendered fat [kg] with its enthalpy [J], which includes its latent heat of fusion [J/kg], in proportion to the
    /// oil at each node: boiling and sliding mix them. Returns the part of the enthalpy that the oil does not store [J].
    pub fn render(
        &self,
        liquids: &mut Liquids,
        (mass, enthalpy): (f64, f64),
        latent: f64,
        metal: &[f64],
        temperature: &mut [f64],
    ) -> f64 {
        if mass <= 0.0 {
            return enthalpy;
        }
        let capacity = mass * self.oils[self.rendered].specific_heat;
        let warmth = ((enthalpy - mass * latent) / capacity).clamp(0.0, 200.0);
        let dose = Dose { kind: self.rendered, mass, temperature: ZERO_C + warmth };
        let whole = liquids.oil.total();
        if whole <= 0.0 {
            self.pour_oil(liquids, dose, metal, temperature);
        } else {
            for i in 0..metal.len() {
                let part = Dose { mass: mass * liquids.oil.mass[i] / whole, ..dose };
                if part.mass > 0.0 {
                    liquids.oil.add(&self.oils, i, part, metal[i], &mut temperature[i]);
                }
            }
        }
        enthalpy - capacity * warmth
    }

    /// Heat of all liquids above 0 °C [J].
    pub fn stored(&self, liquids: &Liquids, temperature: &[f64]) -> f64 {
        let lump = liquids.butter.lump.as_ref().zip(self.butter.as_ref()).map_or(0.0, |(l, m)| m.stored(l));
        liquids.oil.stored(temperature) + liquids.water.stored() + lump
    }

    /// Melts butter and advances the flow of oil and water by `dt` [s]; returns the heat spilled over the rim [J].
    pub fn run(
        &self,
        liquids: &mut Liquids,
        solver: &mut LiquidSolver,
        gravity: [f64; 3],
        metal: &[f64],
        temperature: &mut [f64],
        dt: f64,
    ) -> f64 {
        self.melt(liquids, metal, temperature, dt);
        let mut lost = 0.0;
        let due = liquids.oil_pace.due(gravity, dt);
        if due > 0.0 {
            let on = Ground { bed: &self.bed, oils: &self.oils, metal, clinging: self.clinging };
            let run = liquids.oil.run(&mut solver.oil, &on, gravity, temperature, due);
            liquids.spilled += run.spilled;
            liquids.oil_pace.choose(due, run.moved);
            lost += run.spilled_heat;
        }
        let due = liquids.water_pace.due(gravity, dt);
        if due > 0.0 {
            let Liquids { water, fond, .. } = liquids;
            let run = water.run(&mut solver.water, fond, (&self.water, &self.bed), gravity, due);
            liquids.spilled += run.spilled;
            liquids.water_pace.choose(due, run.moved);
            lost += run.spilled_heat;
        }
        lost
    }

    fn melt(&self, liquids: &mut Liquids, metal: &[f64], temperature: &mut [f64], dt: f64) {
        let Some(model) = &self.butter else { return };
        if liquids.butter.lump.is_none() {
            return;
        }
        let Liquids { oil, water, butter, .. } = liquids;
        let before = oil.total_of(model.kind);
        let (mut fresh, mut watery) = (0.0, 0.0);
        butter.melt(model, temperature, dt, |molten, t| {
            let i = molten.node;
            *t -= molten.heat / (metal[i] + oil.capacity[i]);
            if molten.fat > 0.0 {
                let dose = Dose { kind: model.kind, mass: molten.fat, temperature: molten.temperature };
                oil.add(&self.oils, i, dose, metal[i], t);
                let warmth = crate::liquids::water_film::WATER_SPECIFIC_HEAT * (molten.temperature - ZERO_C);
                water.add(i, molten.water, molten.water * warmth);
                fresh += molten.fat;
                watery += molten.water;
            }
        });
        butter.water += watery;
        butter.freshen(before, fresh);
        liquids.oil_pace.stir();
        liquids.water_pace.stir();
    }

    /// Evaporation, spatter, foam, smoke and browning at the end of a tick; returns the vapour and the heat that left with
    /// oil [J].
    pub fn finish(
        &self,
        liquids: &mut Liquids,
        solver: &LiquidSolver,
        around: &PanSurroundings,
        temperature: &[f64],
        events: &mut EventLog,
        dt: f64,
    ) -> (Vapour, f64) {
        let room = around.room;
        let vapour = self.evaporate(liquids, around, dt);
        let mut heat = 0.0;
        let mut report = |kind, node: usize, amount| {
            events.push(Event { time_s: around.time, kind, at: self.bed.places[node], amount });
        };
        let Liquids { oil, spatter, smoke, .. } = liquids;
        let flying = DropSurroundings {
            vessel: around.vessel,
            middle: around.middle,
            covered: around.covered,
            time: [around.time, dt],
        };
        if !around.lidded {
            let pan = (&self.bed, &flying);
            heat += spatter.advance(&room.spatter, pan, oil, temperature, &solver.steam, &mut report);
        }
        spatter.land(&flying, around.time + dt);
        liquids.ticks += 1;
        if liquids.ticks.is_multiple_of(SLOW_TICKS) {
            let (oils, bed, lidded) = (&self.oils, &self.bed, around.lidded);
            let covered = if around.rules == Rules::Full { around.covered } else { &[] };
            let over = OilFire { data: &room.smoke, oils, bed, temperature, covered, lidded };
            let report = |kind, node: usize| report(kind, node, temperature[node]);
            heat += smoke.advance(&over, oil, dt * SLOW_TICKS as f64, report);
        }
        self.froth_and_brown(liquids, solver.boiled, temperature, dt);
        if liquids.ticks.is_multiple_of(SLOW_TICKS) {
            let Liquids { fond, water, .. } = liquids;
            let on = FondBed { bed: &self.bed, water, water_model: &self.water, metal: temperature };
            fond.advance(&self.fond, &on, dt * SLOW_TICKS as f64);
        }
        self.refresh_film(liquids, room);
        if around.rules == Rules::Full {
            liquids.pool = self.bath.mix(&mut liquids.water, &self.bed.areas, self.water.puddle_depth(), dt);
        }
        (vapour, heat)
    }

    /// Mixes a pool of oil for `dt` [s]: each place goes to the mean of the pool. The metal, whose heat capacity with the oil's is
    /// `capacity` [J/K], has the oil's temperature `t` [K].
    pub fn mix_oil(&self, liquids: &Liquids, capacity: &[f64], t: &mut [f64], dt: f64) {
        let rate = dt / self.bath.oil_mixing_s();
        // Heat that a node gives away while it goes to the mean, per kelvin [J/K].
        let given = |i: usize| {
            let mixes = ((liquids.film[i] - TURNS_OVER_M) / (POOL_M - TURNS_OVER_M)).clamp(0.0, 1.0);
            if mixes > 0.0 { capacity[i] * (1.0 - libm::exp(-mixes * rate)) } else { 0.0 }
        };
        let (mut whole, mut heat) = (0.0, 0.0);
        for (i, t) in t.iter().enumerate() {
            let share = given(i);
            whole += share;
            heat += share * t;
        }
        if whole > 0.0 {
            let mean = heat / whole;
            t.iter_mut().enumerate().for_each(|(i, t)| *t += given(i) / capacity[i] * (mean - *t));
        }
    }

    /// Depth of water at a place of the pan's mesh [m].
    pub fn water_depth(&self, liquids: &Liquids, at: &Located) -> f64 {
        let depth = |node: usize| liquids.water.mass[node] * self.bed.per_area[node] / WATER_DENSITY;
        (0..3).map(|k| at.weights[k] * depth(at.nodes[k] as usize)).sum()
    }

    /// Takes heat from the pool of water; returns what it could not take [J].
    pub fn draw_from_pool(&self, liquids: &mut Liquids, heat: f64) -> f64 {
        BathModel::draw(&mut liquids.water, &self.bed.areas, self.water.puddle_depth(), heat)
    }

    /// Updates foam and milk solids of butter.
    fn froth_and_brown(&self, liquids: &mut Liquids, boiled: f64, temperature: &[f64], dt: f64) {
        let Some(model) = &self.butter else { return };
        let Liquids { oil, water, butter, ticks, .. } = liquids;
        butter.froth(model, boiled, water.total(), dt);
        if ticks.is_multiple_of(SLOW_TICKS) {
            let long = dt * SLOW_TICKS as f64;
            butter.brown(model, oil, (water, &self.water), &self.bed, temperature, long);
        }
    }

    fn evaporate(&self, liquids: &mut Liquids, around: &PanSurroundings, dt: f64) -> Vapour {
        let mut total = Vapour::default();
        for i in 0..self.bed.areas.len() {
            if liquids.water.mass[i] > 0.0 {
                let bare = if i < self.floor_nodes { 1.0 - around.covered[i] } else { 1.0 };
                let vapour = liquids.water.evaporate(&self.water, i, self.bed.areas[i], bare, &around.air, dt);
                total = Vapour { mass: total.mass + vapour.mass, enthalpy: total.enthalpy + vapour.enthalpy };
            }
        }
        total
    }

    /// Updates the film's thickness with the oil density of the contact model.
    pub fn refresh_film(&self, liquids: &mut Liquids, room: &Room) {
        let per_mass = 1.0 / room.contact.oil_density_kg_m3;
        let fields = liquids.film.iter_mut().zip(&liquids.oil.mass).zip(&self.bed.areas);
        fields.for_each(|((film, mass), area)| *film = mass * per_mass / area);
    }

    /// Share of butter's fat in all oil and fat [-].
    pub fn butter_share(&self, liquids: &Liquids) -> f64 {
        let whole = liquids.oil.total();
        let own = self.butter.as_ref().map_or(0.0, |butter| liquids.oil.total_of(butter.kind));
        if whole > 0.0 { own / whole } else { 0.0 }
    }

    /// Colour of the oil from its kinds and milk solids, sRGB 0–255 [-]; `None` without oil.
    pub fn colour(&self, liquids: &Liquids) -> Option<[f64; 3]> {
        let whole = liquids.oil.total();
        if whole <= 0.0 {
            return None;
        }
        let mut colour = [0.0; 3];
        for fat in &liquids.oil.fats {
            let share = fat.mass.iter().sum::<f64>() / whole;
            let own = self.oils[fat.kind].description.look.colour_srgb.map(f64::from);
            let milky = self.butter.as_ref().is_some_and(|b| b.kind == fat.kind);
            let (brown, char) = if milky { (liquids.butter.browning, liquids.butter.charring) } else { (0.0, 0.0) };
            for k in 0..3 {
                let browned = own[k] + brown * (BROWNED[k] - own[k]);
                colour[k] += share * (browned + char * (CHARRED[k] - browned));
            }
        }
        Some(colour)
    }
}

/// Brown butter, sRGB (chosen: hazelnut).
const BROWNED: [f64; 3] = [132.0, 78.0, 26.0];
/// Burnt butter, sRGB (chosen).
const CHARRED: [f64; 3] = [34.0, 24.0, 18.0];

/// Surroundings of the liquids at the end of a tick.
#[derive(Clone, Copy, Debug)]
pub struct PanSurroundings<'a> {
    /// The room.
    pub room: &'a Room,
    /// Air over the pan.
    pub air: FreeAir,
    /// True if a lid is on.
    pub lidded: bool,
    /// Share of each node under food [-].
    pub covered: &'a [f64],
    /// By the rules of 2013 food does not keep the oil below it from smoking, and water does not mix.
    pub rules: Rules,
    /// Geometry of the pan for flying drops.
    pub vessel: Vessel,
    /// Centre of the pan relative to that of the ring [m].
    pub middle: [f64; 2],
    /// Time at the start of the tick [s].
    pub time: f64,
}

impl Liquids {
    /// Adds juice at one node: water [kg] with its enthalpy [J], and dissolved solids, which are not part of its mass
    /// [kg].
    pub fn drip(&mut self, node: usize, mass: f64, enthalpy: f64, solids: f64) {
        self.water.add(node, mass, enthalpy);
        self.fond.shed(node, solids);
        self.water_pace.stir();
    }

    /// Mass of all liquids and of solid butter [kg].
    pub fn total(&self) -> f64 {
        self.oil.total() + self.water.total() + self.butter.lump.as_ref().map_or(0.0, |l| l.mass)
    }
}
