//! One tick of a piece of food between given surroundings.

use saute_heat::Conduction;

use crate::browning::BROWNING_FROM;
use crate::changes::DENATURES_FROM;
use crate::juice::Drip;
use crate::model::FoodModel;
use crate::state::{FoodState, Side};
use crate::water::latent_heat;

/// Stefan–Boltzmann constant [W/(m²·K⁴)] (CODATA 2018).
const STEFAN_BOLTZMANN: f64 = 5.670_374e-8;
/// Nodes above this may boil [K].
const NEARLY_BOILING: f64 = 372.15;
/// Ticks between two refreshes of properties, proteins, browning and juice (chosen: half a second).
pub const REFRESH_TICKS: u64 = 5;
/// Share of the stability limit that a step may use: properties are up to half a second old [-].
const STABILITY_MARGIN: f64 = 0.8;
/// Steepest evaporation with temperature that a step must be stable for [W/(m²·K)] (free air at 95 °C: about 600).
const EVAPORATION_SLOPE: f64 = 700.0;

/// Air around free faces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeAir {
    /// Temperature of air and walls [K].
    pub temperature: f64,
    /// Convective heat transfer coefficient [W/(m²·K)].
    pub convection: f64,
    /// Share of radiation that is not screened [-] (a foil screens most).
    pub radiation: f64,
    /// Vapour density of the far air [kg/m³].
    pub vapour_density: f64,
    /// Mass transfer coefficient of vapour, by the Lewis analogy [m/s].
    pub mass_transfer: f64,
}

/// What the lower face touches.
#[derive(Clone, Copy, Debug)]
pub enum Down<'a> {
    /// A solid: conductance [W/(m²·K)] and its temperature [K] under each node of the section.
    Contact {
        /// Contact conductance [W/(m²·K)].
        conductance: &'a [f64],
        /// Temperature of what it touches [K].
        temperature: &'a [f64],
    },
    /// Air.
    Free(FreeAir),
}

/// Everything around a piece during one tick.
#[derive(Clone, Copy, Debug)]
pub struct Surroundings<'a> {
    /// Below.
    pub down: Down<'a>,
    /// Above.
    pub up: FreeAir,
    /// Around the side.
    pub side: FreeAir,
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
    pub drip: Drip,
}

