//! Fond: dried juice solids on the hot pan. They brown, then char, and dissolve again in water.
//!
//! A part of the solids in juice sticks to the metal where a wet face of food boils dry. Dripping juice carries dissolved
//! solids, which flow with the water. Solids above saturation dry on; water dissolves them again with first-order
//! kinetics, ds/dt = −k(T_w) c s, with the share c of the place under water. Solids carry no heat and are not part of the
//! liquids' masses.

use saute_food::change::changes::arrhenius;
use saute_food::sourced_table;
use saute_food::table::Table;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::kelvin;
use crate::liquids::film_flow::FilmFlow;
use crate::liquids::oil::SolidsChange;
use crate::liquids::solids_rates::SolidsRates;
use crate::liquids::water_film::{WaterFilm, WaterModel};
use crate::pan::bed::Bed;

sourced_table! {
    /// Juice that food sheds.
    JuiceData {
        /// Dissolved solids in it [-].
        #[schemars(range(min = 0.0, max = 0.5), example = 0.05)]
        solids: f64,
        /// Share of the solids that stay on the metal where a wet face boils dry against it [-].
        #[schemars(range(min = 0.0, max = 1.0), example = 0.5)]
        sticking: f64,
    }
}

sourced_table! {
    /// How much it takes to hide the pan.
    CoverData {
        /// Solids that hide the metal [kg/m²].
        #[schemars(range(min = 1e-5, max = 10.0), example = 0.006)]
        full_kg_m2: f64,
    }
}

sourced_table! {
    /// How dried solids dissolve.
    DissolvingData {
        /// Activation energy [kJ/mol].
        #[schemars(range(min = 1.0, max = 1000.0), example = 25.0)]
        activation_energy_kj_mol: f64,
        /// Temperature of the water at which the rate is given [°C].
        #[schemars(range(min = 0.0, max = 150.0), example = 100.0)]
        anchor_c: f64,
        /// Rate there [1/s].
        #[schemars(range(min = 0.0, max = 100.0), example = 0.05)]
        anchor_rate_per_s: f64,
        /// Most solids in water [kg/kg].
        #[schemars(range(min = 1e-3, max = 10.0), example = 0.6)]
        saturation: f64,
    }
}

/// Fond as its file describes it.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "saute fond")]
pub struct FondData {
    /// Where it comes from.
    pub juice: JuiceData,
    /// What it looks like.
    pub cover: CoverData,
    /// How water takes it off.
    pub dissolving: DissolvingData,
    /// How it browns.
    pub browning: SolidsChange,
    /// How what is browned chars.
    pub charring: SolidsChange,
}

/// Immutable model of fond.
#[derive(Clone, Debug)]
pub struct FondModel {
    /// Dissolved solids in juice [-].
    pub juice_solids: f64,
    /// Solids left on the metal per mass of steam from a wet face [kg/kg].
    pub left_by_steam: f64,
    full: f64,
    saturation: f64,
    dissolving: Table,
    rates: SolidsRates,
}

/// Solids at every node; browning and charring are advected as mass × extent.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Solids {
    /// Mass at each node.
    pub mass: Vec<f64>,
    /// Mass × browning (0–1) at each node.
    pub browned: Vec<f64>,
    /// Mass × charring (0–1) at each node.
    pub charred: Vec<f64>,
}

/// Dried and dissolved solids.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Fond {
    /// Dried solids per area [kg/m²].
    pub dried: Solids,
    /// Solids dissolved in water [kg].
    pub dissolved: Solids,
    /// Mass spilled over the rim with water [kg].
    pub spilled: f64,
    /// Total mass from food so far [kg].
    pub brought: f64,
    /// Mass over a full cover (at most 1) × browning at each node, for drawing [-].
    pub share: Vec<f64>,
}

/// Fond at a place of the pan.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FondReading {
    /// Dried solids [kg/m²].
    pub mass_kg_m2: f64,
    /// Browning, 0–1 [-].
    pub browning: f64,
    /// Charring, 0–1 [-].
    pub charring: f64,
    /// Mass over a full cover (at most 1) × browning, for drawing [-].
    pub share: f64,
}

/// Surface below the fond and water above it.
#[derive(Clone, Copy, Debug)]
pub struct FondBed<'a> {
    /// The pan's surface.
    pub bed: &'a Bed,
    /// Water over it.
    pub water: &'a WaterFilm,
    /// Model of the water.
    pub water_model: &'a WaterModel,
    /// Metal under it [K].
    pub metal: &'a [f64],
}

impl FondModel {
    /// Tabulates the rates.
    pub fn new(data: &FondData) -> Self {
        let d = &data.dissolving;
        let rate = arrhenius(d.activation_energy_kj_mol, d.anchor_c, d.anchor_rate_per_s);
        Self {
            juice_solids: data.juice.solids,
            left_by_steam: data.juice.solids * data.juice.sticking,
            full: data.cover.full_kg_m2,
            saturation: d.saturation,
            dissolving: Table::new(kelvin(0.0), kelvin(100.0), 1.0, rate),
            rates: SolidsRates::new(&data.browning, &data.charring),
        }
    }
}

