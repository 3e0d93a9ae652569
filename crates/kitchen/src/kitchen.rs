//! The whole world: hob, pan, foods, time.

use std::sync::Arc;

use saute_food::water::latent_heat;
use saute_food::{BuildError, FoodModel, MeshSize, PieceSpec, Rules};

use crate::cloth::Cloth;
use crate::command::{Command, Refused};
use crate::energy::Energy;
use crate::hob::{HobDescription, PanPose};
use crate::library::Library;
use crate::pan::{PanLoad, PanModel, PanSolver, PanState};
use crate::piece::{Piece, Place};
use crate::room::Room;
use crate::{TICK_S, kelvin};

/// What never changes while cooking.
#[derive(Clone, Debug)]
struct Fixed {
    room: Room,
    hob: HobDescription,
    pan: PanModel,
}

/// A piece that is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct PieceOrder {
    /// Name in recipes.
    pub id: String,
    /// Kind of food.
    pub kind: String,
    /// Length, width, thickness [m].
    pub size: [f64; 3],
    /// Start temperature [K].
    pub temperature: f64,
    /// Seed of its natural variation.
    pub seed: u64,
    /// Mesh spacing over the default [-].
    pub coarseness: f64,
    /// Rules that it follows.
    pub rules: Rules,
}

/// The world of one cook.
#[derive(Clone, Debug)]
pub struct Kitchen {
    fixed: Arc<Fixed>,
    pan: PanState,
    pan_solver: PanSolver,
    pieces: Vec<Piece>,
    hob_w: f64,
    cloth: Option<Cloth>,
    tick: u64,
    flows: Energy,
    stored_at_start: f64,
    foods_at_start: f64,
    pan_flow: Vec<f64>,
    covered: Vec<f64>,
    puddle_vapour: f64,
    cloth_vapour: f64,
}

/// Why a kitchen could not be set up.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SetupError {
    /// Unknown pan.
    #[error("there is no pan \"{0}\"; there are: {1}")]
    NoSuchPan(String, String),
    /// Unknown food.
    #[error("there is no food \"{0}\"; there are: {1}")]
    NoSuchFood(String, String),
    /// A piece that cannot be built.
    #[error(transparent)]
    Build(#[from] BuildError),
}

impl Kitchen {
    /// A pan at one temperature [K] on a cold hob.
    pub fn new(library: &Library, pan_kind: &str, pan_temperature: f64) -> Result<Self, SetupError> {
        let description = library
            .pans
            .get(pan_kind)
            .ok_or_else(|| SetupError::NoSuchPan(pan_kind.into(), Library::names(&library.pans)))?;
        let pan = PanModel::build(description, &library.hob).map_err(BuildError::from)?;
        let state = pan.at(pan_temperature, &library.room, &library.hob);
        Ok(Self {
            stored_at_start: pan.stored(&state),
            foods_at_start: 0.0,
            pan_flow: vec![0.0; state.temperature.len()],
            covered: vec![0.0; state.temperature.len()],
            pan: state,
            pan_solver: PanSolver::default(),
            pieces: Vec::new(),
            hob_w: 0.0,
            cloth: None,
            tick: 0,
            flows: Energy::default(),
            puddle_vapour: 0.0,
            cloth_vapour: 0.0,
            fixed: Arc::new(Fixed { room: library.room.clone(), hob: library.hob.clone(), pan }),
        })
    }

    /// Cuts a piece; it waits at its start temperature until it is put into the pan.
    pub fn add(&mut self, library: &Library, order: &PieceOrder) -> Result<(), SetupError> {
        let food = library
            .foods
            .get(&order.kind)
            .ok_or_else(|| SetupError::NoSuchFood(order.kind.clone(), Library::names(&library.foods)))?;
        let kinetics = &library.kinetics[&food.kinetics];
        let spec = PieceSpec {
            size: order.size,
            seed: order.seed,
            coarseness: order.coarseness,
            mesh: MeshSize::Default,
            rules: order.rules,
        };
        let model = Arc::new(FoodModel::build(food, kinetics, &library.components, &spec)?);
        let room = self.fixed.room.temperature();
        let piece = Piece::new(order.id.clone(), order.kind.clone(), order.seed, model, order.temperature, room);
        self.foods_at_start += piece.state.total_enthalpy();
        self.pieces.push(piece);
        Ok(())
    }

