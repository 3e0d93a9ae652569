//! The pan: a heated plate with a wall, with conduction along its metal.

use saute_food::water::air_film::radiation_coefficient;
use saute_food::water::juice::Runoff;
use saute_food::{Exchange, FreeAir, Rules};
use saute_heat::{Conduction, Graph, Located, Locator, MeshError, Section};
use serde::{Deserialize, Serialize};

use crate::data::library::Library;
use crate::data::room::{OverPan, Room};
use crate::dynamics::PanShape;
use crate::liquids::drop_flight::Vessel;
use crate::liquids::liquid_layer::{LiquidModel, LiquidSolver, Liquids, PanSurroundings};
use crate::liquids::water_film::Vapour;
use crate::pan::bed::Bed;
use crate::pan::cloth::Cloth;
use crate::pan::heater::{Coil, Given, Heater, Meets};
use crate::pan::hob::{HobDescription, PanPose};
use crate::pan::lid::Lid;
use crate::pan::pan_class::PanClass;
use crate::pan::pan_description::PanDescription;
use crate::pan::ridges::Ridges;
use crate::pan::under::lifted;
use crate::tick::event::EventLog;

/// Rings of nodes on the floor [-] (chosen: 8 mm apart; the heated ring is 50 mm wide).
const FLOOR_RINGS: usize = 12;
/// The same of a coarse pan [-] (chosen: 21 mm apart; explicit steps are six times as long, and half a second is one or two).
const COARSE_RINGS: usize = 5;

/// Immutable model of a pan on its hob.
#[derive(Clone, Debug)]
pub struct PanModel {
    /// Description from its data file.
    pub description: PanDescription,
    /// Mesh of floor and unrolled wall.
    pub section: Section,
    /// Point location on the mesh.
    pub locator: Locator,
    /// Number of floor nodes; they come first [-].
    pub floor_nodes: usize,
    /// Area of the floor [m²].
    pub floor_area: f64,
    /// Ridges on the floor of a grill pan.
    pub ridges: Option<Ridges>,
    /// Model of the liquids on it.
    pub liquids: LiquidModel,
    /// The class of pan that is named to the hob.
    pub(crate) class: PanClass,
    pub(crate) capacity: Vec<f64>,
    graph: Graph,
    conduction: Conduction,
    /// Shares of a flame's heat to the wall at its nodes; none without a flame.
    licked: Vec<f64>,
    /// Upper bound of the conductance to air and glass at each node [W/K]; limits the stable step.
    steepest: Vec<f64>,
}

/// State of a pan.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct PanState {
    /// Temperature of the metal at each node [K].
    pub temperature: Vec<f64>,
    /// Highest temperature of the metal so far at each node [K].
    pub peak: Vec<f64>,
    /// Temperature of what is under each floor node: the hob's glass, a burner's tray, the rim around a plate [K].
    pub glass: Vec<f64>,
    /// Temperature of what a stove without a coil heats: grate, element or plate [K].
    pub heater: f64,
    /// Oil, water and butter in the pan.
    pub liquids: Liquids,
    /// The lid, while it is on.
    pub lid: Option<Lid>,
    /// Place over the hob.
    pub pose: PanPose,
    /// Share of the hob's power in each floor node [-].
    pub ring_shares: Vec<f64>,
    /// True while a temperature limit of the hob reduces the power or switches it off.
    pub limited: bool,
    /// Steam that rises from foods and liquids, averaged [kg/s].
    pub steam: f64,
    /// Share of the floor under food [-].
    pub covered: f64,
}

/// Scratch memory of a pan's solver.
#[derive(Clone, Debug, Default)]
pub struct PanSolver {
    heat: Vec<f64>,
    /// Heat of an element into the glass under each floor node [J].
    into_glass: Vec<f64>,
    /// Metal of a pan that is elsewhere [K], and the heat that it would get [J].
    away: [Vec<f64>; 2],
    /// Heat capacity of metal and oil at each node [J/K].
    capacity: Vec<f64>,
    liquids: LiquidSolver,
}

