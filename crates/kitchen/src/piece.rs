//! A piece of food with its place in the kitchen.

use std::sync::Arc;

use saute_food::{Exchange, FoodModel, FoodSolver, FoodState, FreeAir, Rules, Surroundings, Touch};

use crate::board::Board;
use crate::command::RestOn;
use crate::contact::{ContactPatches, FaceContact, steam_share};
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
    /// Direction of the body frame that points up in the world.
    pub up: [f64; 3],
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
    touch: Vec<Touch>,
}

impl Piece {
    /// A waiting piece at one temperature [K].
    pub fn new(id: String, kind: String, seed: u64, model: Arc<FoodModel>, temperature: f64, room: f64) -> Self {
        Self {
            state: FoodState::raw(&model, temperature),
            core_peak: (temperature, 0.0),
            place: Place::Waiting,
            up: [0.0, 0.0, 1.0],
            since_contact: 0.0,
            flipped_at: None,
            vapour_flow: 0.0,
            patches: None,
            solver: FoodSolver::default(),
            board: Board::at(room),
            touch: Vec::new(),
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
        self.model.face_temperature(&self.state, if below { self.up } else { self.up.map(|v| -v) })
    }

    /// Whether it lies upside down.
    pub fn upside_down(&self) -> bool {
        self.up[2] < 0.0
    }

    /// Turns it over.
    pub(crate) fn turn_over(&mut self) {
        self.up = self.up.map(|v| -v);
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
        let model = &self.model;
        let below: Vec<usize> = model.patches_below(self.up).collect();
        let point = |patch: &usize| {
            let [x, y, _] = model.mesh.position(model.patches[*patch].node as usize);
            [x, y]
        };
        let points: Vec<[f64; 2]> = below.iter().map(point).collect();
        let flipped = self.upside_down();
        let patches =
            ContactPatches::lay(below, &points, &pan.section, &pan.locator, at, flipped, &room.contact, self.seed);
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
        let (contact, rules) = (&room.contact, &room.rules_2013);
        let simple = self.model.rules == Rules::Paper2013;
        let face = FaceContact {
            since: self.since_contact,
            pressure: GRAVITY * self.state.mass_left(&self.model) / self.area_below(&patches.below),
            film: pan.oil_film(pan_state, room),
            coating: pan.description.coating_w_m2k.unwrap_or(f64::INFINITY),
        };
        let gap = face.mean_gap(contact);
        let share = self.model.description.surface.contact_share;
        self.free_all();
        for (i, (&patch, located)) in patches.below.iter().zip(&patches.located).enumerate() {
            let node = self.model.patches[patch].node as usize;
            let temperature =
                (0..3).map(|k| located.weights[k] * pan_state.temperature[located.nodes[k] as usize]).sum::<f64>();
            let wet = self.state.water[node] > WET_SHARE * self.model.initial_water[node];
            let [x, y, _] = self.model.mesh.position(node);
            let dome = self.model.dome_gap(&self.state, [x, y], self.up);
            let distance = gap + patches.unevenness[i] + dome;
            let conductance = if simple {
                rules.conductance_w_m2k * f64::from(u8::from(distance <= rules.contact_distance_mm * 1e-3))
            } else {
                face.conductance(contact, distance) * steam_share(contact, temperature, wet) * share
            };
            self.touch[patch] = Touch { conductance, temperature };
        }
        let (up, side) = room.plume(pan.floor_temperature(pan_state));
        self.exchange([up, up, side], dt)
    }

    fn stand(&mut self, on: RestOn, room: &Room, dt: f64) -> Exchange {
        let air = if on == RestOn::Foil { room.under_foil() } else { room.still_air() };
        self.free_all();
        let below: Vec<usize> = self.model.patches_below(self.up).collect();
        if on != RestOn::Rack {
            let board = Touch { conductance: room.board.conductance_w_m2k, temperature: self.board.layers[0] };
            below.iter().for_each(|patch| self.touch[*patch] = board);
        }
        let exchange = self.exchange([air; 3], dt);
        if on != RestOn::Rack {
            let lateral = self.state.stretch.lateral;
            let area = self.area_below(&below) * lateral * lateral;
            let taken = -self.solver.contact_heat.iter().sum::<f64>() / area;
            self.board.absorb(&room.board, taken, dt);
        }
        exchange
    }

    /// Frees all patches.
    fn free_all(&mut self) {
        self.touch.clear();
        self.touch.resize(self.model.patches.len(), Touch::default());
    }

    /// Rest area of patches [m²].
    fn area_below(&self, below: &[usize]) -> f64 {
        below.iter().map(|patch| self.model.patches[*patch].area).sum()
    }

    fn exchange(&mut self, air: [FreeAir; 3], dt: f64) -> Exchange {
        let air = if self.model.rules == Rules::Paper2013 { air.map(Room::without_evaporation) } else { air };
        self.solver.advance(&self.model, &mut self.state, &Surroundings { touch: &self.touch, air: &air }, dt)
    }
}

/// Acceleration of gravity [m/s²] (standard).
pub(crate) const GRAVITY: f64 = 9.806_65;
/// A node with more than this share of its raw water has a wet face [-] (chosen: far above a crust, below held water).
pub(crate) const WET_SHARE: f64 = 0.4;
