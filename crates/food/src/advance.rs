//! One tick of a piece of food between given surroundings.

use saute_heat::{Conduction, Layers};

use crate::air_film::FreeAir;
use crate::browning::BROWNING_FROM;
use crate::changes::CHANGES_FROM;
use crate::films::Films;
use crate::juice::Runoff;
use crate::model::FoodModel;
use crate::paper_2013::{self, Rules};
use crate::patch::{Face, Patch};
use crate::state::FoodState;
use crate::water::latent_heat;

/// Nodes above this may boil [K].
const NEARLY_BOILING: f64 = 372.15;
/// Ticks between two refreshes of properties, proteins, browning and juice (chosen: half a second).
pub const REFRESH_TICKS: u64 = 5;
/// Ticks between two refreshes of the conductances (chosen: a second, in which conductivity changes by less than a percent
/// but in a crust that is just drying).
const CONDUCTION_TICKS: u64 = 2 * REFRESH_TICKS;
/// Ticks between two refreshes of the shape (chosen: two seconds, in which it changes by less than a thousandth).
const SHAPE_TICKS: u64 = 20;
/// Most steps a tick is divided into (chosen: reached by layers of a few nanometres).
const MOST_SUBSTEPS: f64 = 4.0e9;
/// Nodes that are looked at together for boiling (chosen).
const BLOCK: usize = 32;
/// Share of the stability limit that a step may use: properties are up to half a second old [-].
const STABILITY_MARGIN: f64 = 0.8;

/// What a patch touches.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Touch {
    /// Contact conductance [W/(m²·K)]; 0 where the patch is free.
    pub conductance: f64,
    /// Temperature of what it touches [K].
    pub temperature: f64,
}

impl Touch {
    /// A patch that is closed to the air by something that passes no heat here: what passes is reckoned elsewhere.
    pub const CLOSED: Self = Self { conductance: f64::MIN_POSITIVE, temperature: 0.0 };
}

/// Everything around a piece during one tick.
#[derive(Clone, Copy, Debug)]
pub struct Surroundings<'a> {
    /// What the patches touch, in their order; patches beyond its end are free.
    pub touch: &'a [Touch],
    /// Airs before free patches; each patch names its own.
    pub air: &'a [FreeAir],
}

/// What passed between a piece and its surroundings in one tick; heat taken from contacts is in
/// [`FoodSolver::contact_heat`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Exchange {
    /// Heat given to air and walls [J].
    pub air: f64,
    /// Vapour given off [kg].
    pub evaporated: f64,
    /// Enthalpy of that vapour above liquid water at 0 °C [J].
    pub evaporation: f64,
    /// Juice that ran off.
    pub drip: Runoff,
    /// Fat that ran off.
    pub rendered: Runoff,
}

/// Scratch space and cached properties of one piece.
#[derive(Clone, Debug, Default)]
pub struct FoodSolver {
    /// Conduction layer by layer, where the body is made of like layers.
    layers: Option<Layers>,
    /// Conduction edge by edge, where it is not.
    conduction: Conduction,
    /// Conductivity across and along the fibres times the stretches [W/(m·K)].
    conductivity: [Vec<f64>; 2],
    /// Heat capacity [J/K] and one over it.
    capacity: Vec<f64>,
    per_capacity: Vec<f64>,
    power: Vec<f64>,
    /// Exchange of each patch with air, while it is free.
    films: Films,
    hot: Vec<u32>,
    /// The last state in which everything was finite.
    sound: Option<FoodState>,
    /// Heat taken from what each patch touches in the last tick [J].
    pub contact_heat: Vec<f64>,
    /// Steps into which the last tick was divided.
    pub substeps: u32,
}