/// Loads on the pan during one tick.
#[derive(Clone, Copy, Debug)]
pub struct PanLoad<'a> {
    /// Hob.
    pub hob: &'a HobDescription,
    /// Room.
    pub room: &'a Room,
    /// Electrical power that the hob gives [W].
    pub hob_w: f64,
    /// True while the temperature limit reduces that power.
    pub limited: bool,
    /// Time at the start of the tick [s].
    pub time: f64,
    /// Length of the tick [s].
    pub lapse_s: f64,
    /// Heat flow from each node into food [W].
    pub food: &'a [f64],
    /// Share of each node's area under food [-].
    pub covered: &'a [f64],
    /// Steam from food at each node in this tick [kg].
    pub steam: &'a [f64],
    /// Gravity minus the pan's acceleration, in the pan's frame [m/s²].
    pub gravity: [f64; 3],
    /// Rules in force.
    pub rules: Rules,
}

/// Gravity in the frame of a level pan at rest [m/s²].
pub const LEVEL: [f64; 3] = [0.0, 0.0, -saute_food::GRAVITY];

/// Distance of a pan that is elsewhere [m] (chosen: no heat of a stove reaches there).
const AWAY: f64 = 1e3;
/// Upper bound of convection and radiation from both faces of a wall [W/(m²·K)] (chosen: a very hot wall); limits the
/// stable step.
const STEEPEST_AIR_LOSS: f64 = 100.0;

/// Energy exchange of the pan in one tick [J].
#[derive(Clone, Copy, Debug, Default)]
pub struct PanExchange {
    /// Electrical energy.
    pub hob: f64,
    /// To air and walls.
    pub air: f64,
    /// Into glass, coil and cloth, and with oil and juice that left the pan.
    pub other: f64,
    /// Vapour from the pan's water to the room.
    pub vapour: Vapour,
    /// Vapour from the cloth [kg].
    pub cloth_vapour: f64,
}

impl PanModel {
    /// Meshes a pan: rings on the floor and on the wall, which is unrolled into the plane.
    pub fn build(description: &PanDescription, library: &Library) -> Result<Self, MeshError> {
        let liquids = |bed, floor_nodes| LiquidModel::new(bed, floor_nodes, description, library);
        Self::meshed(description, FLOOR_RINGS, &library.hob, liquids)
    }

    /// Meshes the same pan with few nodes.
    pub(crate) fn coarser(&self, hob: &HobDescription) -> Result<Self, MeshError> {
        let liquids = |bed, floor_nodes| self.liquids.on(bed, floor_nodes);
        Self::meshed(&self.description, COARSE_RINGS, hob, liquids)
    }

    fn meshed(
        description: &PanDescription,
        floor_rings: usize,
        hob: &HobDescription,
        liquids: impl FnOnce(Bed, usize) -> LiquidModel,
    ) -> Result<Self, MeshError> {
        let floor = description.floor.radius_mm * 1e-3;
        let step = floor / (floor_rings as f64 - 0.5);
        let wall_rings = libm::round(description.rise() / step).max(1.0) as usize;
        let radii: Vec<f64> = (0..floor_rings + wall_rings).map(|i| i as f64 * step).collect();
        let section = Section::rings(&radii, step)?;
        let floor_nodes = section.points.iter().filter(|p| libm::hypot(p[0], p[1]) < floor).count();
        let thickness = |i: usize| description.conducting(i < floor_nodes);
        let metal = &description.metal;
        let areas = &section.areas;
        let storing = |i: usize| description.storing(i < floor_nodes);
        let capacity =
            (0..areas.len()).map(|i| areas[i] * storing(i) * metal.density_kg_m3 * metal.specific_heat_j_kgk).collect();
        let mut graph =
            Graph { volume: (0..areas.len()).map(|i| areas[i] * thickness(i)).collect(), ..Graph::default() };
        for &(a, b, weight) in &section.edges {
            graph.push(a, b, weight * 0.5 * (thickness(a as usize) + thickness(b as usize)));
        }
        let mut conduction = Conduction::default();
        conduction.refresh(&graph, &vec![metal.conductivity_w_mk; areas.len()]);
        let bed = Bed::new(&section, description);
        Ok(Self {
            liquids: liquids(bed, floor_nodes),
            steepest: areas.iter().map(|a| a * (STEEPEST_AIR_LOSS + hob.steepest_w_m2k())).collect(),
            licked: licked(hob, &section, floor_nodes, floor),
            floor_area: areas[..floor_nodes].iter().sum(),
            locator: Locator::new(&section),
            class: PanClass::of(description, hob),
            ridges: description.ridges.as_ref().map(Ridges::of),
            description: description.clone(),
            floor_nodes,
            capacity,
            graph,
            conduction,
            section,
        })
    }

