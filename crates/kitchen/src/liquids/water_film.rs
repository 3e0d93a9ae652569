//! Water on the pan: juice, added water, water of butter. It forms puddles, flows, and boils by a boiling curve.

use saute_food::table::{Table, interpolate};
use saute_food::water::{latent_heat, saturation_density};
use saute_food::{FreeAir, ZERO_C, sourced_table};
use serde::{Deserialize, Serialize};

use crate::liquids::film_flow::{FilmFlow, Manner, Run, Sweep};
use crate::liquids::fond::Fond;
use crate::pan::bed::Bed;
use crate::{celsius, kelvin};

sourced_table! {
    /// Water that is in the pan.
    PuddleData {
        /// Depth to which a puddle spreads [mm].
        #[schemars(range(min = 1e-6, max = 100.0), example = 0.7)]
        depth_mm: f64,
        /// What stays on a tilted pan in drops, spread out [mm].
        #[schemars(range(min = 0.0, max = 100.0), example = 0.02)]
        clinging_mm: f64,
        /// Temperatures of the pan of the boiling curve, ascending [°C].
        #[schemars(inner(range(min = -100.0, max = 1000.0)), extend("examples" = [[20.0, 120.0, 400.0]]))]
        base_c: Vec<f64>,
        /// Conductance from pan to water at those [W/(m²·K)].
        #[schemars(inner(range(min = 0.0, max = 1e6)), extend("examples" = [[1500.0, 7500.0, 230.0]]))]
        conductance_w_m2k: Vec<f64>,
        /// Temperatures at which the viscosity is given, ascending [°C].
        #[schemars(inner(range(min = -50.0, max = 400.0)), extend("examples" = [[0.0, 100.0]]))]
        viscosity_c: Vec<f64>,
        /// Dynamic viscosity of water at those [mPa·s].
        #[schemars(inner(range(min = 1e-3, max = 1e6)), extend("examples" = [[1.79, 0.282]]))]
        viscosity_mpa_s: Vec<f64>,
    }
}

/// Specific heat of liquid water [J/(kg·K)] (standard tables).
pub const WATER_SPECIFIC_HEAT: f64 = 4190.0;
/// Density of liquid water [kg/m³] (standard tables: 960 to 1000).
pub const WATER_DENSITY: f64 = 1000.0;
/// Coverage of a node on a hot pan below which its water boils off at once [-] (chosen: it cools the metal there by a
/// thousandth of a kelvin).
const LEAST_COVERAGE: f64 = 1e-5;

/// Specific enthalpy of vapour above liquid water at 0 °C [J/kg].
pub fn vapour_enthalpy(temperature: f64) -> f64 {
    WATER_SPECIFIC_HEAT * (temperature - ZERO_C) + latent_heat(temperature)
}

/// Immutable model of water on a pan.
#[derive(Clone, Debug)]
pub struct WaterModel {
    depth: f64,
    clinging: f64,
    conductance: Table,
    fluidity: Table,
    vapour: Table,
}

/// Water in the pan.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct WaterFilm {
    /// Mass at each node [kg].
    pub mass: Vec<f64>,
    /// Enthalpy at each node above liquid water at 0 °C [J].
    pub enthalpy: Vec<f64>,
}

/// Vapour with its enthalpy.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vapour {
    /// Mass [kg].
    pub mass: f64,
    /// Enthalpy above liquid water at 0 °C [J].
    pub enthalpy: f64,
}

impl WaterModel {
    /// Tabulates the boiling curve, viscosity and vapour density.
    pub fn new(data: &PuddleData) -> Self {
        let conductance = |t: f64| interpolate(&data.base_c, &data.conductance_w_m2k, celsius(t));
        let fluidity =
            |t: f64| WATER_DENSITY / (1e-3 * interpolate(&data.viscosity_c, &data.viscosity_mpa_s, celsius(t)));
        Self {
            depth: 1e-3 * data.depth_mm,
            clinging: 1e-3 * data.clinging_mm,
            conductance: Table::new(kelvin(0.0), kelvin(450.0), 1.0, conductance),
            fluidity: Table::new(kelvin(0.0), kelvin(100.0), 1.0, fluidity),
            vapour: Table::new(kelvin(0.0), kelvin(100.0), 0.5, saturation_density),
        }
    }

    /// Density of saturated vapour, up to 100 °C [kg/m³].
    pub fn saturated(&self, temperature: f64) -> f64 {
        self.vapour.at(temperature)
    }

    /// Depth to which a puddle spreads [m].
    pub fn puddle_depth(&self) -> f64 {
        self.depth
    }

    /// Share of an area covered by a mass of water [-].
    pub fn coverage(&self, mass: f64, area: f64) -> f64 {
        (mass / (WATER_DENSITY * self.depth * area)).min(1.0)
    }
}

