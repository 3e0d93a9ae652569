//! The whole world: hob, pan, foods, time.

use std::collections::VecDeque;
use std::sync::Arc;

use saute_food::{BuildError, FoodModel, MeshSize, PieceSpec, Rules};

use crate::data::library::Library;
use crate::data::room::Room;
use crate::dynamics::{Gesture, Hand, PanShape, Pose, Task, World};
use crate::hands::command::Refused;
use crate::hands::lead::Led;
use crate::pan::cloth::Cloth;
use crate::pan::hob::HobDescription;
use crate::pan::pan_model::{PanModel, PanSolver, PanState};
use crate::piece::food_contact::Touching;
use crate::piece::layout::{Floor, Footprint};
use crate::piece::piece_state::{Piece, Place};
use crate::tick::energy::Energy;
use crate::tick::event::EventLog;
use crate::{FRAME_S, TICK_S};

/// What never changes while cooking.
#[derive(Clone, Debug)]
pub(crate) struct Fixed {
    pub(crate) room: Room,
    pub(crate) hob: HobDescription,
    pub(crate) pan: PanModel,
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
    /// Fineness of its mesh.
    pub mesh: MeshSize,
}

/// The world of one cook.
#[derive(Clone, Debug)]
pub struct Kitchen {
    pub(crate) fixed: Arc<Fixed>,
    pub(crate) pan: PanState,
    pub(crate) pan_solver: PanSolver,
    pub(crate) pieces: Vec<Piece>,
    pub(crate) hob_w: f64,
    pub(crate) cloth: Option<Cloth>,
    pub(crate) tick: u64,
    /// Frames since the last tick.
    pub(crate) frame: u32,
    pub(crate) flows: Energy,
    stored_at_start: f64,
    foods_at_start: f64,
    pub(crate) pan_flow: Vec<f64>,
    pub(crate) covered: Vec<f64>,
    /// Steam that foods made at each node of the pan in this tick [kg].
    pub(crate) steam: Vec<f64>,
    pub(crate) events: EventLog,
    pub(crate) puddle_vapour: f64,
    pub(crate) cloth_vapour: f64,
    next_key: u32,
    /// The rigid bodies.
    pub(crate) world: World,
    /// The pan's velocity at the last tick [m/s].
    pub(crate) pan_velocity: glam::DVec3,
    /// Where the hand holds the pan when it makes no gesture.
    pub(crate) held_at: Pose,
    /// A gesture and the time since its start [s].
    pub(crate) gesture: Option<(Gesture, f64)>,
    /// The other hand, what it still has to do, and what it is doing.
    pub(crate) hand: Hand,
    pub(crate) tasks: VecDeque<Task>,
    pub(crate) at_work: Option<Task>,
    /// A tool that a person leads.
    pub(crate) led: Option<Led>,
    /// Foods that touch each other.
    pub(crate) touching: Vec<Touching>,
    /// Tasks that failed because something was in the way.
    pub(crate) blocked: Vec<Task>,
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
        let pan = PanModel::build(description, library).map_err(BuildError::from)?;
        let state = pan.at(pan_temperature, &library.room, &library.hob);
        let world = World::new(PanShape::of(description));
        Ok(Self {
            pan_velocity: glam::DVec3::ZERO,
            held_at: world.motion.pose,
            world,
            gesture: None,
            hand: Hand::default(),
            tasks: VecDeque::new(),
            at_work: None,
            led: None,
            touching: Vec::new(),
            blocked: Vec::new(),
            next_key: 0,
            frame: 0,
            stored_at_start: pan.stored(&state),
            foods_at_start: 0.0,
            pan_flow: vec![0.0; state.temperature.len()],
            steam: vec![0.0; state.temperature.len()],
            covered: vec![0.0; state.temperature.len()],
            pan: state,
            pan_solver: PanSolver::default(),
            pieces: Vec::new(),
            hob_w: 0.0,
            events: EventLog::default(),
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
            mesh: order.mesh,
            rules: order.rules,
        };
        let model = Arc::new(FoodModel::build(food, kinetics, &library.components, &spec)?);
        let names = (order.id.clone(), order.kind.clone());
        let piece = Piece::new(names, order.seed, self.next_key, model, order.temperature, &self.fixed.room);
        self.next_key += 1;
        self.foods_at_start += piece.state.total_enthalpy();
        self.pieces.push(piece);
        Ok(())
    }

