//! One tick of a piece of food between given surroundings.

use saute_heat::Conduction;

use crate::body::patch::{Face, Patch};
use crate::change::browning::BROWNING_FROM;
use crate::change::changes::CHANGES_FROM;
use crate::model::FoodModel;
use crate::paper_2013::{self, Rules};
use crate::state::FoodState;
use crate::water::air_film::{AirFilm, FreeAir, HOTTEST_WET};
use crate::water::juice::Runoff;
use crate::water::vapour::latent_heat;

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
    conduction: Conduction,
    /// Conductivity across and along the fibres times the stretches [W/(m·K)].
    conductivity: [Vec<f64>; 2],
    /// Heat capacity [J/K] and one over it.
    capacity: Vec<f64>,
    per_capacity: Vec<f64>,
    power: Vec<f64>,
    /// Exchange of each patch with air, while it is free.
    films: Vec<AirFilm>,
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
            if model.shape.contracts && state.ticks.is_multiple_of(SHAPE_TICKS) {
                model.shrink(state);
            }
        }
        // A solver that has seen nothing of the piece as it is now looks at once.
        if due || self.films.len() != model.shape.patches.len() {
            self.refresh(model, state, dt);
            self.refresh_films(model, state, around);
            if !self.keep_or_restore(state) {
                return Exchange::default();
            }
        }
        let step = dt / f64::from(self.substeps);
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
            let t = model.properties.temperature(&masses, state.enthalpy[i], state.temperature[i]);
            state.temperature[i] = t;
            self.capacity[i] = model.properties.enthalpy(&masses, t).1;
            self.per_capacity[i] = 1.0 / self.capacity[i];
        }
        if state.ticks.is_multiple_of(CONDUCTION_TICKS) || self.conductivity[0].len() != n {
            self.refresh_conduction(model, state);
        }
        let limit = STABILITY_MARGIN * self.conduction.stable_step(&self.capacity);
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
            let moist = (state.water[i] / (driest * model.tissue.initial_water[i])).min(1.0);
            let conductivity = crust + moist * (wet - crust);
            // Area over length: height across the fibres, area over height along them.
            let axial = state.stretch.axial[i];
            self.conductivity[0][i] = across * conductivity * axial;
            self.conductivity[1][i] = conductivity * area / axial;
        }
        let [across, along] = &self.conductivity;
        self.conduction.refresh_each(model.shape.mesh.graph(), |_, a, b| {
            let k = if model.shape.mesh.is_along(a, b) { along } else { across };
            (k[a], k[b])
        });
    }

    /// Remembers a sound state; puts the remembered one in place of an unsound one. Returns whether all is well.
    fn keep_or_restore(&mut self, state: &mut FoodState) -> bool {
        let sound = state.temperature.iter().chain(&state.water).all(|v| v.is_finite());
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
        self.power.fill(0.0);
        self.conduction.add_power(model.shape.mesh.graph(), &state.temperature, &mut self.power);
        let fields = state.enthalpy.iter_mut().zip(&mut state.temperature);
        for ((h, t), (p, per_c)) in fields.zip(self.power.iter().zip(&self.per_capacity)) {
            let heat = p * dt;
            *h += heat;
            *t += heat * per_c;
        }
        self.exchange_patches(model, state, around, dt, total);
        self.boil(model, state, total);
    }

    /// Heat and vapour through every patch: from what it touches, or with the air.
    fn exchange_patches(
        &mut self,
        model: &FoodModel,
        state: &mut FoodState,
        around: &Surroundings,
        dt: f64,
        total: &mut Exchange,
    ) {
        for (i, patch) in model.shape.patches.iter().enumerate() {
            match around.touch.get(i) {
                Some(touch) if touch.conductance > 0.0 => {
                    let conductance = touch.conductance * present_area(patch, state) * dt;
                    let heat = self.exchange(state, patch.node as usize, conductance, touch.temperature);
                    self.contact_heat[i] += heat;
                }
                _ => self.breathe(state, patch, &self.films[i], &around.air[patch.air], dt, total),
            }
        }
    }

    /// Convection, radiation and evaporation of each patch, linearised about its present state.
    fn refresh_films(&mut self, model: &FoodModel, state: &FoodState, around: &Surroundings) {
        self.films.clear();
        let film = |patch: &Patch| AirFilm::of(model, state, patch, &around.air[patch.air]);
        self.films.extend(model.shape.patches.iter().map(film));
    }

    /// Brings a node towards `outside` through a conductance times time [J/K], implicitly; returns the heat gained [J].
    #[inline]
    fn exchange(&self, state: &mut FoodState, node: usize, conductance: f64, outside: f64) -> f64 {
        let capacity = self.capacity[node];
        let change = conductance * (outside - state.temperature[node]) / (capacity + conductance);
        state.temperature[node] += change;
        state.enthalpy[node] += capacity * change;
        capacity * change
    }

    /// A free patch exchanges heat and vapour with the air for `dt` [s].
    #[inline]
    fn breathe(
        &self,
        state: &mut FoodState,
        patch: &Patch,
        film: &AirFilm,
        air: &FreeAir,
        dt: f64,
        total: &mut Exchange,
    ) {
        let node = patch.node as usize;
        total.air -= self.exchange(state, node, film.heat * dt, air.temperature);
        let density = film.density + film.slope * (state.temperature[node].min(HOTTEST_WET) - film.temperature);
        // Implicit in the temperature that falls as water leaves: no overshoot below the wet bulb.
        let transfer = film.transfer * dt;
        let damped = 1.0 + transfer * film.slope * film.latent / self.capacity[node];
        let mass = (transfer * (density - air.vapour_density) / damped).clamp(0.0, 0.2 * state.water[node]);
        let enthalpy = mass * film.vapour_enthalpy;
        state.water[node] -= mass;
        state.enthalpy[node] -= enthalpy;
        state.temperature[node] -= mass * film.latent / self.capacity[node];
        total.evaporated += mass;
        total.evaporation += enthalpy;
    }

    /// Turns heat above the boiling point into vapour, node by node.
    ///
    /// As a node dries its boiling point rises (isotherm), so mass and temperature are found together by Newton's
    /// rule: dm = C (T − T_b) / (L + C · |dT_b/dm|).
    fn boil(&mut self, model: &FoodModel, state: &mut FoodState, total: &mut Exchange) {
        self.hot.clear();
        self.hot.extend((0u32..).zip(&state.temperature).filter(|(_, t)| **t > NEARLY_BOILING).map(|(i, _)| i));
        for &node in &self.hot {
            let i = node as usize;
            for _ in 0..4 {
                let moisture = state.water[i] / model.tissue.lean_solids[i];
                let boiling = model.water.isotherm.boiling_point(moisture);
                let excess = state.temperature[i] - boiling;
                if excess <= 1e-3 || state.water[i] <= 0.0 {
                    break;
                }
                let capacity = self.capacity[i];
                let drier = 0.995 * moisture;
                let slope = (model.water.isotherm.boiling_point(drier) - boiling)
                    / ((moisture - drier) * model.tissue.lean_solids[i]);
                let latent = latent_heat(boiling);
                let mass = (capacity * excess / (latent + capacity * slope)).min(state.water[i]);
                let enthalpy = mass * (model.properties.water_enthalpy(boiling) + latent);
                state.water[i] -= mass;
                state.enthalpy[i] -= enthalpy;
                state.temperature[i] -= mass * latent / capacity;
                total.evaporated += mass;
                total.evaporation += enthalpy;
                // Where the boiling point stays, one round finds it.
                if slope == 0.0 {
                    break;
                }
            }
        }
    }
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
            state.lethality[i] += model.response.lethality.at(t) * dt;
            for (k, share) in state.changed.iter_mut().enumerate() {
                share[i] = model.response.rates.advance(k, share[i], t, dt);
            }
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
        let lost = 1.0 - state.water[i] / model.tissue.initial_water[i];
        state.browning[i] = paper_2013::browning(state.browning[i], t, lost);
        return;
    }
    let activity = model.water.isotherm.activity(state.water[i] / model.tissue.lean_solids[i]);
    let before = (state.browning[i], state.charring[i]);
    (state.browning[i], state.charring[i]) = model.response.browning.advance(before, t, activity, dt);
}
