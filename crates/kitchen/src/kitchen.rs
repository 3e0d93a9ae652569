//! The facade of the crate: one kitchen with its hob, pan, foods and time.

use std::sync::Arc;

use saute_food::body::halving::CutError;
use saute_food::{BuildError, FoodModel, MeshSize, OutlineKind, PieceSpec, Rules};
use serde::{Deserialize, Serialize};

use crate::bytes::{FoodKey, Models};
use crate::data::library::Library;
use crate::data::room::Room;
use crate::dynamics::{Gesture, Hand, PanShape, Pose, Task, World};
use crate::hands::command::{Command, Refused};
use crate::hands::pan_hold::PanHold;
use crate::hands::second_hand::SecondHand;
use crate::kelvin;
use crate::pan::cloth::Cloth;
use crate::pan::food_load::FoodLoad;
use crate::pan::hob::HobDescription;
use crate::pan::hold::{HoldControl, Holding};
use crate::pan::pan_model::{PanModel, PanSolver, PanState};
use crate::piece::food_contact::Touching;
use crate::piece::layout::{Floor, Footprint};
use crate::piece::memory::{Load, NoRoom};
use crate::piece::piece_state::{Piece, Place};
use crate::piece::work;
use crate::tick::clock::Clock;
use crate::tick::energy::{Energy, EnergyAccount};
use crate::tick::event::EventLog;
use saute_schema::LibraryError;

/// Immutable model of a kitchen.
#[derive(Clone, Debug)]
pub(crate) struct Fixed {
    /// Kind of the pan.
    pub(crate) pan_kind: String,
    /// Hash of the data files of pan and kitchen.
    pub(crate) data_hash: u64,
    /// The text of the file that states the kitchen at home, unless it is the program's own.
    pub(crate) home: Option<Arc<str>>,
    pub(crate) room: Room,
    pub(crate) hob: HobDescription,
    pub(crate) pan: PanModel,
}

/// Order for a piece of food.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct PieceOrder {
    /// Name in recipes.
    pub id: String,
    /// Kind of food.
    pub kind: String,
    /// Length, width and thickness [m].
    pub size: [f64; 3],
    /// Start temperature [K].
    pub temperature: f64,
    /// Seed of its natural variation.
    pub seed: u64,
    /// Mesh spacing relative to the default [-].
    pub coarseness: f64,
    /// Rules of heat and water transfer that it follows.
    pub rules: Rules,
    /// Fineness of its mesh.
    pub mesh: MeshSize,
    /// Its outline: natural or plain.
    pub outline: OutlineKind,
}

impl PieceOrder {
    /// Finest and coarsest mesh that may be ordered [-] (chosen: half the default spacing shows whether a result has settled,
    /// at sixteen times the work or more).
    pub const COARSENESS: core::ops::RangeInclusive<f64> = 0.5..=8.0;
    /// Temperatures at which food may begin [°C] (chosen: from below a freezer's −18 °C to what is kept warm).
    pub const INITIAL_C: [f64; 2] = [-25.0, 60.0];

    /// Refuses a start or a mesh beyond their ranges, before anything is built.
    fn check(&self) -> Result<(), SetupError> {
        let food = || self.id.clone();
        let [low, high] = Self::INITIAL_C.map(kelvin);
        if !(low - ROUNDING_K..=high + ROUNDING_K).contains(&self.temperature) {
            return Err(SetupError::Temperature { food: food() });
        }
        if Self::COARSENESS.contains(&self.coarseness) { Ok(()) } else { Err(SetupError::Coarseness { food: food() }) }
    }

    /// Returns what its model is built from, apart from the food.
    pub fn spec(&self) -> PieceSpec {
        PieceSpec {
            size: self.size,
            seed: self.seed,
            coarseness: self.coarseness,
            mesh: self.mesh,
            rules: self.rules,
            outline: self.outline,
            pool: None,
        }
    }
}

/// Miss of a temperature's range by the change of its unit [K].
const ROUNDING_K: f64 = 1e-9;

/// Vapour flows in the last tick that come from no food [kg/s].
#[derive(Clone, Copy, Debug, Default, Deserialize, Serialize)]
pub(crate) struct OtherVapour {
    /// From water in the pan.
    pub(crate) puddle: f64,
    /// From the cloth.
    pub(crate) cloth: f64,
}