    /// Removes a piece altogether, with what it stores.
    pub fn remove(&mut self, id: &str) {
        if let Some(i) = self.pieces.iter().position(|p| p.id == id) {
            let piece = self.pieces.remove(i);
            self.foods_at_start -= piece.state.total_enthalpy();
        }
    }

    /// Carries out a command, or says why not.
    pub fn apply(&mut self, command: &Command) -> Result<(), Refused> {
        match command {
            Command::Hob(power) => self.set_hob(*power),
            Command::Put { food, at } => self.put(food, *at),
            Command::Flip { food } => self.flip(food),
            Command::Rest { food, on } => {
                let room = self.fixed.room.clone();
                let piece = self.piece_mut(food)?;
                if piece.place == Place::Waiting {
                    return Err(Refused::NotInPan(food.clone()));
                }
                piece.rest(*on, &room);
                Ok(())
            }
            Command::MovePan { at, lift } => self.move_pan(PanPose { at: *at, lift: *lift }),
            Command::Cool { for_s } => {
                self.cool_at_once();
                let fresh = Cloth::fresh(&self.fixed.room.cloth, self.fixed.room.temperature(), *for_s);
                self.cloth.get_or_insert(fresh).remaining_s = *for_s;
                Ok(())
            }
        }
    }

    /// Under the rules of 2013 the pan is cool as soon as it touches the cloth.
    fn cool_at_once(&mut self) {
        if self.rules() == Rules::Paper2013 {
            let fixed = Arc::clone(&self.fixed);
            let before = fixed.pan.stored(&self.pan);
            let cool = kelvin(fixed.room.rules_2013.cloth_c);
            self.pan.temperature.iter_mut().for_each(|t| *t = t.min(cool));
            self.flows.other += before - fixed.pan.stored(&self.pan);
        }
    }

    /// The rules that the pieces follow: those of 2013 if any piece does.
    pub fn rules(&self) -> Rules {
        let simple = self.pieces.iter().any(|p| p.model.rules == Rules::Paper2013);
        if simple { Rules::Paper2013 } else { Rules::Full }
    }

    fn set_hob(&mut self, power: f64) -> Result<(), Refused> {
        let largest = self.fixed.hob.coil.largest_w;
        if !(0.0..=largest).contains(&power) {
            return Err(Refused::Power { largest_w: largest as i64 });
        }
        self.hob_w = power;
        Ok(())
    }

    fn move_pan(&mut self, pose: PanPose) -> Result<(), Refused> {
        let reach = 0.0..=FARTHEST_PAN;
        if !reach.contains(&pose.lift) || !reach.contains(&libm::hypot(pose.at[0], pose.at[1])) {
            return Err(Refused::PanPlace { farthest_mm: libm::round(FARTHEST_PAN * 1e3) as i64 });
        }
        let fixed = Arc::clone(&self.fixed);
        fixed.pan.place(&mut self.pan, &fixed.hob, pose);
        Ok(())
    }

    fn put(&mut self, food: &str, at: [f64; 2]) -> Result<(), Refused> {
        let floor = self.fixed.pan.description.floor.radius_mm * 1e-3;
        let fixed = Arc::clone(&self.fixed);
        let index = self.index(food)?;
        if self.pieces[index].in_pan() {
            return Err(Refused::AlreadyInPan(food.into()));
        }
        let reach = self.pieces[index]
            .model
            .outline
            .points
            .iter()
            .map(|p| libm::hypot(p[0] + at[0], p[1] + at[1]))
            .fold(0.0, f64::max);
        if reach > floor {
            let mm = |v: f64| libm::ceil(v * 1e3) as i64;
            return Err(Refused::DoesNotFit { food: food.into(), reach_mm: mm(reach), floor_mm: mm(floor) });
        }
        if let Some(other) = self.pieces.iter().find(|p| overlaps(p, &self.pieces[index], at)) {
            return Err(Refused::Occupied { food: food.into(), other: other.id.clone() });
        }
        self.pieces[index].lay(&fixed.pan, &fixed.room, at);
        Ok(())
    }

