//! A piece of food with its place in the kitchen.

use std::sync::Arc;

use saute_food::{Down, Exchange, FoodModel, FoodSolver, FoodState, FreeAir, Side, Surroundings};

use crate::board::Board;
use crate::command::RestOn;
use crate::contact::{ContactPatches, conductance, mean_gap};
use crate::pan::{PanModel, PanState};
use crate::room::Room;

/// Where a piece is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    /// Waiting at its start temperature; nothing happens to it.
    Waiting,
    /// In the pan, centroid at this point relative to the pan's centre [m].
    Pan([f64; 2]),
    /// Resting.
    Rest(RestOn),
}

/// A piece: its model, state and place.
#[derive(Clone, Debug)]
pub struct Piece {
    /// Name in recipes.
    pub id: String,
    /// Kind of food.
    pub kind: String,
    /// Seed of its natural variation.
    pub seed: u64,
    /// What never changes.
    pub model: Arc<FoodModel>,
    /// What changes.
    pub state: FoodState,
    /// Where it is.
    pub place: Place,
    /// Time since its lower face was laid down [s].
    pub since_contact: f64,
    /// Time of the last flip [s].
    pub flipped_at: Option<f64>,
    /// Highest core temperature [K] and when [s].
    pub core_peak: (f64, f64),
    /// Vapour given off in the last tick [kg/s].
    pub vapour_flow: f64,
    pub(crate) patches: Option<Arc<ContactPatches>>,
    pub(crate) solver: FoodSolver,
    board: Board,
    conductance: Vec<f64>,
    below: Vec<f64>,
}

impl Piece {
    /// A waiting piece at one temperature [K].
    pub fn new(id: String, kind: String, seed: u64, model: Arc<FoodModel>, temperature: f64, room: f64) -> Self {
        Self {
            state: FoodState::raw(&model, temperature),
            core_peak: (temperature, 0.0),
            place: Place::Waiting,
            since_contact: 0.0,
            flipped_at: None,
            vapour_flow: 0.0,
            patches: None,
            solver: FoodSolver::default(),
            board: Board::at(room),
            conductance: Vec::new(),
            below: Vec::new(),
            id,
            kind,
            seed,
            model,
        }
    }

    /// Whether it lies in the pan.
    pub fn in_pan(&self) -> bool {
        matches!(self.place, Place::Pan(_))
    }

    /// Core temperature [K].
    pub fn core(&self) -> f64 {
        self.model.core_temperature(&self.state)
    }

    /// Area-mean temperature of the face that lies below (`true`) or above [K].
    pub fn face(&self, below: bool) -> f64 {
        let side = if below { self.state.down } else { self.state.down.opposite() };
        self.model.face_temperature(&self.state, side)
    }

    /// Mass [kg].
    pub fn mass(&self) -> f64 {
        self.state.mass(&self.model)
    }

    /// Steps into which the last tick was divided.
    pub fn substeps(&self) -> u32 {
        self.solver.substeps
    }

    pub(crate) fn lay(&mut self, pan: &PanModel, room: &Room, at: [f64; 2]) {
        self.place = Place::Pan(at);
        self.since_contact = 0.0;
        let flipped = self.state.down == Side::Top;
        let section = &self.model.mesh.section;
        let patches = ContactPatches::lay(section, &pan.section, &pan.locator, at, flipped, &room.contact, self.seed);
        self.patches = Some(Arc::new(patches));
    }

    pub(crate) fn rest(&mut self, on: RestOn, room: &Room) {
        self.place = Place::Rest(on);
        self.since_contact = 0.0;
        self.patches = None;
        self.board = Board::at(room.temperature());
    }

    /// One tick; returns what passed and, per unit of the section, leaves the heat taken in the solver.
    pub(crate) fn advance(&mut self, pan: &PanModel, pan_state: &PanState, room: &Room, dt: f64) -> Exchange {
        let exchange = match self.place {
            Place::Waiting => return Exchange::default(),
            Place::Pan(_) => self.fry(pan, pan_state, room, dt),
            Place::Rest(on) => self.stand(on, room, dt),
        };
        self.since_contact += dt;
        self.vapour_flow = exchange.evaporated / dt;
        exchange
    }

    fn fry(&mut self, pan: &PanModel, pan_state: &PanState, room: &Room, dt: f64) -> Exchange {
        let Some(patches) = self.patches.clone() else { return Exchange::default() };
        let gap = mean_gap(&room.contact, self.since_contact);
        let coating = pan.description.coating_w_m2k.unwrap_or(f64::INFINITY);
        self.conductance.clear();
        self.conductance.extend(patches.unevenness.iter().map(|u| conductance(&room.contact, gap + u, coating)));
        self.below.clear();
        let temperature = |l: &saute_heat::Located| {
            (0..3).map(|k| l.weights[k] * pan_state.temperature[l.nodes[k] as usize]).sum::<f64>()
        };
        self.below.extend(patches.located.iter().map(temperature));
        let (up, side) = room.plume(pan.floor_temperature(pan_state));
        self.exchange_with(up, side, dt)
    }

    fn stand(&mut self, on: RestOn, room: &Room, dt: f64) -> Exchange {
        let air = if on == RestOn::Foil { room.under_foil() } else { room.still_air() };
        if on == RestOn::Rack {
            let around = Surroundings { down: Down::Free(air), up: air, side: air };
            return self.solver.advance(&self.model, &mut self.state, &around, dt);
        }
        let n = self.model.mesh.nodes_per_level();
        self.conductance.clear();
        self.conductance.resize(n, room.board.conductance_w_m2k);
        self.below.clear();
        self.below.resize(n, self.board.layers[0]);
        let exchange = self.exchange_with(air, air, dt);
        let taken = -self.solver.contact_heat.iter().sum::<f64>() / self.model.mesh.section.area();
        self.board.absorb(&room.board, taken, dt);
        exchange
    }

    fn exchange_with(&mut self, up: FreeAir, side: FreeAir, dt: f64) -> Exchange {
        let down = Down::Contact { conductance: &self.conductance, temperature: &self.below };
        self.solver.advance(&self.model, &mut self.state, &Surroundings { down, up, side }, dt)
    }
}