impl Solids {
    fn none(nodes: usize) -> Self {
        Self { mass: vec![0.0; nodes], browned: vec![0.0; nodes], charred: vec![0.0; nodes] }
    }

    fn parts(&mut self) -> [&mut Vec<f64>; 3] {
        [&mut self.mass, &mut self.browned, &mut self.charred]
    }

    /// Moves a share of the solids at a node to `to`; `unit` converts between the two units.
    fn give(&mut self, node: usize, share: f64, to: &mut Self, unit: f64) {
        for (from, to) in self.parts().into_iter().zip(to.parts()) {
            let given = share * from[node];
            from[node] -= given;
            to[node] += given * unit;
        }
    }
}

impl Fond {
    /// Wipes off what is dissolved, and what is dried but for a share that sticks [-].
    pub(crate) fn wipe(&mut self, stuck: f64, bed: &Bed) {
        let dried = self.dried.mass.iter().zip(&bed.areas).map(|(mass, area)| mass * area).sum::<f64>();
        self.spilled += (1.0 - stuck) * dried + self.dissolved.mass.iter().sum::<f64>();
        let kept = [(&mut self.dried, stuck), (&mut self.dissolved, 0.0)];
        for (solids, share) in kept {
            let Solids { mass, browned, charred } = solids;
            mass.iter_mut().chain(browned).chain(charred).for_each(|amount| *amount *= share);
        }
    }

    /// No solids on a number of nodes.
    pub fn none(nodes: usize) -> Self {
        let none = || Solids::none(nodes);
        Self { dried: none(), dissolved: none(), spilled: 0.0, brought: 0.0, share: vec![0.0; nodes] }
    }

    /// Adds fresh dissolved solids at a node [kg].
    pub fn shed(&mut self, node: usize, mass: f64) {
        self.dissolved.mass[node] += mass;
        self.brought += mass;
    }

    /// Adds solids that stick to the metal under a wet face [kg].
    pub fn stick(&mut self, bed: &Bed, node: usize, mass: f64) {
        self.dried.mass[node] += mass * bed.per_area[node];
        self.brought += mass;
    }

    /// Advects dissolved solids with the last sweep of the water.
    pub fn carry(&mut self, flow: &FilmFlow, bed: &Bed) {
        self.spilled += flow.carry(bed, &mut self.dissolved.mass);
        flow.carry(bed, &mut self.dissolved.browned);
        flow.carry(bed, &mut self.dissolved.charred);
    }

    /// Mass of dried solids, and its browned and charred parts [kg].
    pub fn dried_kg(&self, bed: &Bed) -> [f64; 3] {
        let sum = |field: &Vec<f64>| field.iter().zip(&bed.areas).map(|(m, a)| m * a).sum();
        [sum(&self.dried.mass), sum(&self.dried.browned), sum(&self.dried.charred)]
    }

    /// Mass of dissolved solids [kg].
    pub fn dissolved_kg(&self) -> f64 {
        self.dissolved.mass.iter().sum()
    }

    /// Advances drying, dissolution, browning and charring by `dt` [s].
    pub fn advance(&mut self, model: &FondModel, on: &FondBed, dt: f64) {
        for node in 0..self.share.len() {
            if self.dissolved.mass[node] > 0.0 || self.dried.mass[node] > 0.0 {
                self.pass(model, on, node, dt);
                self.brown(model, on, node, dt);
            }
        }
    }

    /// Dries solids above saturation, or dissolves dried solids.
    fn pass(&mut self, model: &FondModel, on: &FondBed, node: usize, dt: f64) {
        let (water, area) = (on.water.mass[node], on.bed.areas[node]);
        let held = self.dissolved.mass[node];
        let room = model.saturation * water - held;
        if room < 0.0 {
            self.dissolved.give(node, -room / held, &mut self.dried, on.bed.per_area[node]);
        } else if self.dried.mass[node] > 0.0 && water > 0.0 {
            let rate = model.dissolving.at(on.water.temperature(node)) * on.water_model.coverage(water, area);
            let loose = 1.0 - 1.0 / (1.0 + rate * dt);
            let share = loose.min(room / (self.dried.mass[node] * area));
            self.dried.give(node, share, &mut self.dissolved, area);
        }
    }

    /// dB/dt = k_B (1 − B), dC/dt = k_C B (1 − C), implicit: neither leaves 0–1.
    fn brown(&mut self, model: &FondModel, on: &FondBed, node: usize, dt: f64) {
        let mass = self.dried.mass[node];
        if mass <= 0.0 {
            self.share[node] = 0.0;
            return;
        }
        let wet = on.water_model.coverage(on.water.mass[node], on.bed.areas[node]);
        let [brown, char] = model.rates.at(on.metal[node], wet);
        let (browned, charred) = (&mut self.dried.browned[node], &mut self.dried.charred[node]);
        *browned = mass - (mass - *browned) / (1.0 + brown * dt);
        *charred = mass - (mass - *charred) / (1.0 + char * *browned / mass * dt);
        self.share[node] = (mass / model.full).min(1.0) * *browned / mass;
    }
}
