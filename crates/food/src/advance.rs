//! Time integration of a piece of food: one tick with given surroundings.
//!
//! Time: conduction is explicit with as many sub-steps as the stability limit requires (one, as a rule); exchange
//! with the surroundings is implicit in the node's own temperature. Both keep every temperature within the range of
//! those it is coupled to, and both conserve energy.

pub mod saved;

use std::array::from_fn;

use saute_heat::vector::{dot, sub, unit};
use saute_heat::{BodyMesh, Conduction, Layers, SweptMesh};

use crate::body::patch::{Face, Patch};
use crate::change::browning::BROWNING_FROM;
use crate::change::changes::CHANGES_FROM;
use crate::model::FoodModel;
use crate::paper_2013::{self, Rules};
use crate::state::{FoodState, all_finite};
use crate::touch::Touch;
use crate::water::air_film::FreeAir;
use crate::water::films::Films;
use crate::water::juice::Runoff;
use crate::water::vapour::latent_heat;

/// Temperature above which a node is checked for boiling [K] (chosen: 1 K below the boiling point of water).
const NEARLY_BOILING: f64 = 372.15;
/// Ticks between two refreshes of properties, proteins, browning and juice [-] (chosen: half a second).
pub const REFRESH_TICKS: u64 = 5;
/// Ticks between two refreshes of the conductances [-] (chosen: one second; conductivity changes by less than 1 % in it,
/// except in a crust that is drying).
const CONDUCTION_TICKS: u64 = 2 * REFRESH_TICKS;
/// Ticks between two refreshes of the shape [-] (chosen: two seconds; lengths change by less than 0.1 % in it).
const SHAPE_TICKS: u64 = 20;
/// Largest number of steps in a tick [-] (chosen: only layers of a few nanometres reach it).
const MOST_SUBSTEPS: f64 = 4.0e9;
/// Number of nodes whose temperatures are found together [-] (chosen: their divisions overlap).
const TOGETHER: usize = 8;
/// Number of nodes that are checked for boiling together [-] (chosen: a block fits a few SIMD vectors).
const BLOCK: usize = 32;
/// Share of the stability limit that a step may use [-] (chosen: properties are up to half a second old).
const STABILITY_MARGIN: f64 = 0.8;

/// Surroundings of a piece during one tick: contacts and air.
#[derive(Clone, Copy, Debug)]
pub struct Surroundings<'a> {
    /// Contact of each patch, in the order of the patches; patches beyond its end have no contact.
    pub touch: &'a [Touch],
    /// Air zones; [`Patch::air`] is the index of the zone in front of a patch.
    pub air: &'a [FreeAir],
    /// Pressure of a press on the piece [Pa]; 0 without one.
    pub pressed: f64,
}

/// Heat and mass exchanged between a piece and its surroundings in one tick.
///
/// [`FoodSolver::contact_heat`] contains the heat from contacts.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Exchange {
    /// Heat lost to air and walls by convection and radiation [J].
    pub air: f64,
    /// Mass of evaporated water [kg].
    pub evaporated: f64,
    /// Enthalpy of the evaporated water above liquid water at 0 °C [J].
    pub evaporation: f64,
    /// Juice that ran off the piece.
    pub drip: Runoff,
    /// Fat that ran off the piece.
    pub rendered: Runoff,
}

impl Exchange {
    /// Returns true if all heat and mass is finite.
    fn is_finite(&self) -> bool {
        let Self { air, evaporated, evaporation, drip, rendered } = self;
        [air, evaporated, evaporation, &drip.mass, &drip.enthalpy, &rendered.mass, &rendered.enthalpy]
            .iter()
            .all(|v| v.is_finite())
    }
}

/// Time integrator of one piece, with cached properties and scratch space.
///
/// It caches the conductances of its model: start with a new one after [`FoodModel::halved`].
#[derive(Clone, Debug, Default)]
pub struct FoodSolver {
    /// Conduction layer by layer; none in a body without identical layers.
    layers: Option<Layers>,
    /// Conduction edge by edge, in a body without identical layers.
    conduction: Conduction,
    /// Conductivity across and along the fibres, times the stretch ratios [W/(m·K)].
    conductivity: [Vec<f64>; 2],
    /// Heat capacity of each node [J/K] and its reciprocal [K/J].
    capacity: Vec<f64>,
    per_capacity: Vec<f64>,
    power: Vec<f64>,
    /// Exchange of each patch with air, used while it has no contact.
    films: Films,
    hot: Vec<u32>,
    /// The state after the last tick, without a non-finite value.
    pub(crate) sound: Option<FoodState>,
    /// Heat gained by each patch from its contact in the last tick [J].
    pub contact_heat: Vec<f64>,
    /// Number of steps in the last tick [-].
    pub substeps: u32,
}