    /// Initial state: the pan at a uniform temperature [K] on its ring, the glass at room temperature, with oil [kg]; a seasoned pan
    /// has its film at least.
    pub fn at(&self, pan: f64, oil: f64, room: &Room, hob: &HobDescription) -> PanState {
        let pose = PanPose::default();
        PanState {
            temperature: vec![pan; self.capacity.len()],
            peak: vec![pan; self.capacity.len()],
            glass: vec![room.temperature(); self.floor_nodes],
            heater: room.temperature(),
            liquids: self.liquids.fresh(pan, oil.max(1e-3 * self.description.surface.film_g), room),
            lid: None,
            ring_shares: self.ring_shares(hob, &pose),
            pose,
            limited: false,
            steam: 0.0,
            covered: 0.0,
        }
    }

    fn ring_shares(&self, hob: &HobDescription, pose: &PanPose) -> Vec<f64> {
        let floor = self.floor_nodes;
        hob.ring_shares(&self.section.points[..floor], &self.section.areas[..floor], pose)
    }

    /// Moves the pan over the hob.
    pub fn place(&self, state: &mut PanState, hob: &HobDescription, pose: PanPose) {
        state.ring_shares = self.ring_shares(hob, &pose);
        state.pose = pose;
    }

    /// Thickness of the oil film at a place of the floor [m].
    pub(crate) fn film_at(&self, state: &PanState, at: [f64; 2]) -> f64 {
        state.oil_film(&self.locator.locate_or_nearest(&self.section, at))
    }

    /// Area mean of the flat floor [K].
    pub fn floor_temperature(&self, state: &PanState) -> f64 {
        let sum: f64 = state.temperature[..self.floor_nodes].iter().zip(&self.section.areas).map(|(t, a)| t * a).sum();
        sum / self.floor_area
    }

    /// Mean temperature of the metal as the hob's coil meets it, by the shares of its power; none off the ring [K].
    pub(crate) fn heated_temperature(&self, state: &PanState) -> Option<f64> {
        let whole: f64 = state.ring_shares.iter().sum();
        let sum: f64 = state.temperature.iter().zip(&state.ring_shares).map(|(t, share)| t * share).sum();
        (whole > 0.0).then(|| sum / whole)
    }

    /// Heat stored above 0 °C in metal, liquids and lid [J].
    pub fn stored(&self, state: &PanState) -> f64 {
        let metal: f64 = state.temperature.iter().zip(&self.capacity).map(|(t, c)| (t - saute_food::ZERO_C) * c).sum();
        metal + self.liquids.stored(&state.liquids, &state.temperature) + state.lid.map_or(0.0, |lid| lid.stored())
    }

    /// Air above and next to food whose upper face is at `surface` [K]: the pan's plume, or the air under the lid.
    pub fn airs(&self, state: &PanState, room: &Room, surface: impl FnOnce() -> f64) -> [FreeAir; 3] {
        match &state.lid {
            Some(lid) => [lid.air_over(room, surface()).0; 3],
            None => {
                let (up, side) = room.plume(&self.seen_by_air(state));
                [up, up, side]
            }
        }
    }

    fn seen_by_air(&self, state: &PanState) -> OverPan {
        let floor = self.floor_temperature(state);
        let walls = state.temperature[self.floor_nodes..].iter().zip(&self.section.areas[self.floor_nodes..]);
        let (sum, area) = walls.fold((0.0, 0.0), |(sum, area), (t, a)| (sum + t * a, area + a));
        let wall = if area > 0.0 { sum / area } else { floor };
        OverPan { floor, wall, steam: state.steam, covered: state.covered }
    }

    /// Adds rendered fat, whose enthalpy includes its latent heat of fusion [J/kg], to the oil; returns the part of the
    /// enthalpy that the oil does not store [J].
    pub fn render(&self, state: &mut PanState, fat: &Runoff, latent: f64) -> f64 {
        let PanState { liquids, temperature, .. } = state;
        self.liquids.render(liquids, (fat.mass, fat.enthalpy), latent, &self.capacity, temperature)
    }