    fn flip(&mut self, food: &str) -> Result<(), Refused> {
        let fixed = Arc::clone(&self.fixed);
        let now = self.time_s();
        let piece = self.piece_mut(food)?;
        let Place::Pan(at) = piece.place else { return Err(Refused::NotInPan(food.into())) };
        piece.turn_over();
        piece.flipped_at = Some(now);
        piece.lay(&fixed.pan, &fixed.room, at);
        Ok(())
    }

    /// Moves the world by one tick.
    pub fn step(&mut self) {
        let fixed = Arc::clone(&self.fixed);
        self.pan_flow.fill(0.0);
        self.covered.fill(0.0);
        let time = self.time_s() + TICK_S;
        for index in 0..self.pieces.len() {
            self.step_piece(&fixed, index, time);
        }
        let load = PanLoad {
            hob: &fixed.hob,
            room: &fixed.room,
            hob_w: self.hob_w,
            time: self.time_s(),
            food: &self.pan_flow,
            covered: &self.covered,
        };
        let exchange = fixed.pan.advance(&mut self.pan, &mut self.pan_solver, &load, &mut self.cloth, TICK_S);
        self.flows.hob += exchange.hob;
        self.flows.air += exchange.air;
        self.flows.other += exchange.other;
        self.cloth_vapour = exchange.cloth_vapour / TICK_S;
        self.boil_puddle(exchange.puddle);
        self.lift_off_cloth();
        self.tick += 1;
    }

    fn step_piece(&mut self, fixed: &Fixed, index: usize, time: f64) {
        let piece = &mut self.pieces[index];
        let exchange = piece.advance(&fixed.pan, &self.pan, &fixed.room, TICK_S);
        self.flows.air += exchange.air;
        self.flows.evaporation += exchange.evaporation;
        let taken: f64 = piece.solver.contact_heat.iter().sum();
        match (piece.place, &piece.patches) {
            (Place::Pan(_), Some(patches)) => {
                let lateral = piece.state.stretch.lateral;
                for (&patch, located) in patches.below.iter().zip(&patches.located) {
                    let area = piece.model.patches[patch].area * lateral * lateral;
                    for k in 0..3 {
                        let node = located.nodes[k] as usize;
                        self.pan_flow[node] += located.weights[k] * piece.solver.contact_heat[patch] / TICK_S;
                        self.covered[node] += located.weights[k] * area / fixed.pan.section.areas[node];
                    }
                }
                self.pan.puddle += exchange.drip.mass;
                self.pan.puddle_enthalpy += exchange.drip.enthalpy;
                self.pan.oil += exchange.rendered.mass;
                self.flows.other += exchange.drip.enthalpy + exchange.rendered.enthalpy;
            }
            (Place::Rest(_), _) => self.flows.other += exchange.drip.enthalpy + exchange.rendered.enthalpy - taken,
            _ => {}
        }
        self.covered.iter_mut().for_each(|c| *c = c.min(1.0));
        let core = piece.core();
        if core > piece.core_peak.0 {
            piece.core_peak = (core, time);
        }
    }

    /// Gives heat to the juice in the pan; what exceeds 100 °C boils off [J].
    fn boil_puddle(&mut self, heat: f64) {
        self.puddle_vapour = 0.0;
        if self.pan.puddle <= 0.0 {
            return;
        }
        self.pan.puddle_enthalpy += heat;
        self.flows.other += heat;
        let boiling = kelvin(100.0);
        let liquid = PUDDLE_SPECIFIC_HEAT * 100.0;
        let excess = self.pan.puddle_enthalpy - self.pan.puddle * liquid;
        if excess > 0.0 {
            let mass = (excess / latent_heat(boiling)).min(self.pan.puddle);
            let enthalpy =
                if mass < self.pan.puddle { mass * (liquid + latent_heat(boiling)) } else { self.pan.puddle_enthalpy };
            self.pan.puddle -= mass;
            self.pan.puddle_enthalpy -= enthalpy;
            self.flows.other -= enthalpy;
            self.flows.evaporation += enthalpy;
            self.puddle_vapour = mass / TICK_S;
        }
    }