impl FoodSolver {
    /// Advances a piece by one tick of `dt` [s] and returns the exchanged heat and mass.
    ///
    /// After a non-finite value the piece returns to its state before the tick, and exchanges nothing in it. It no longer
    /// changes, and [`FoodState::healthy`] is false.
    pub fn advance(&mut self, model: &FoodModel, state: &mut FoodState, around: &Surroundings, dt: f64) -> Exchange {
        self.contact_heat.clear();
        self.contact_heat.resize(around.touch.len(), 0.0);
        if !state.healthy || !self.has_sound_state(state) {
            return Exchange::default();
        }
        let due = state.ticks.is_multiple_of(REFRESH_TICKS);
        let total = self.tick(model, state, around, dt);
        let is_finite = if due { state.is_finite() } else { state.has_finite_heat() };
        if !(is_finite && total.is_finite() && all_finite(&self.contact_heat)) {
            self.restore(state);
            return Exchange::default();
        }
        state.evaporated += total.evaporated;
        state.ticks += 1;
        if let Some(sound) = &mut self.sound {
            if due { sound.copy_from(state) } else { sound.copy_heat_from(state) }
        }
        total
    }

    /// Advances a piece by one tick without a check of its values.
    fn tick(&mut self, model: &FoodModel, state: &mut FoodState, around: &Surroundings, dt: f64) -> Exchange {
        let mut total = Exchange::default();
        let due = state.ticks.is_multiple_of(REFRESH_TICKS);
        if due && state.ticks > 0 {
            change(model, state, dt * REFRESH_TICKS as f64);
            total.drip = model.release_juice(state, around.pressed, dt * REFRESH_TICKS as f64);
            model.flatten(state, around.pressed, dt * REFRESH_TICKS as f64);
            total.rendered = model.release_fat(state, dt * REFRESH_TICKS as f64);
            if model.shape.contracts && state.ticks.is_multiple_of(SHAPE_TICKS) {
                model.shrink(state);
            }
        }
        // A new solver, or one for a piece that was cut, has no films yet.
        if due || self.films.count != model.shape.patches.len() {
            self.refresh(model, state, dt);
            self.films.refresh(model, state, around, &self.capacity);
            // Without finite temperatures the number of steps has no meaning.
            if !state.has_finite_heat() {
                return total;
            }
        }
        let step = dt / f64::from(self.substeps);
        self.films.prepare(around.touch, step);
        for _ in 0..self.substeps {
            self.step(model, state, around, step, &mut total);
        }
        total
    }

    /// Returns the heat capacity of a node [J/K], or none before the first tick.
    pub fn capacity(&self, node: usize) -> Option<f64> {
        self.capacity.get(node).copied()
    }

    /// Adds heat to a node between two ticks [J].
    pub fn give(&mut self, state: &mut FoodState, node: usize, heat: f64) {
        let Some(per_capacity) = self.per_capacity.get(node) else { return };
        // The other side has booked this heat: it stays if the next tick is undone.
        for state in self.sound.iter_mut().chain([state]) {
            state.enthalpy[node] += heat;
            state.temperature[node] += heat * per_capacity;
        }
    }

    /// Returns the number of steps that a tick of `dt` [s] takes in a state, without advancing it [-].
    pub fn steps_of_tick(model: &FoodModel, state: &FoodState, dt: f64) -> u32 {
        let mut solver = Self::default();
        solver.refresh(model, &mut state.clone(), dt);
        solver.substeps
    }

    /// Refreshes temperatures, capacities and the number of steps.
    fn refresh(&mut self, model: &FoodModel, state: &mut FoodState, dt: f64) {
        let n = state.temperature.len();
        for field in [&mut self.capacity, &mut self.per_capacity, &mut self.power] {
            field.resize(n, 0.0);
        }
        self.hot.clear();
        self.hot.reserve(n);
        self.refresh_temperatures(model, state);
        if state.ticks.is_multiple_of(CONDUCTION_TICKS) || self.conductivity[0].len() != n {
            self.refresh_conduction(model, state);
        }
        let stable = match &self.layers {
            Some(layers) => layers.stable_step(&self.capacity),
            None => self.conduction.stable_step(&self.capacity),
        };
        let limit = STABILITY_MARGIN * stable;
        self.substeps = libm::ceil(dt / limit).clamp(1.0, MOST_SUBSTEPS) as u32;
    }