    /// Removes a piece altogether, with what it stores.
    pub fn remove(&mut self, id: &str) {
        if let Some(i) = self.pieces.iter().position(|p| p.id == id) {
            let piece = self.pieces.remove(i);
            self.world.remove(piece.key);
            self.touching.retain(|t| !t.pair.contains(&piece.key));
            self.foods_at_start -= piece.state.total_enthalpy();
        }
    }

    /// The rules that the pieces follow: those of 2013 if any piece does.
    pub fn rules(&self) -> Rules {
        let simple = self.pieces.iter().any(|p| p.model.rules() == Rules::Paper2013);
        if simple { Rules::Paper2013 } else { Rules::Full }
    }

    pub(crate) fn index(&self, id: &str) -> Result<usize, Refused> {
        self.pieces.iter().position(|p| p.id == id).ok_or_else(|| Refused::NoSuchFood(id.into()))
    }

    pub(crate) fn piece_mut(&mut self, id: &str) -> Result<&mut Piece, Refused> {
        let index = self.index(id)?;
        Ok(&mut self.pieces[index])
    }

    /// Whether tools or gestures are still at work on what they were told to do.
    pub fn busy(&self) -> bool {
        self.gesture.is_some() || self.hand.is_active() || self.at_work.is_some() || !self.tasks.is_empty()
    }

    /// Books what the pan holds more than it did [J].
    pub(crate) fn bring(&mut self, stored: f64) {
        self.stored_at_start += stored;
    }

    /// The rigid bodies.
    pub fn world(&self) -> &World {
        &self.world
    }

    /// Names of the pieces with which the other hand failed because something was in the way, in order.
    pub fn blocked(&self) -> Vec<String> {
        let name = |task: &Task| self.pieces.iter().find(|p| p.key == task.key()).map(|p| p.id.clone());
        self.blocked.iter().filter_map(name).collect()
    }

    /// The hand with its tool.
    pub fn hand(&self) -> &Hand {
        &self.hand
    }

    /// Where the hand holds the pan when it makes no gesture.
    pub fn held_pan(&self) -> Pose {
        self.held_at
    }

    /// The pan's gesture, while it lasts.
    pub fn gesture(&self) -> Option<Gesture> {
        self.gesture.map(|(gesture, _)| gesture)
    }

    /// Whether the last frame ended a tick: what a recipe does, it does then.
    pub fn is_between_ticks(&self) -> bool {
        self.frame == 0
    }

    /// Whether bodies at rest stop being computed until something stirs them; they do unless told otherwise.
    pub fn let_sleep(&mut self, may_sleep: bool) {
        self.world.let_sleep(may_sleep);
    }

    /// Free places on the floor for pieces, in their order, the first ones nearest to `around` [m]; fewer than pieces where
    /// not all of them fit. What lies in the pan is left where it is, but for the pieces themselves.
    pub fn free_places(&self, foods: &[String], around: [f64; 2]) -> Vec<[f64; 2]> {
        let named = |p: &&Piece| foods.contains(&p.id);
        let lying = self.pieces.iter().filter(|p| !named(p)).filter_map(|p| match p.place {
            Place::Pan(at) => Some((p.footprint(), at)),
            _ => None,
        });
        let wanted: Vec<Footprint> = foods.iter().filter_map(|id| self.piece(id)).map(Piece::footprint).collect();
        Floor::new(self.fixed.pan.description.floor.radius_mm * 1e-3, lying.collect()).places(&wanted, around)
    }

    /// Simulated time [s].
    pub fn time_s(&self) -> f64 {
        self.tick as f64 * TICK_S + f64::from(self.frame) * FRAME_S
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
    pub fn hob_drawn_w(&self) -> f64 {
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

    /// What happened since the start.
    pub fn events(&self) -> &EventLog {
        &self.events
    }

    /// Vapour from water in the pan and from the cloth [kg/s].
    pub fn other_vapour(&self) -> (f64, f64) {
        (self.puddle_vapour, self.cloth_vapour)
    }

    /// Energy account since the start [J].
    ///
    /// ```
    /// use saute_kitchen::{Command, Kitchen, Library, kelvin};
    ///
    /// let mut kitchen = Kitchen::new(&Library::embedded()?, "cast-iron-26", kelvin(20.0))?;
    /// kitchen.apply(&Command::Hob(1000.0))?;
    /// (0..100).for_each(|_| kitchen.step());
    /// let energy = kitchen.energy();
    /// assert!((energy.hob - 10e3).abs() < 1.0);
    /// assert!(energy.imbalance.abs() < 1e-6 * energy.hob);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
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