    fn lift_off_cloth(&mut self) {
        if let Some(cloth) = &mut self.cloth {
            cloth.remaining_s -= TICK_S;
            if cloth.remaining_s < 0.5 * TICK_S {
                self.cloth = None;
            }
        }
    }

    fn index(&self, id: &str) -> Result<usize, Refused> {
        self.pieces.iter().position(|p| p.id == id).ok_or_else(|| Refused::NoSuchFood(id.into()))
    }

    fn piece_mut(&mut self, id: &str) -> Result<&mut Piece, Refused> {
        let index = self.index(id)?;
        Ok(&mut self.pieces[index])
    }

    /// Simulated time [s].
    pub fn time_s(&self) -> f64 {
        self.tick as f64 * TICK_S
    }

    /// Ticks since the start.
    pub fn tick(&self) -> u64 {
        self.tick
    }

    /// All pieces.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// A piece by name.
    pub fn piece(&self, id: &str) -> Option<&Piece> {
        self.pieces.iter().find(|p| p.id == id)
    }

    /// Electrical power that is set [W].
    pub fn hob_w(&self) -> f64 {
        self.hob_w
    }

    /// Mean electrical power that is drawn: none while the pan is off the hob or the hob's limit holds, less beside the
    /// ring [W].
    pub fn drawn_w(&self) -> f64 {
        let off = self.cloth.is_some() || self.pan.limited;
        if off { 0.0 } else { self.hob_w * self.pan.ring_shares.iter().sum::<f64>() }
    }

    /// Area mean of the pan's flat floor [K].
    pub fn pan_temperature(&self) -> f64 {
        self.fixed.pan.floor_temperature(&self.pan)
    }

    /// What never changes in the pan.
    pub fn pan_model(&self) -> &PanModel {
        &self.fixed.pan
    }

    /// What changes in the pan.
    pub fn pan_state(&self) -> &PanState {
        &self.pan
    }

    /// The room.
    pub fn room(&self) -> &Room {
        &self.fixed.room
    }

    /// The hob.
    pub fn hob(&self) -> &HobDescription {
        &self.fixed.hob
    }

    /// The cloth, while the pan stands on it.
    pub fn cloth(&self) -> Option<&Cloth> {
        self.cloth.as_ref()
    }

    /// Vapour from juice in the pan and from the cloth [kg/s].
    pub fn other_vapour(&self) -> (f64, f64) {
        (self.puddle_vapour, self.cloth_vapour)
    }

    /// Where the energy went since the start.
    pub fn energy(&self) -> Energy {
        let foods: f64 = self.pieces.iter().map(|p| p.state.total_enthalpy()).sum();
        Energy {
            pan_stored: self.fixed.pan.stored(&self.pan) - self.stored_at_start,
            food_stored: foods - self.foods_at_start,
            ..self.flows
        }
        .balanced()
    }
}

/// How far the pan may be moved or lifted [m] (chosen: within reach).
const FARTHEST_PAN: f64 = 0.5;

/// Specific heat with which the puddle's temperature is reckoned [J/(kg·K)] (water, standard tables).
pub(crate) const PUDDLE_SPECIFIC_HEAT: f64 = 4190.0;

fn overlaps(lying: &Piece, new: &Piece, at: [f64; 2]) -> bool {
    let Place::Pan(there) = lying.place else { return false };
    let inside = |p: &[f64; 2]| lying.model.outline.contains([p[0] + at[0] - there[0], p[1] + at[1] - there[1]]);
    lying.id != new.id && (new.model.outline.points.iter().step_by(8).any(inside) || inside(&[0.0, 0.0]))
}