impl WaterFilm {
    /// Takes all water away.
    pub(crate) fn clear(&mut self) {
        self.mass.iter_mut().chain(&mut self.enthalpy).for_each(|amount| *amount = 0.0);
    }

    /// An empty film on a number of nodes.
    pub fn none(nodes: usize) -> Self {
        Self { mass: vec![0.0; nodes], enthalpy: vec![0.0; nodes] }
    }

    /// Mass of all water [kg].
    pub fn total(&self) -> f64 {
        self.mass.iter().sum()
    }

    /// Enthalpy of all water [J].
    pub fn stored(&self) -> f64 {
        self.enthalpy.iter().sum()
    }

    /// Adds water [kg] with its enthalpy [J].
    pub fn add(&mut self, node: usize, mass: f64, enthalpy: f64) {
        self.mass[node] += mass;
        self.enthalpy[node] += enthalpy;
    }

    /// Temperature at a wet node [K].
    pub fn temperature(&self, node: usize) -> f64 {
        ZERO_C + self.enthalpy[node] / (self.mass[node] * WATER_SPECIFIC_HEAT)
    }

    /// Heats the water at a wet node from the pan at `base` [K] for `dt` [s]; enthalpy above 100 °C evaporates water.
    /// Returns the heat [J] and the vapour.
    pub fn heat(&mut self, model: &WaterModel, node: usize, area: f64, base: f64, dt: f64) -> (f64, Vapour) {
        let (mass, latent) = (self.mass[node], latent_heat(kelvin(100.0)));
        let boiling = WATER_SPECIFIC_HEAT * 100.0;
        let to_vapour = mass * (boiling + latent) - self.enthalpy[node];
        let coverage = model.coverage(mass, area);
        let conductance = model.conductance.at(base) * coverage * area;
        let heat = if base > kelvin(101.0) && coverage < LEAST_COVERAGE {
            to_vapour
        } else {
            (conductance * (base - self.temperature(node)) * dt).min(to_vapour)
        };
        self.enthalpy[node] += heat;
        let excess = self.enthalpy[node] - mass * boiling;
        if excess <= 0.0 {
            return (heat, Vapour::default());
        }
        let gone = excess / latent;
        let all = gone >= mass * (1.0 - 1e-12);
        let vapour = if all {
            Vapour { mass, enthalpy: self.enthalpy[node] }
        } else {
            Vapour { mass: gone, enthalpy: gone * (boiling + latent) }
        };
        self.mass[node] = if all { 0.0 } else { mass - gone };
        self.enthalpy[node] = if all { 0.0 } else { self.enthalpy[node] - vapour.enthalpy };
        (heat, vapour)
    }

    /// Evaporates water at a wet node into the air for `dt` [s]; `bare` is the share of the node not under food [-].
    pub fn evaporate(
        &mut self,
        model: &WaterModel,
        node: usize,
        area: f64,
        bare: f64,
        air: &FreeAir,
        dt: f64,
    ) -> Vapour {
        let mass = self.mass[node];
        let t = self.temperature(node);
        let excess = model.saturated(t) - air.vapour_density;
        let open = bare * model.coverage(mass, area) * area;
        let gone = (air.mass_transfer * open * excess * dt).clamp(0.0, 0.2 * mass);
        let enthalpy = (gone * vapour_enthalpy(t)).min(self.enthalpy[node].max(0.0));
        self.mass[node] -= gone;
        self.enthalpy[node] -= enthalpy;
        Vapour { mass: gone, enthalpy }
    }

    /// Advances the flow of water and its dissolved solids by `dt` [s] under gravity in the pan's frame [m/s²].
    pub fn run(
        &mut self,
        flow: &mut FilmFlow,
        fond: &mut Fond,
        (model, bed): (&WaterModel, &Bed),
        gravity: [f64; 3],
        dt: f64,
    ) -> Run {
        let mut run = Run::default();
        if self.mass.iter().all(|m| *m <= 0.0) {
            return run;
        }
        let mean = ZERO_C + self.stored() / (self.total() * WATER_SPECIFIC_HEAT);
        let manner = Manner { density: WATER_DENSITY, puddle: model.depth, clinging: model.clinging };
        flow.fluidity.clear();
        flow.fluidity.resize(self.mass.len(), model.fluidity.at(mean));
        flow.lean(bed, gravity);
        for sweep in Sweep::BOTH {
            run.moved = run.moved.max(flow.sweep(bed, &manner, &self.mass, sweep, 0.5 * dt));
            run.spilled += flow.carry(bed, &mut self.mass);
            run.spilled_heat += flow.carry(bed, &mut self.enthalpy);
            fond.carry(flow, bed);
        }
        run
    }
}