    /// Distributes the heat and vapour that food in the pan gave to the air. Without a lid all goes to the room; with a lid
    /// it stays under it. Returns heat and enthalpy of vapour to the room [J].
    pub fn take_up(
        &self,
        state: &mut PanState,
        room: &Room,
        surface: impl FnOnce() -> f64,
        exchange: &Exchange,
    ) -> (f64, f64) {
        let Some(lid) = &mut state.lid else { return (exchange.air, exchange.evaporation) };
        let condensing = lid.air_over(room, surface()).1;
        lid.take_vapour(Vapour { mass: exchange.evaporated, enthalpy: exchange.evaporation });
        let dew = lid.take_heat(exchange.air, condensing);
        self.liquids.pour_water(&mut state.liquids, dew);
        (0.0, 0.0)
    }

    /// Advances the pan by `dt` [s] with substeps inside the explicit stability limit. A pan on a cloth gets no power.
    pub fn advance(
        &self,
        state: &mut PanState,
        solver: &mut PanSolver,
        load: &PanLoad,
        cloth: &mut Option<Cloth>,
        events: &mut EventLog,
        dt: f64,
    ) -> PanExchange {
        let stable = 0.8 * self.conduction.stable_step_with(&self.capacity, &self.steepest);
        let limit = stable.min(load.hob.under_step_s());
        let steps = libm::ceil(dt / limit).clamp(1.0, 1000.0);
        state.limited = is_limited(state, load);
        let mut total = PanExchange::default();
        let PanState { liquids, temperature, .. } = state;
        let scratch = &mut solver.liquids;
        total.other += self.liquids.run(liquids, scratch, load.gravity, &self.capacity, temperature, dt);
        scratch.boiled = 0.0;
        state.lid.iter_mut().for_each(|lid| lid.boiled = 0.0);
        scratch.steam.clear();
        scratch.steam.extend_from_slice(load.steam);
        solver.capacity.clear();
        solver.capacity.extend(self.capacity.iter().zip(&liquids.oil.capacity).map(|(metal, oil)| metal + oil));
        for _ in 0..steps as usize {
            self.step(state, solver, load, cloth, dt / steps, &mut total);
        }
        if load.rules == Rules::Full {
            self.liquids.mix_oil(&state.liquids, &solver.capacity, &mut state.temperature, dt);
        }
        self.finish(state, solver, load, events, dt, &mut total);
        state.peak.iter_mut().zip(&state.temperature).for_each(|(peak, t)| *peak = peak.max(*t));
        total
    }

    /// Advances liquids and lid at the end of a tick.
    fn finish(
        &self,
        state: &mut PanState,
        solver: &PanSolver,
        load: &PanLoad,
        events: &mut EventLog,
        dt: f64,
        total: &mut PanExchange,
    ) {
        let floor = || self.floor_temperature(state);
        let air = match (load.rules, &state.lid) {
            (Rules::Paper2013, None) => load.room.plume_2013(floor()).0,
            _ => self.airs(state, load.room, floor)[0],
        };
        let around = PanSurroundings {
            room: load.room,
            air,
            lidded: state.lid.is_some(),
            covered: load.covered,
            rules: load.rules,
            vessel: self.vessel(state),
            middle: state.pose.at,
            time: load.time,
        };
        let PanState { liquids, temperature, .. } = state;
        let (vapour, heat) = self.liquids.finish(liquids, &solver.liquids, &around, temperature, events, dt);
        total.other += heat;
        self.release(state, vapour, total);
        if let Some(lid) = &mut state.lid {
            lid.boiled /= dt;
            let settled = lid.settle(load.room, dt);
            total.air += settled.to_room;
            total.vapour.mass += settled.escaped.mass;
            total.vapour.enthalpy += settled.escaped.enthalpy;
            self.liquids.pour_water(&mut state.liquids, settled.condensate);
        }
    }

    /// Geometry of the pan for flying drops.
    fn vessel(&self, state: &PanState) -> Vessel {
        let shape = PanShape::of(&self.description);
        Vessel { floor: shape.floor, rim: shape.rim, height: shape.height, stands: shape.thickness + state.pose.lift }
    }

