//! Fond: what juice leaves on the hot pan when it dries. It browns, then chars, and dissolves in water that comes later.
//!
//! Where a wet face of food boils dry against the metal, a part of its juice's solids stays there. Juice that runs off
//! brings them dissolved: they run with the water and stay behind as it boils off. What the water left cannot hold dries on; water dissolves it again with first order: ds/dt = −k(T_w) c s with the share c of the place under water.
//! Solids carry no heat and are no part of the liquids' masses.

use saute_food::changes::arrhenius;
use saute_food::sourced_table;
use saute_food::table::Table;
use saute_heat::Located;
use serde::Deserialize;

use crate::kelvin;
use crate::liquids::film_flow::FilmFlow;
use crate::liquids::oil::SolidsChange;
use crate::liquids::solids_rates::SolidsRates;
use crate::liquids::water_film::{WaterFilm, WaterModel};
use crate::pan::bed::Bed;
use crate::pan::pan_model::PanState;

sourced_table! {
    /// Juice that food sheds.
    JuiceData {
        /// Dissolved solids in it [-].
        solids: f64,
        /// Share of the solids that stay on the metal where a wet face boils dry against it [-].
        sticking: f64,
    }
}

sourced_table! {
    /// How much it takes to hide the pan.
    CoverData {
        /// Solids that hide the metal [kg/m²].
        full_kg_m2: f64,
    }
}

sourced_table! {
    /// How dried solids dissolve.
    DissolvingData {
        /// Activation energy [kJ/mol].
        activation_energy_kj_mol: f64,
        /// Temperature of the water at which the rate is given [°C].
        anchor_c: f64,
        /// Rate there [1/s].
        anchor_rate_per_s: f64,
        /// Most solids in water [kg/kg].
        saturation: f64,
    }
}

/// Fond as its file describes it.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
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

/// What never changes about fond.
#[derive(Clone, Debug)]
pub struct FondModel {
    /// Dissolved solids in juice [-].
    pub juice_solids: f64,
    /// Solids that stay on the metal for what boils off a wet face against it [kg/kg].
    pub left_by_steam: f64,
    full: f64,
    saturation: f64,
    dissolving: Table,
    rates: SolidsRates,
}

/// Solids at every node; how browned and charred they are goes with them as mass × extent.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Solids {
    /// Mass at each node.
    pub mass: Vec<f64>,
    /// Mass × browning (0–1) at each node.
    pub browned: Vec<f64>,
    /// Mass × charring (0–1) at each node.
    pub charred: Vec<f64>,
}

/// Fond, and what of it is dissolved in the pan's water.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Fond {
    /// Dried on [kg/m²].
    pub dried: Solids,
    /// Dissolved in the water [kg].
    pub dissolved: Solids,
    /// What ran over the rim with water [kg].
    pub spilled: f64,
    /// All that food has brought so far [kg].
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

/// What fond lies on and under.
#[derive(Clone, Copy, Debug)]
pub struct FondBed<'a> {
    /// The pan's surface.
    pub bed: &'a Bed,
    /// Water over it.
    pub water: &'a WaterFilm,
    /// How that covers the pan.
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

    /// Gives a share of what is at a node to others there, whose unit is so many of its own.
    fn give(&mut self, node: usize, share: f64, to: &mut Self, unit: f64) {
        for (from, to) in self.parts().into_iter().zip(to.parts()) {
            let given = share * from[node];
            from[node] -= given;
            to[node] += given * unit;
        }
    }
}

impl Fond {
    /// None on so many nodes.
    pub fn none(nodes: usize) -> Self {
        let none = || Solids::none(nodes);
        Self { dried: none(), dissolved: none(), spilled: 0.0, brought: 0.0, share: vec![0.0; nodes] }
    }

    /// Fresh dissolved solids come to a node [kg].
    pub fn shed(&mut self, node: usize, mass: f64) {
        self.dissolved.mass[node] += mass;
        self.brought += mass;
    }

    /// Solids stay on the metal where a wet face boils dry against it [kg].
    pub fn stick(&mut self, bed: &Bed, node: usize, mass: f64) {
        self.dried.mass[node] += mass * bed.per_area[node];
        self.brought += mass;
    }

    /// Dissolved solids run with the water as in its last sweep.
    pub fn carry(&mut self, flow: &FilmFlow, bed: &Bed) {
        self.spilled += flow.carry(bed, &mut self.dissolved.mass);
        flow.carry(bed, &mut self.dissolved.browned);
        flow.carry(bed, &mut self.dissolved.charred);
    }

    /// All dried solids, then those that are browned and charred [kg].
    pub fn dried_kg(&self, bed: &Bed) -> [f64; 3] {
        let sum = |field: &Vec<f64>| field.iter().zip(&bed.areas).map(|(m, a)| m * a).sum();
        [sum(&self.dried.mass), sum(&self.dried.browned), sum(&self.dried.charred)]
    }

    /// All dissolved solids [kg].
    pub fn dissolved_kg(&self) -> f64 {
        self.dissolved.mass.iter().sum()
    }

    /// Dries, dissolves, browns and chars for `dt` [s].
    pub fn advance(&mut self, model: &FondModel, on: &FondBed, dt: f64) {
        for node in 0..self.share.len() {
            if self.dissolved.mass[node] > 0.0 || self.dried.mass[node] > 0.0 {
                self.pass(model, on, node, dt);
                self.brown(model, on, node, dt);
            }
        }
    }

    /// What water cannot hold dries on; what it can it dissolves.
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

impl PanState {
    /// What juice has left at a place on the pan's mesh.
    pub fn fond(&self, at: &Located) -> FondReading {
        let fond = &self.liquids.fond;
        let mean = |field: &[f64]| (0..3).map(|k| at.weights[k] * field[at.nodes[k] as usize]).sum::<f64>();
        let mass = mean(&fond.dried.mass);
        let extent = |field: &[f64]| if mass > 0.0 { mean(field) / mass } else { 0.0 };
        FondReading {
            mass_kg_m2: mass,
            browning: extent(&fond.dried.browned),
            charring: extent(&fond.dried.charred),
            share: mean(&fond.share),
        }
    }
}