    /// Refreshes temperatures and capacities from the enthalpies.
    fn refresh_temperatures(&mut self, model: &FoodModel, state: &mut FoodState) {
        let n = state.temperature.len();
        let together = n - n % TOGETHER;
        for first in (0..together).step_by(TOGETHER) {
            let nodes = first..first + TOGETHER;
            let masses = from_fn(|k| model.masses(state, first + k));
            let of = |field: &[f64]| -> [f64; TOGETHER] { from_fn(|k| field[first + k]) };
            let (enthalpy, guess) = (of(&state.enthalpy), of(&state.temperature));
            let (t, capacity) = model.properties.temperatures(&masses, &enthalpy, &guess);
            state.temperature[nodes.clone()].copy_from_slice(&t);
            self.capacity[nodes].copy_from_slice(&capacity);
        }
        for i in together..n {
            let masses = model.masses(state, i);
            (state.temperature[i], self.capacity[i]) =
                model.properties.temperature(&masses, state.enthalpy[i], state.temperature[i]);
        }
        self.per_capacity.iter_mut().zip(&self.capacity).for_each(|(per, capacity)| *per = 1.0 / capacity);
    }

    /// Refreshes the conductances.
    fn refresh_conduction(&mut self, model: &FoodModel, state: &FoodState) {
        let n = state.temperature.len();
        self.conductivity.iter_mut().for_each(|k| k.resize(n, 0.0));
        let driest = 1.0 - model.kinetics.water_holding.drop;
        let crust = model.description.crust.conductivity_w_mk;
        let (across, along) = model.description.anisotropy.as_ref().map_or((1.0, 1.0), |a| (a.across, a.along));
        let area = state.stretch.lateral * state.stretch.lateral;
        for i in 0..n {
            let wet = model.properties.conductivity(&model.masses(state, i), state.temperature[i]);
            let moist = (state.water[i] / (driest * model.tissue.initial_water[i])).min(1.0);
            let conductivity = crust + moist * (wet - crust);
            // Conductance scales with area over length: with the height across the fibres, with area over height along them.
            let axial = state.stretch.axial[i];
            self.conductivity[0][i] = across * conductivity * axial;
            self.conductivity[1][i] = along * conductivity * area / axial;
        }
        self.set_conductances(model);
    }

    /// Sets the conductances from the conductivities.
    fn set_conductances(&mut self, model: &FoodModel) {
        let [across, along] = &self.conductivity;
        if self.layers.is_none() {
            let layers = |mesh: &SweptMesh| Layers::of(&mesh.graph, mesh.nodes_per_level());
            self.layers = model.shape.mesh.swept().and_then(layers);
        }
        if let Some(layers) = &mut self.layers {
            layers.refresh(across, along);
            return;
        }
        if let BodyMesh::Cells(cells) = &model.shape.mesh {
            let fibres = model.description.mesh.as_ref().and_then(|m| m.fibres);
            let along = model.description.anisotropy.as_ref().map_or(1.0, |a| a.along / a.across);
            self.conduction.refresh_each(&cells.graph, |_, a, b| {
                let share = fibres.map_or(1.0 / 3.0, |f| aligned(f, cells.positions[a], cells.positions[b]));
                let factor = 1.0 + share * (along - 1.0);
                (factor * across[a], factor * across[b])
            });
            return;
        }
        self.conduction.refresh_each(model.shape.mesh.graph(), |_, a, b| {
            let k = if model.shape.mesh.is_along(a, b) { along } else { across };
            (k[a], k[b])
        });
    }

    /// Stores the first state of a piece if it is finite; else freezes the piece. Returns true if there is a sound state.
    fn has_sound_state(&mut self, state: &mut FoodState) -> bool {
        if self.sound.is_none() {
            state.healthy = state.is_finite();
            self.sound = state.healthy.then(|| state.clone());
        }
        state.healthy
    }

    /// Restores the state before the tick and freezes the piece.
    fn restore(&mut self, state: &mut FoodState) {
        if let Some(kept) = &self.sound {
            state.copy_from(kept);
        }
        state.healthy = false;
        self.contact_heat.fill(0.0);
    }

    /// One step: conduction, exchange with the surroundings, boiling; each conserves energy exactly.
    ///
    /// Conduction is explicit within its stability limit. Exchange is implicit in the node's own temperature and follows
    /// conduction, so that both balance in a steady state: T ← (C T + Δt (P + G T₀)) / (C + Δt G). Both obey the maximum
    /// principle.
    fn step(&mut self, model: &FoodModel, state: &mut FoodState, around: &Surroundings, dt: f64, total: &mut Exchange) {
        match &mut self.layers {
            Some(layers) => layers.power(&state.temperature, &mut self.power),
            None => {
                self.power.fill(0.0);
                self.conduction.add_power(model.shape.mesh.graph(), &state.temperature, &mut self.power);
            }
        }
        let fields = state.enthalpy.iter_mut().zip(&mut state.temperature);
        for ((h, t), (p, per_c)) in fields.zip(self.power.iter().zip(&self.per_capacity)) {
            let heat = p * dt;
            *h += heat;
            *t += heat * per_c;
        }
        self.films.exchange(state, around, dt, &mut self.contact_heat, total);
        self.boil(model, state, total);
    }