    /// Adds vapour from the pan's water to the room or to the air under the lid.
    fn release(&self, state: &mut PanState, vapour: Vapour, total: &mut PanExchange) {
        match &mut state.lid {
            Some(lid) => {
                lid.take_vapour(vapour);
                lid.boiled += vapour.mass;
            }
            None => {
                total.vapour.mass += vapour.mass;
                total.vapour.enthalpy += vapour.enthalpy;
            }
        }
    }

    fn step(
        &self,
        state: &mut PanState,
        solver: &mut PanSolver,
        load: &PanLoad,
        cloth: &mut Option<Cloth>,
        dt: f64,
        total: &mut PanExchange,
    ) {
        let PanSolver { heat, liquids, .. } = &mut *solver;
        heat.clear();
        heat.extend(load.food.iter().map(|p| -p));
        self.conduction.add_power(&self.graph, &state.temperature, heat);
        heat.iter_mut().for_each(|q| *q *= dt);
        self.add_air_losses(state, load, dt, heat, total);
        self.add_water(state, liquids, dt, heat, total);
        match cloth {
            None => self.add_hob(state, solver, load, dt, total),
            Some(cloth) => {
                self.add_cloth(state, load.room, cloth, dt, &mut solver.heat, total);
                self.heat_nothing(state, solver, load, dt, total);
            }
        }
        for ((t, q), c) in state.temperature.iter_mut().zip(&solver.heat).zip(&solver.capacity) {
            *t += q / c;
        }
        self.cool_glass(state, load, dt);
    }

    /// Convection and radiation from both faces of the wall and from the bare floor; under a lid the inner faces exchange
    /// with its air.
    fn add_air_losses(&self, state: &mut PanState, load: &PanLoad, dt: f64, heat: &mut [f64], total: &mut PanExchange) {
        let room = load.room.temperature();
        let emissivity = self.description.surface.emissivity;
        let inside = state.lid.map(|lid| (lid.air_temperature(), load.room.lid.convection_w_m2k));
        let mut under_lid = 0.0;
        for (i, &t) in state.temperature.iter().enumerate() {
            let area = self.section.areas[i] * dt;
            let bare = if i < self.floor_nodes { 1.0 - load.covered[i] } else { 1.0 };
            let wall = if i < self.floor_nodes { 0.0 } else { 1.0 };
            let mut outer = wall;
            match inside {
                Some((air, convection)) => {
                    let lost = bare * (convection + radiation_coefficient(emissivity, t, air)) * area * (t - air);
                    heat[i] -= lost;
                    under_lid += lost;
                }
                None => outer += bare,
            }
            let excess = t - room;
            let convection = load.room.pan_air.convection_coefficient * libm::sqrt(libm::sqrt(libm::fabs(excess)));
            let lost = outer * (convection + radiation_coefficient(emissivity, t, room)) * area * excess;
            heat[i] -= lost;
            total.air += lost;
        }
        if let Some(lid) = &mut state.lid {
            lid.take_heat(under_lid, 0.0);
        }
    }

    /// Heat transfer from the pan to water on it, with boiling.
    fn add_water(
        &self,
        state: &mut PanState,
        made: &mut LiquidSolver,
        dt: f64,
        heat: &mut [f64],
        total: &mut PanExchange,
    ) {
        let mut vapour = Vapour::default();
        for (i, heat) in heat.iter_mut().enumerate() {
            if state.liquids.water.mass[i] > 0.0 {
                let (base, area) = (state.temperature[i], self.liquids.bed.areas[i]);
                let (taken, boiled) = state.liquids.water.heat(&self.liquids.water, i, area, base, dt);
                *heat -= taken;
                made.steam[i] += boiled.mass;
                vapour.mass += boiled.mass;
                vapour.enthalpy += boiled.enthalpy;
            }
        }
        made.boiled += vapour.mass;
        self.release(state, vapour, total);
    }