impl FoodSolver {
    /// Moves a piece through one tick of `dt` [s].
    ///
    /// A piece that becomes non-finite goes back to its last sound state (at most [`REFRESH_TICKS`] old), stops
    /// changing and says so by [`FoodState::healthy`].
    pub fn advance(&mut self, model: &FoodModel, state: &mut FoodState, around: &Surroundings, dt: f64) -> Exchange {
        let mut total = Exchange::default();
        self.contact_heat.clear();
        self.contact_heat.resize(around.touch.len(), 0.0);
        if !state.healthy {
            return total;
        }
        let due = state.ticks.is_multiple_of(REFRESH_TICKS);
        if due && state.ticks > 0 {
            change(model, state, dt * REFRESH_TICKS as f64);
            total.drip = model.release_juice(state, dt * REFRESH_TICKS as f64);
            total.rendered = model.release_fat(state, dt * REFRESH_TICKS as f64);
            if model.contracts && state.ticks.is_multiple_of(SHAPE_TICKS) {
                model.shrink(state);
            }
        }
        // A solver that has seen nothing of the piece as it is now looks at once.
        if due || self.films.count != model.patches.len() {
            self.refresh(model, state, dt);
            self.films.refresh(model, state, around, &self.capacity);
            if !self.keep_or_restore(state) {
                return Exchange::default();
            }
        }
        let step = dt / f64::from(self.substeps);
        self.films.prepare(step);
        for _ in 0..self.substeps {
            self.step(model, state, around, step, &mut total);
        }
        if !(total.air.is_finite() && total.evaporation.is_finite()) {
            self.restore(state);
            return Exchange::default();
        }
        state.evaporated += total.evaporated;
        state.ticks += 1;
        total
    }

    /// Heat capacity of a node [J/K]; none before the first tick.
    pub fn capacity(&self, node: usize) -> Option<f64> {
        self.capacity.get(node).copied()
    }

    /// Gives a node heat from outside of any tick [J].
    pub fn give(&self, state: &mut FoodState, node: usize, heat: f64) {
        if let Some(per_capacity) = self.per_capacity.get(node) {
            state.enthalpy[node] += heat;
            state.temperature[node] += heat * per_capacity;
        }
    }