/// Scratch space and cached properties of one piece.
#[derive(Clone, Debug, Default)]
pub struct FoodSolver {
    conduction: Conduction,
    conductivity: Vec<f64>,
    capacity: Vec<f64>,
    power: Vec<f64>,
    exchange: Vec<f64>,
    hot: Vec<u32>,
    /// The last state in which everything was finite.
    sound: Option<FoodState>,
    /// Heat taken from the contact under each node of the section in the last tick [J].
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
        self.contact_heat.resize(model.mesh.nodes_per_level(), 0.0);
        if !state.healthy {
            return total;
        }
        if state.ticks.is_multiple_of(REFRESH_TICKS) {
            if state.ticks > 0 {
                total.drip = change(model, state, dt * REFRESH_TICKS as f64);
            }
            self.refresh(model, state, around, dt);
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

    /// Brings temperatures, capacities, conductances and the number of steps up to date.
    fn refresh(&mut self, model: &FoodModel, state: &mut FoodState, around: &Surroundings, dt: f64) {
        let n = state.temperature.len();
        self.conductivity.resize(n, 0.0);
        self.capacity.resize(n, 0.0);
        self.power.resize(n, 0.0);
        let driest = 1.0 - model.water_holding.drop;
        let crust = model.description.crust.conductivity_w_mk;
        for i in 0..n {
            let masses = model.masses(i, state.water[i]);
            let t = model.properties.temperature(&masses, state.enthalpy[i], state.temperature[i]);
            state.temperature[i] = t;
            self.capacity[i] = model.properties.enthalpy(&masses, t).1;
            let moist = (state.water[i] / (driest * model.initial_water[i])).min(1.0);
            self.conductivity[i] = crust + moist * (model.properties.conductivity(&masses, t) - crust);
        }
        self.conduction.refresh(&model.mesh.graph, &self.conductivity);
        self.set_exchange(model, state, around);
        let limit = STABILITY_MARGIN * self.conduction.stable_step(&self.capacity, &self.exchange);
        self.substeps = libm::ceil(dt / limit).clamp(1.0, 1000.0) as u32;
    }

    /// Remembers a sound state; puts the remembered one in place of an unsound one. Returns whether all is well.
    fn keep_or_restore(&mut self, state: &mut FoodState) -> bool {
        let sound = state.temperature.iter().chain(&state.water).all(|v| v.is_finite());
        match &mut self.sound {
            Some(kept) if sound => kept.clone_from(state),
            None if sound => self.sound = Some(state.clone()),
            _ => self.restore(state),
        }
        sound
    }

    fn restore(&mut self, state: &mut FoodState) {
        if let Some(kept) = &self.sound {
            state.clone_from(kept);
        }
        state.healthy = false;
        self.contact_heat.fill(0.0);
    }

    fn set_exchange(&mut self, model: &FoodModel, state: &FoodState, around: &Surroundings) {
        self.exchange.clear();
        self.exchange.resize(state.temperature.len(), 0.0);
        let free = |air: &FreeAir| air.convection + 20.0 * air.radiation + EVAPORATION_SLOPE;
        for &node in &model.side_nodes {
            self.exchange[node as usize] += free(&around.side) * model.side_areas[node as usize];
        }
        for (i, area) in model.mesh.section.areas.iter().enumerate() {
            let down = match &around.down {
                Down::Contact { conductance, .. } => conductance[i],
                Down::Free(air) => free(air),
            };
            self.exchange[face_node(model, state.down, i)] += down * area;
            self.exchange[face_node(model, state.down.opposite(), i)] += free(&around.up) * area;
        }
    }

    fn step(&mut self, model: &FoodModel, state: &mut FoodState, around: &Surroundings, dt: f64, total: &mut Exchange) {
        self.power.fill(0.0);
        self.conduction.add_power(&model.mesh.graph, &state.temperature, &mut self.power);
        self.add_contact(model, state, around, dt);
        self.add_air(model, state, around, dt, total);
        self.hot.clear();
        let fields = state.enthalpy.iter_mut().zip(&mut state.temperature);
        for (i, ((h, t), (p, c))) in fields.zip(self.power.iter().zip(&self.capacity)).enumerate() {
            let heat = p * dt;
            *h += heat;
            *t += heat / c;
            if *t > NEARLY_BOILING {
                self.hot.push(i as u32);
            }
        }
        self.boil(model, state, total);
    }

    fn add_contact(&mut self, model: &FoodModel, state: &FoodState, around: &Surroundings, dt: f64) {
        let Down::Contact { conductance, temperature } = around.down else { return };
        for (i, area) in model.mesh.section.areas.iter().enumerate() {
            let node = face_node(model, state.down, i);
            let power = conductance[i] * area * (temperature[i] - state.temperature[node]);
            self.power[node] += power;
            self.contact_heat[i] += power * dt;
        }
    }

    /// Convection, radiation and evaporation at every free face.
    fn add_air(&mut self, model: &FoodModel, state: &mut FoodState, around: &Surroundings, dt: f64, total: &mut Exchange) {
        let areas = &model.mesh.section.areas;
        for i in 0..areas.len() {
            let up = face_node(model, state.down.opposite(), i);
            self.free_face(model, state, up, areas[i], &around.up, dt, total);
            if let Down::Free(air) = &around.down {
                self.free_face(model, state, face_node(model, state.down, i), areas[i], air, dt, total);
            }
        }
        for &node in &model.side_nodes {
            let node = node as usize;
            self.free_face(model, state, node, model.side_areas[node], &around.side, dt, total);
        }
    }

    #[expect(clippy::too_many_arguments, reason = "the face, its air and the ledger are all different things")]
    #[inline]
    fn free_face(&mut self, model: &FoodModel, state: &mut FoodState, node: usize, area: f64, air: &FreeAir, dt: f64, total: &mut Exchange) {
        let t = state.temperature[node];
        let radiation = radiation_coefficient(model.description.surface.emissivity, t, air.temperature) * air.radiation;
        let lost = (air.convection + radiation) * area * (t - air.temperature);
        self.power[node] -= lost;
        total.air += lost * dt;
        let moisture = state.water[node] / model.lean_solids[node];
        let surface = t.min(NEARLY_BOILING + 1.0);
        let driving = model.isotherm.activity(moisture) * model.vapour.at(surface) - air.vapour_density;
        let mass = (air.mass_transfer * driving * area * dt).clamp(0.0, 0.2 * state.water[node]);
        let enthalpy = mass * (model.properties.water_enthalpy(t) + latent_heat(t));
        state.water[node] -= mass;
        state.enthalpy[node] -= enthalpy;
        state.temperature[node] -= mass * latent_heat(t) / self.capacity[node];
        total.evaporated += mass;
        total.evaporation += enthalpy;
    }

    /// Turns heat above the boiling point into vapour, node by node.
    ///
    /// As a node dries its boiling point rises (isotherm), so mass and temperature are found together by Newton's
    /// rule: dm = C (T − T_b) / (L + C · |dT_b/dm|).
    fn boil(&mut self, model: &FoodModel, state: &mut FoodState, total: &mut Exchange) {
        for &node in &self.hot {
            let i = node as usize;
            for _ in 0..8 {
                let moisture = state.water[i] / model.lean_solids[i];
                let boiling = model.isotherm.boiling_point(moisture);
                if state.water[i] <= 0.0 || state.temperature[i] < boiling - 2.0 {
                    break;
                }
                let masses = model.masses(i, state.water[i]);
                let t = model.properties.temperature(&masses, state.enthalpy[i], state.temperature[i]);
                state.temperature[i] = t;
                if t <= boiling + 1e-3 {
                    break;
                }
                let capacity = model.properties.enthalpy(&masses, t).1;
                let drier = 0.995 * moisture;
                let slope = (model.isotherm.boiling_point(drier) - boiling) / ((moisture - drier) * model.lean_solids[i]);
                let latent = latent_heat(boiling);
                let mass = (capacity * (t - boiling) / (latent + capacity * slope)).min(state.water[i]);
                let enthalpy = mass * (model.properties.water_enthalpy(boiling) + latent);
                state.water[i] -= mass;
                state.enthalpy[i] -= enthalpy;
                total.evaporated += mass;
                total.evaporation += enthalpy;
            }
        }
    }
}

/// Radiative heat transfer coefficient ε σ (T² + T₀²)(T + T₀) [W/(m²·K)].
#[inline]
pub fn radiation_coefficient(emissivity: f64, temperature: f64, walls: f64) -> f64 {
    emissivity * STEFAN_BOLTZMANN * (temperature * temperature + walls * walls) * (temperature + walls)
}

#[inline]
fn face_node(model: &FoodModel, side: Side, i: usize) -> usize {
    match side {
        Side::Bottom => i,
        Side::Top => model.mesh.node(model.mesh.levels.len() - 1, i),
    }
}

/// Proteins, peak temperature, browning and juice through `dt` [s].
fn change(model: &FoodModel, state: &mut FoodState, dt: f64) -> Drip {
    for i in 0..state.temperature.len() {
        let t = state.temperature[i];
        state.peak[i] = state.peak[i].max(t);
        if t > DENATURES_FROM {
            for k in 0..4 {
                state.denatured[k][i] = model.proteins.advance(k, state.denatured[k][i], t, dt);
            }
        }
        if t > BROWNING_FROM {
            let activity = model.isotherm.activity(state.water[i] / model.lean_solids[i]);
            let before = (state.browning[i], state.charring[i]);
            (state.browning[i], state.charring[i]) = model.browning.advance(before, t, activity, dt);
        }
    }
    model.release_juice(state, dt)
}