    /// Heat from the heater, and between floor and what is under it: contact conductance in series with the air under a
    /// lifted pan.
    fn add_hob(&self, state: &mut PanState, solver: &mut PanSolver, load: &PanLoad, dt: f64, total: &mut PanExchange) {
        let PanSolver { heat, into_glass, .. } = solver;
        match load.hob.heater() {
            Some(Heater::Coil(coil)) => return self.add_coil(coil, state, load, dt, heat, total),
            Some(heater) => {
                let PanState { temperature, glass, heater: warm, ring_shares: shares, pose, limited, .. } = state;
                let meets = self.meets(temperature, shares, pose.lift, load, *limited, dt);
                let given = self.given(heater, load, (warm, glass), &meets, (heat, into_glass));
                total.hob += given.drawn;
                total.other += given.drawn - given.to_pan;
            }
            None => {}
        }
        let under = &load.hob.under;
        let gap = lifted(under.gap_conductance_w_m2k, state.pose.lift);
        for (i, glass) in state.glass.iter_mut().enumerate() {
            let area = self.section.areas[i];
            let lost = gap * area * (state.temperature[i] - *glass) * dt;
            heat[i] -= lost;
            total.other += lost;
            let taken = lost + into_glass.get(i).copied().unwrap_or(0.0);
            *glass += taken / (under.areal_capacity_j_m2k * area);
        }
    }

    /// A stove that detects no pan heats itself and the room while the pan is elsewhere.
    fn heat_nothing(
        &self,
        state: &mut PanState,
        solver: &mut PanSolver,
        load: &PanLoad,
        dt: f64,
        total: &mut PanExchange,
    ) {
        let Some(heater) = load.hob.heater().filter(|heater| !matches!(heater, Heater::Coil(_))) else { return };
        let PanSolver { into_glass, away, .. } = solver;
        let [metal, heat] = away;
        metal.clear();
        metal.resize(state.temperature.len(), load.room.temperature());
        heat.clear();
        heat.resize(metal.len(), 0.0);
        let PanState { glass, heater: warm, ring_shares: shares, limited, .. } = state;
        let meets = self.meets(metal, shares, AWAY, load, *limited, dt);
        let given = self.given(heater, load, (warm, glass), &meets, (heat, into_glass));
        total.hob += given.drawn;
        total.other += given.drawn;
        for ((glass, q), area) in glass.iter_mut().zip(into_glass.iter()).zip(&self.section.areas) {
            *glass += q / (load.hob.under.areal_capacity_j_m2k * area);
        }
    }

    fn meets<'a>(
        &'a self,
        metal: &'a [f64],
        shares: &'a [f64],
        lift: f64,
        load: &PanLoad,
        limited: bool,
        dt: f64,
    ) -> Meets<'a> {
        let power = if limited { 0.0 } else { load.hob.switched(load.hob_w, load.time, load.lapse_s) };
        Meets { metal, areas: &self.section.areas, shares, lift, power, room: load.room.temperature(), dt }
    }

    /// What a heater other than a coil gives in a step, to the metal and to the glass below it.
    fn given(
        &self,
        heater: Heater,
        load: &PanLoad,
        (warm, glass): (&mut f64, &[f64]),
        meets: &Meets,
        (heat, into_glass): (&mut [f64], &mut Vec<f64>),
    ) -> Given {
        into_glass.clear();
        match (heater, &load.hob.grate) {
            (Heater::Flame(flame), Some(grate)) => flame.burn(grate, warm, &self.licked, meets, heat),
            (Heater::Element(element), _) => element.glow(warm, glass, into_glass, meets, heat),
            (Heater::Plate(plate), _) => plate.warm(warm, meets, heat),
            (Heater::Coil(_) | Heater::Flame(_), _) => Given::default(),
        }
    }

    /// Heat from the ring, and between floor and glass.
    fn add_coil(
        &self,
        coil: &Coil,
        state: &mut PanState,
        load: &PanLoad,
        dt: f64,
        heat: &mut [f64],
        total: &mut PanExchange,
    ) {
        let PanLoad { hob, time, lapse_s, .. } = *load;
        let off = state.limited && load.rules == Rules::Paper2013;
        let power = if off { 0.0 } else { hob.switched(load.hob_w, time, lapse_s) };
        let glass = &hob.under;
        let gap = lifted(glass.gap_conductance_w_m2k, state.pose.lift);
        for (i, share) in state.ring_shares.iter().enumerate() {
            let drawn = power * share * dt;
            total.hob += drawn;
            total.other += (1.0 - coil.efficiency) * drawn;
            heat[i] += coil.efficiency * drawn;
            let lost = gap * self.section.areas[i] * (state.temperature[i] - state.glass[i]) * dt;
            heat[i] -= lost;
            total.other += lost;
            state.glass[i] += lost / (glass.areal_capacity_j_m2k * self.section.areas[i]);
        }
    }

    fn add_cloth(
        &self,
        state: &PanState,
        room: &Room,
        cloth: &mut Cloth,
        dt: f64,
        heat: &mut [f64],
        total: &mut PanExchange,
    ) {
        let floor = state.temperature.iter().zip(&self.section.areas).take(self.floor_nodes);
        for (q, (&base, area)) in heat.iter_mut().zip(floor) {
            let taken = cloth.flux(&room.cloth, base) * area * dt;
            *q -= taken;
            total.other += taken;
            total.cloth_vapour += cloth.absorb(taken, base > crate::kelvin(100.0));
        }
    }

    fn cool_glass(&self, state: &mut PanState, load: &PanLoad, dt: f64) {
        let hob = load.hob;
        let share = hob.under.loss_w_m2k * dt / hob.under.areal_capacity_j_m2k;
        let air = load.room.temperature();
        state.glass.iter_mut().for_each(|t| *t -= share * (*t - air));
    }
}