    /// Brings temperatures, capacities and the number of steps up to date.
    fn refresh(&mut self, model: &FoodModel, state: &mut FoodState, dt: f64) {
        let n = state.temperature.len();
        for field in [&mut self.capacity, &mut self.per_capacity, &mut self.power] {
            field.resize(n, 0.0);
        }
        self.hot.clear();
        self.hot.reserve(n);
        for i in 0..n {
            let masses = model.masses(state, i);
            let (t, capacity) = model.properties.temperature(&masses, state.enthalpy[i], state.temperature[i]);
            state.temperature[i] = t;
            self.capacity[i] = capacity;
            self.per_capacity[i] = 1.0 / capacity;
        }
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

    /// Brings conductances up to date.
    fn refresh_conduction(&mut self, model: &FoodModel, state: &FoodState) {
        let n = state.temperature.len();
        self.conductivity.iter_mut().for_each(|k| k.resize(n, 0.0));
        let driest = 1.0 - model.kinetics.water_holding.drop;
        let crust = model.description.crust.conductivity_w_mk;
        let across = model.description.anisotropy.as_ref().map_or(1.0, |a| a.across);
        let area = state.stretch.lateral * state.stretch.lateral;
        for i in 0..n {
            let wet = model.properties.conductivity(&model.masses(state, i), state.temperature[i]);
            let moist = (state.water[i] / (driest * model.initial_water[i])).min(1.0);
            let conductivity = crust + moist * (wet - crust);
            // Area over length: height across the fibres, area over height along them.
            let axial = state.stretch.axial[i];
            self.conductivity[0][i] = across * conductivity * axial;
            self.conductivity[1][i] = conductivity * area / axial;
        }
        let [across, along] = &self.conductivity;
        if self.layers.is_none() {
            self.layers = Layers::of(&model.mesh.graph, model.mesh.nodes_per_level());
        }
        if let Some(layers) = &mut self.layers {
            layers.refresh(across, along);
            return;
        }
        self.conduction.refresh_each(&model.mesh.graph, |_, a, b| {
            let k = if model.mesh.is_along(a, b) { along } else { across };
            (k[a], k[b])
        });
    }

    /// Remembers a sound state; puts the remembered one in place of an unsound one. Returns whether all is well.
    fn keep_or_restore(&mut self, state: &mut FoodState) -> bool {
        // Without a branch for each node.
        let finite = |field: &[f64]| field.iter().fold(true, |all, v| all & v.is_finite());
        let sound = finite(&state.temperature) && finite(&state.water);
        match &mut self.sound {
            Some(kept) if sound => kept.copy_from(state),
            None if sound => self.sound = Some(state.clone()),
            _ => self.restore(state),
        }
        sound
    }

    fn restore(&mut self, state: &mut FoodState) {
        if let Some(kept) = &self.sound {
            state.copy_from(kept);
        }
        state.healthy = false;
        self.contact_heat.fill(0.0);
    }

    /// One step: conduction, exchange with the surroundings, boiling, each exact about energy.
    ///
    /// Conduction is explicit within its stability limit; exchange is implicit in the node's own temperature and comes
    /// after conduction, so that both balance in a steady state: T ← (C T + Δt (P + G T₀)) / (C + Δt G). Neither
    /// leaves the range of the temperatures it couples.
    fn step(&mut self, model: &FoodModel, state: &mut FoodState, around: &Surroundings, dt: f64, total: &mut Exchange) {
        match &mut self.layers {
            Some(layers) => layers.power(&state.temperature, &mut self.power),
            None => {
                self.power.fill(0.0);
                self.conduction.add_power(&model.mesh.graph, &state.temperature, &mut self.power);
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
    /// As a node dries its boiling point rises (isotherm), so mass and temperature are found together by Newton's
    /// rule: dm = C (T − T_b) / (L + C · |dT_b/dm|).
    fn boil(&mut self, model: &FoodModel, state: &mut FoodState, total: &mut Exchange) {
        let from = model.isotherm.lowest_boiling_point().max(NEARLY_BOILING);
        self.hot.clear();
        for (first, block) in (0u32..).step_by(BLOCK).zip(state.temperature.chunks(BLOCK)) {
            // Most blocks are far from boiling: without a branch for each node.
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
                let moisture = state.water[i] / model.lean_solids[i];
                let wet = model.isotherm.wet_boiling_point(moisture);
                let boiling = wet.unwrap_or_else(|| model.isotherm.boiling_point(moisture));
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
                // Where the boiling point stays, one round finds it.
                if slope == 0.0 {
                    break;
                }
            }
        }
        *total = sums;
    }
}

/// How quickly a node's boiling point rises as it dries, from its moisture and its boiling point now [K/kg].
fn slope(model: &FoodModel, node: usize, moisture: f64, boiling: f64) -> f64 {
    let drier = 0.995 * moisture;
    (model.isotherm.boiling_point(drier) - boiling) / ((moisture - drier) * model.lean_solids[node])
}

/// Area of a patch of the contracted piece [m²].
#[inline]
pub fn present_area(patch: &Patch, state: &FoodState) -> f64 {
    let lateral = state.stretch.lateral;
    let height = if patch.face == Face::Side { state.stretch.axial[patch.node as usize] } else { lateral };
    patch.area * lateral * height
}

/// First-order changes, peak temperature, lethality and browning through `dt` [s].
fn change(model: &FoodModel, state: &mut FoodState, dt: f64) {
    for i in 0..state.temperature.len() {
        let t = state.temperature[i];
        state.peak[i] = state.peak[i].max(t);
        if t > CHANGES_FROM {
            state.lethality[i] += model.lethality.at(t) * dt;
            model.changes.advance(&mut state.changed, i, t, dt);
        }
        if t > BROWNING_FROM {
            brown(model, state, i, dt);
        }
    }
}

/// Browning and charring of a node by its rules.
fn brown(model: &FoodModel, state: &mut FoodState, i: usize, dt: f64) {
    let t = state.temperature[i];
    if model.rules == Rules::Paper2013 {
        let lost = 1.0 - state.water[i] / model.initial_water[i];
        state.browning[i] = paper_2013::browning(state.browning[i], t, lost);
        return;
    }
    let activity = model.isotherm.activity(state.water[i] / model.lean_solids[i]);
    let before = (state.browning[i], state.charring[i]);
    (state.browning[i], state.charring[i]) = model.browning.advance(before, t, activity, dt);
}