    /// Turns heat above the boiling point into vapour, node by node.
    ///
    /// The boiling point of a node rises as it dries (sorption isotherm). Newton's method solves for mass and temperature
    /// together: dm = C (T − T_b) / (L + C · |dT_b/dm|).
    fn boil(&mut self, model: &FoodModel, state: &mut FoodState, total: &mut Exchange) {
        let from = model.water.isotherm.lowest_boiling_point().max(NEARLY_BOILING);
        self.hot.clear();
        for (first, block) in (0u32..).step_by(BLOCK).zip(state.temperature.chunks(BLOCK)) {
            // Most blocks are far from boiling: without a branch at each node.
            if block.iter().fold(false, |hot, t| hot | (*t > from)) {
                let hot = (first..).zip(block).filter(|(_, t)| **t > from);
                self.hot.extend(hot.map(|(i, _)| i));
            }
        }
        let mut sums = *total;
        for &node in &self.hot {
            let i = node as usize;
            for _ in 0..4 {
                if state.water[i] <= 0.0 {
                    break;
                }
                let moisture = state.water[i] / model.tissue.lean_solids[i];
                let wet = model.water.isotherm.wet_boiling_point(moisture);
                let boiling = wet.unwrap_or_else(|| model.water.isotherm.boiling_point(moisture));
                let excess = state.temperature[i] - boiling;
                if excess <= 1e-3 {
                    break;
                }
                let capacity = self.capacity[i];
                let slope = if wet.is_some() { 0.0 } else { slope(model, i, moisture, boiling) };
                let latent = latent_heat(boiling);
                let mass = (capacity * excess / (latent + capacity * slope)).min(state.water[i]);
                let enthalpy = mass * (model.properties.water_enthalpy(boiling) + latent);
                state.water[i] -= mass;
                state.enthalpy[i] -= enthalpy;
                state.temperature[i] -= mass * latent / capacity;
                sums.evaporated += mass;
                sums.evaporation += enthalpy;
                // With a constant boiling point one iteration is exact.
                if slope == 0.0 {
                    break;
                }
            }
        }
        *total = sums;
    }
}

/// Squared cosine between the fibres and the way from one place to another [-].
fn aligned(fibres: [f64; 3], from: [f64; 3], to: [f64; 3]) -> f64 {
    let cosine = dot(unit(fibres), unit(sub(to, from)));
    cosine * cosine
}

/// Rise of a node's boiling point per lost mass of water, from its moisture [kg/kg] and its boiling point [K] [K/kg].
fn slope(model: &FoodModel, node: usize, moisture: f64, boiling: f64) -> f64 {
    let drier = 0.995 * moisture;
    (model.water.isotherm.boiling_point(drier) - boiling) / ((moisture - drier) * model.tissue.lean_solids[node])
}

/// Returns the area of a patch in the present, contracted shape [m²].
#[inline]
pub fn present_area(patch: &Patch, state: &FoodState) -> f64 {
    let lateral = state.stretch.lateral;
    let height = if patch.face == Face::Side { state.stretch.axial[patch.node as usize] } else { lateral };
    patch.area * lateral * height
}

/// Advances first-order changes, peak temperature, lethality and browning by `dt` [s].
fn change(model: &FoodModel, state: &mut FoodState, dt: f64) {
    state.peak.iter_mut().zip(&state.temperature).for_each(|(peak, t)| *peak = peak.max(*t));
    model.response.rates.advance(&mut state.changed, &state.temperature, dt);
    for i in 0..state.temperature.len() {
        let t = state.temperature[i];
        if t > CHANGES_FROM {
            state.lethality[i] += model.response.lethality.at(t) * dt;
        }
        if t > BROWNING_FROM {
            brown(model, state, i, dt);
        }
    }
}

/// Advances browning and charring of a node by `dt` [s], by the rules of the piece.
fn brown(model: &FoodModel, state: &mut FoodState, i: usize, dt: f64) {
    let t = state.temperature[i];
    if model.rules == Rules::Paper2013 {
        let lost = 1.0 - state.water[i] / model.tissue.initial_water[i];
        state.browning[i] = paper_2013::browning(state.browning[i], t, lost);
        return;
    }
    let activity = model.water.isotherm.activity(state.water[i] / model.tissue.lean_solids[i]);
    // What is over a groove neither browns nor chars: both are means over the whole face.
    let (open, before) = (state.open[i], state.crust(i));
    let (browning, charring) =
        model.response.browning.advance(before, t, activity, model.tissue.charring_solids(i), dt);
    (state.browning[i], state.charring[i]) = (open * browning, open * charring);
}