/// Returns true if a limit reduces the power: that of the electronics, of the glass over an element, or of a plate's switch.
fn is_limited(state: &PanState, load: &PanLoad) -> bool {
    match load.hob.heater() {
        Some(Heater::Element(element)) => element.limits(state.limited, &state.glass, &state.ring_shares),
        Some(Heater::Plate(plate)) => plate.limits(state.limited, state.heater),
        Some(Heater::Flame(_)) | None => false,
        Some(Heater::Coil(_)) if load.rules == Rules::Paper2013 => limited_2013(state, load),
        Some(Heater::Coil(_)) => load.limited,
    }
}

/// Shares of a flame's heat to the nodes of a wall that begins at the floor's edge, `floor` [m] from the middle.
fn licked(hob: &HobDescription, section: &Section, floor_nodes: usize, floor: f64) -> Vec<f64> {
    let Some(flame) = &hob.flame else { return Vec::new() };
    let along = section.points[floor_nodes..].iter().map(|p| libm::hypot(p[0], p[1]) - floor);
    flame.wall_shares(along, &section.areas[floor_nodes..])
}

/// By the rules of 2013 the limit switches the power off until the glass above the sensor, in the centre of the coil, has
/// cooled.
fn limited_2013(state: &PanState, load: &PanLoad) -> bool {
    let bound = load.room.rules_2013.limit_c - if state.limited { load.room.rules_2013.resume_k } else { 0.0 };
    state.glass[0] > crate::kelvin(bound)
}

impl PanState {
    /// Highest temperature of the metal so far at a place on the pan's mesh [K].
    pub fn peak_at(&self, at: &Located) -> f64 {
        (0..3).map(|k| at.weights[k] * self.peak[at.nodes[k] as usize]).sum()
    }

    /// Temperature of the metal at a place on the pan's mesh [K].
    pub fn metal_at(&self, at: &Located) -> f64 {
        (0..3).map(|k| at.weights[k] * self.temperature[at.nodes[k] as usize]).sum()
    }

    /// Mass of oil and fat [kg].
    pub fn oil_mass(&self) -> f64 {
        self.liquids.oil.total()
    }

    /// Mass of water in the pan [kg].
    pub fn water_mass(&self) -> f64 {
        self.liquids.water.total()
    }

    /// Smoke from the oil [mg/s].
    pub fn smoke_mg_s(&self) -> f64 {
        1e6 * self.liquids.smoke.rate
    }

    /// Foam of butter, from 0 (none) to 1 (full pan) [-].
    pub fn foam(&self) -> f64 {
        self.liquids.butter.foam
    }

    /// Browning of butter's milk solids, from 0 to 1 [-].
    pub fn milk_solids_browning(&self) -> f64 {
        self.liquids.butter.browning
    }

    /// Thickness of the oil film at a place on the pan's mesh [m].
    pub fn oil_film(&self, at: &Located) -> f64 {
        (0..3).map(|k| at.weights[k] * self.liquids.film[at.nodes[k] as usize]).sum()
    }
}