/// The state of one cook: hob, pan, liquids, foods, tools and time.
#[derive(Clone, Debug)]
pub struct Kitchen {
    pub(crate) fixed: Arc<Fixed>,
    pub(crate) clock: Clock,
    pub(crate) hob_w: f64,
    pub(crate) hold: HoldControl,
    pub(crate) pan: PanState,
    pub(crate) pan_solver: PanSolver,
    pub(crate) cloth: Option<Cloth>,
    pub(crate) load: FoodLoad,
    pub(crate) vapour: OtherVapour,
    pub(crate) pieces: Vec<Piece>,
    pub(crate) next_key: u32,
    /// Pairs of pieces in contact.
    pub(crate) touching: Vec<Touching>,
    /// The rigid bodies.
    pub(crate) world: World,
    pub(crate) pan_hold: PanHold,
    pub(crate) second_hand: SecondHand,
    pub(crate) account: EnergyAccount,
    pub(crate) events: EventLog,
    /// Commands carried out since they were last taken; `None` unless they are listened to.
    pub(crate) carried_out: Option<Vec<Command>>,
}

/// Reason why a kitchen cannot be set up.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SetupError {
    /// Unknown pan.
    #[error("there is no pan \"{0}\"; there are: {1}")]
    NoSuchPan(String, String),
    /// Unknown food.
    #[error("there is no food \"{0}\"; there are: {1}")]
    NoSuchFood(String, String),
    /// A food begins colder or hotter than food can.
    #[error("\"{food}\" cannot begin with this temperature: food begins with {} to {} °C", PieceOrder::INITIAL_C[0], PieceOrder::INITIAL_C[1])]
    Temperature {
        /// Its name.
        food: String,
    },
    /// A mesh is finer or coarser than any that may be ordered.
    #[error("\"{food}\" cannot have this mesh: its spacing is {} to {} times the default", PieceOrder::COARSENESS.start(), PieceOrder::COARSENESS.end())]
    Coarseness {
        /// Its name.
        food: String,
    },
    /// A food begins as ice whose file does not state how it freezes, or by rules without ice.
    #[error("\"{0}\" cannot begin below 0 °C: its file has no table [freezing], or it follows the rules of 2013")]
    NoIce(String),
    /// A food has no room.
    #[error(transparent)]
    NoRoom(#[from] NoRoom),
    /// An oil that every kitchen needs is set aside.
    #[error(transparent)]
    Oil(#[from] LibraryError),
    /// The cut of a halved piece misses it.
    #[error(transparent)]
    Cut(CutError),
    /// The model of a piece or of the pan cannot be built.
    #[error(transparent)]
    Build(#[from] BuildError),
}

fn no_such_food(library: &Library, kind: &str) -> SetupError {
    SetupError::NoSuchFood(kind.to_owned(), Library::names(&library.foods))
}

/// Builds the model of a piece.
pub(crate) fn built(library: &Library, kind: &str, spec: &PieceSpec) -> Result<FoodModel, SetupError> {
    let food = library.foods.get(kind).ok_or_else(|| no_such_food(library, kind))?;
    Ok(FoodModel::build(food, &library.kinetics[&food.kinetics], &library.components, spec)?)
}

impl Fixed {
    /// Builds the model of a kitchen with a pan.
    pub(crate) fn build(library: &Library, pan_kind: &str) -> Result<Self, SetupError> {
        library.check_oils()?;
        let description = library
            .pans
            .get(pan_kind)
            .ok_or_else(|| SetupError::NoSuchPan(pan_kind.into(), Library::names(&library.pans)))?;
        Ok(Self {
            pan_kind: pan_kind.to_owned(),
            data_hash: library.pan_hash(pan_kind),
            home: library.home.clone(),
            pan: PanModel::build(description, library).map_err(BuildError::from)?,
            room: library.room.clone(),
            hob: library.hob.clone(),
        })
    }
}

impl Kitchen {
    /// Sets up a kitchen with a pan at a uniform temperature [K] on a cold hob.
    ///
    /// The pan has the oil of every cook that states none, [`Self::usual_oil`].
    pub fn new(library: &Library, pan_kind: &str, pan_temperature: f64) -> Result<Self, SetupError> {
        Self::with_oil(library, pan_kind, pan_temperature, Self::usual_oil(library))
    }

    /// Oil in a pan without a stated amount [kg].
    pub fn usual_oil(library: &Library) -> f64 {
        1e-3 * library.room.contact.oil_g
    }

    /// Sets up a kitchen with a pan at a uniform temperature [K] and with oil [kg] on a cold hob. A seasoned pan has its film at
    /// least.
    pub fn with_oil(library: &Library, pan_kind: &str, pan_temperature: f64, oil: f64) -> Result<Self, SetupError> {
        let fixed = Fixed::build(library, pan_kind)?;
        let state = fixed.pan.at(pan_temperature, oil, &fixed.room, &fixed.hob);
        let world = World::new(PanShape::of(&fixed.pan.description));
        Ok(Self {
            clock: Clock::default(),
            hob_w: 0.0,
            hold: HoldControl::default(),
            pan_solver: PanSolver::default(),
            cloth: None,
            load: FoodLoad::none(state.temperature.len()),
            vapour: OtherVapour::default(),
            pieces: Vec::new(),
            next_key: 0,
            touching: Vec::new(),
            pan_hold: PanHold::at(world.motion.pose),
            world,
            second_hand: SecondHand::default(),
            account: EnergyAccount::new(fixed.pan.stored(&state)),
            events: EventLog::default(),
            carried_out: None,
            pan: state,
            fixed: Arc::new(fixed),
        })
    }

    /// Adds a piece. It waits at its start temperature, without heat exchange, until it is put into the pan.
    pub fn add(&mut self, library: &Library, order: &PieceOrder) -> Result<(), SetupError> {
        self.add_with(library, order, &mut Models::default())
    }

    /// Checks that pieces that are ordered fit beside those that are there, without building one.
    ///
    /// # Errors
    ///
    /// If they do not fit, or if a food has no piece of that size.
    pub fn check_all_fit(&self, library: &Library, orders: &[PieceOrder]) -> Result<(), SetupError> {
        let mut load = Load::of(self.pieces.iter().map(|piece| &*piece.model));
        for order in orders {
            let food = library.foods.get(&order.kind).ok_or_else(|| no_such_food(library, &order.kind))?;
            load.add(&order.id, &order.spec(), food, 1)?;
        }
        Ok(())
    }

    /// Builds the model of a piece into known models, where [`Self::add_with`] finds it.
    ///
    /// # Errors
    ///
    /// If there is no such food, or if it cannot be built.
    pub fn prepare(&self, library: &Library, order: &PieceOrder, models: &mut Models) -> Result<(), SetupError> {
        order.check()?;
        models.food(&FoodKey::ordered(order, library), &self.fixed, library).map(drop)
    }

    /// Adds a piece, with known models, to which one that had to be built is added.
    pub fn add_with(&mut self, library: &Library, order: &PieceOrder, models: &mut Models) -> Result<(), SetupError> {
        order.check()?;
        let food = library.foods.get(&order.kind).ok_or_else(|| no_such_food(library, &order.kind))?;
        if order.temperature < kelvin(0.0) && !food.may_be_ice(order.rules) {
            return Err(SetupError::NoIce(order.kind.clone()));
        }
        self.check_all_fit(library, std::slice::from_ref(order))?;
        let food = FoodKey::ordered(order, library);
        let parts = models.food(&food, &self.fixed, library)?;
        let piece = Piece::new((order, food.data_hash), self.next_key, parts, &self.fixed.room);
        if !(piece.state.total_enthalpy().is_finite() && piece.mass() > 0.0 && piece.mass().is_finite()) {
            return Err(BuildError::NotFinite.into());
        }
        work::check(&piece.model, order.coarseness)?;
        self.next_key += 1;
        self.account.add_food(piece.state.total_enthalpy());
        self.pieces.push(piece);
        Ok(())
    }

    /// Removes a piece and the energy stored in it.
    pub fn remove(&mut self, id: &str) {
        if let Some(i) = self.pieces.iter().position(|p| p.id == id) {
            let piece = self.pieces.remove(i);
            self.world.remove(piece.key);
            self.touching.retain(|t| !t.pair.contains(&piece.key));
            self.account.remove_food(piece.state.total_enthalpy());
        }
    }

    /// Returns the rules in force: those of 2013 if any piece follows them.
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

    /// Returns true while a gesture, a tool or a queued task is active.
    pub fn busy(&self) -> bool {
        self.pan_hold.gesture.is_some() || self.second_hand.is_busy()
    }

    /// Returns true while a task of the hand is under way or waits; a tool that a person moves is none.
    pub fn has_task(&self) -> bool {
        self.second_hand.has_order()
    }

    /// Returns true while a task of the hand is under way or waits, or a tool holds a piece.
    pub fn is_moving_food(&self) -> bool {
        self.has_task() || self.pieces.iter().any(|p| p.place == Place::Held)
    }

    /// The rigid bodies.
    pub fn world(&self) -> &World {
        &self.world
    }

    /// Names of the pieces whose tasks failed because the tool was blocked, in order of failure.
    pub fn blocked(&self) -> Vec<String> {
        let name = |task: &Task| self.pieces.iter().find(|p| p.key == task.key()).map(|p| p.id.clone());
        self.second_hand.blocked.iter().filter_map(name).collect()
    }

    /// The hand with its tool.
    pub fn hand(&self) -> &Hand {
        &self.second_hand.hand
    }

    /// Pose at which the pan is held between gestures.
    pub fn held_pan(&self) -> Pose {
        self.pan_hold.pose
    }

    /// The pan's gesture while it lasts.
    pub fn gesture(&self) -> Option<Gesture> {
        self.pan_hold.gesture.map(|(gesture, _)| gesture)
    }

    /// Returns true if the last frame ended a tick; a recipe carries out its steps only then.
    pub fn is_between_ticks(&self) -> bool {
        self.clock.is_between_ticks()
    }

    /// Returns true if all bodies sleep, so that they cost no computation.
    pub fn bodies_sleep(&self) -> bool {
        self.world.is_settled()
    }

    /// Enables or disables sleeping of bodies at rest; it is enabled by default. A sleeping body costs no computation.
    pub fn set_sleeping(&mut self, may_sleep: bool) {
        self.world.set_sleeping(may_sleep);
    }

    /// Free places on the pan's floor for pieces, in their order, starting nearest to `around` [m]. Returns fewer places
    /// than pieces if not all fit. Other pieces in the pan keep their places.
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
        self.clock.time_s()
    }

    /// Ticks since the start.
    pub fn tick(&self) -> u64 {
        self.clock.tick()
    }

    /// Frames since the start: commands take effect between two of them.
    pub fn frame(&self) -> u64 {
        self.clock.frames()
    }

    /// Begins to keep the commands that are carried out, for [`Self::take_carried_out`].
    pub fn listen(&mut self) {
        self.carried_out.get_or_insert_default();
    }

    /// Returns the commands that were carried out since the last call, by whomever; none before [`Self::listen`].
    pub fn take_carried_out(&mut self) -> Vec<Command> {
        self.carried_out.as_mut().map(core::mem::take).unwrap_or_default()
    }

    /// All pieces.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// A piece by name.
    pub fn piece(&self, id: &str) -> Option<&Piece> {
        self.pieces.iter().find(|p| p.id == id)
    }

    /// Electrical power to which the hob is set [W]; the largest one if it keeps the pan at a temperature.
    pub fn hob_w(&self) -> f64 {
        self.hob_w
    }

    /// Temperature at which the hob keeps the pan [K]; none if it gives the power to which it is set.
    pub fn hob_holds(&self) -> Option<f64> {
        self.hold.target()
    }

    /// State of a hob that keeps a temperature, as it reports it; none if it gives the power to which it is set.
    pub fn holding(&self) -> Option<Holding> {
        self.hold.holding()
    }

    /// Mean power that the hob draws from mains or gas pipe [W]. One that detects pans draws none while the pan stands on the
    /// cloth, less near the temperature limit and while the pan is lifted or off the ring; by the rules of 2013 the limit
    /// switches it off. Other stoves draw what they are set to, unless their limit keeps them off.
    pub fn hob_drawn_w(&self) -> f64 {
        if self.fixed.hob.electronics().is_none() {
            return if self.pan.limited { 0.0 } else { self.hob_w };
        }
        let off = self.cloth.is_some() || (self.pan.limited && self.rules() == Rules::Paper2013);
        if off { 0.0 } else { self.hob_power() * self.pan.ring_shares.iter().sum::<f64>() }
    }

    /// Power of the hob over a pan on its ring: that which keeps the pan at its temperature, or the set one, up to the limit [W].
    pub(crate) fn hob_power(&self) -> f64 {
        let share = if self.rules() == Rules::Paper2013 { 1.0 } else { self.hold.limit_share() };
        share * self.hold.power(self.hob_w)
    }

    /// Area mean of the pan's flat floor [K].
    pub fn pan_temperature(&self) -> f64 {
        self.fixed.pan.floor_temperature(&self.pan)
    }

    /// Temperature of the hottest place of the pan's floor [K].
    pub fn hottest_temperature(&self) -> f64 {
        self.pan.temperature.iter().take(self.fixed.pan.floor_nodes).copied().fold(0.0, f64::max)
    }

    /// The pan's immutable model.
    pub fn pan_model(&self) -> &PanModel {
        &self.fixed.pan
    }

    /// The pan's state.
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

    /// The wet cloth while the pan stands on it.
    pub fn cloth(&self) -> Option<&Cloth> {
        self.cloth.as_ref()
    }

    /// Events since the start.
    pub fn events(&self) -> &EventLog {
        &self.events
    }

    /// Vapour flows from water in the pan and from the cloth [kg/s].
    pub fn other_vapour(&self) -> (f64, f64) {
        (self.vapour.puddle, self.vapour.cloth)
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
        self.account.balance(self.fixed.pan.stored(&self.pan), foods)
    }
}
