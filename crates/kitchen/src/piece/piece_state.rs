//! A piece of food with its place in the kitchen.

use std::sync::Arc;

use saute_food::advance::REFRESH_TICKS;
use saute_food::halving::{Cut, CutError};
use saute_food::limp::Limp;
use saute_food::{
    Exchange, FoodModel, FoodSolver, FoodState, FreeAir, PatchGeometry, PatchPose, Rules, Surroundings, Touch,
    present_area,
};

use crate::data::room::Room;
use crate::dynamics::extent::outline;
use crate::dynamics::{Contact, PanShape, Pose};
use crate::hands::command::{Refused, RestOn};
use crate::pan::near_pan::{NearPan, NearPatch, Seen, unevenness};
use crate::pan::pan_model::{PanModel, PanState};
use crate::pan::ridges::AcrossGroove;
use crate::piece::board::Board;
use crate::piece::contact::{FaceContact, steam_share};
use crate::piece::layout::Footprint;
use crate::piece::sear_lines::SearRecord;

/// Where a piece is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    /// Waiting at its start temperature; nothing happens to it.
    Waiting,
    /// In the pan or above it, middle at this point relative to the pan's centre [m].
    Pan([f64; 2]),
    /// Held by a tool.
    Held,
    /// Resting.
    Rest(RestOn),
    /// Fallen onto the hob's glass.
    Glass,
    /// Fallen onto the table.
    Table,
}

impl Place {
    /// Name in data.
    pub fn name(self) -> &'static str {
        match self {
            Self::Waiting => "waiting",
            Self::Pan(_) => "pan",
            Self::Held => "held",
            Self::Rest(RestOn::Board) => "board",
            Self::Rest(RestOn::Rack) => "rack",
            Self::Rest(RestOn::Foil) => "foil",
            Self::Glass => "glass",
            Self::Table => "table",
        }
    }
}

/// What lies under a piece that is not in the pan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Under {
    /// Nothing, or a rack's wires.
    Air,
    /// Wood: its own layers below the piece.
    Wood,
    /// The hob's glass at a temperature [K].
    Glass(f64),
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
    /// Number that it keeps as long as it exists.
    pub key: u32,
    /// What never changes.
    pub model: Arc<FoodModel>,
    /// What changes.
    pub state: FoodState,
    /// Where it is.
    pub place: Place,
    /// Where its body's origin is in the kitchen and how it is turned.
    pub pose: Pose,
    /// Time since its lower face was laid down [s].
    pub since_contact: f64,
    /// Time of the last flip [s].
    pub flipped_at: Option<f64>,
    /// Highest core temperature [K] and when [s].
    pub core_peak: (f64, f64),
    /// Vapour given off in the last tick [kg/s].
    pub vapour_flow: f64,
    /// Force with which it presses on the pan [N].
    pub pan_force: f64,
    /// Onto what it was put to rest.
    pub(crate) resting_on: RestOn,
    pub(crate) near: NearPan,
    /// What its body touched at the last tick at which anything moved.
    pub(crate) contacts: Vec<Contact>,
    pub(crate) solver: FoodSolver,
    pub(crate) sear: SearRecord,
    geometry: PatchGeometry,
    limp: Option<Limp>,
    shape_count: u64,
    shaped_at: u64,
    lay_up: [f64; 3],
    lost_contact_s: f64,
    pub(crate) uneven: Arc<Vec<f64>>,
    board: Board,
    touch: Vec<Touch>,
}

/// How long contact may be lost before it starts anew [s] (chosen: a hop of a few millimetres).
const HOP_S: f64 = 0.15;
/// Time constant with which the pressure follows the contact force [s] (chosen: a landing is over).
const PRESSURE_S: f64 = 0.3;
/// Ticks between two looks at the present shape (chosen: those at which it is reckoned anew).
const SHAPE_TICKS: u64 = 20;

impl Piece {
    /// A waiting piece at one temperature [K].
    pub(crate) fn new(
        (id, kind): (String, String),
        seed: u64,
        key: u32,
        model: Arc<FoodModel>,
        temperature: f64,
        room: &Room,
    ) -> Self {
        let state = FoodState::raw(&model, temperature);
        let gap = &room.contact;
        let uneven = unevenness(&model, seed, 1e-3 * gap.unevenness_scale_mm, 1e-3 * gap.unevenness_mm);
        let mut geometry = PatchGeometry::default();
        model.patch_geometry_into(&state, &mut geometry);
        let limp = model.limp(&state);
        Self {
            core_peak: (temperature, 0.0),
            place: Place::Waiting,
            pose: Pose::default(),
            since_contact: 0.0,
            flipped_at: None,
            vapour_flow: 0.0,
            pan_force: 0.0,
            resting_on: RestOn::Board,
            near: NearPan::default(),
            contacts: Vec::new(),
            solver: FoodSolver::default(),
            sear: SearRecord::default(),
            geometry,
            limp,
            shape_count: 0,
            shaped_at: 0,
            lay_up: [0.0, 0.0, 1.0],
            lost_contact_s: 0.0,
            uneven: Arc::new(uneven),
            board: Board::at(room.temperature()),
            touch: Vec::new(),
            id,
            kind,
            seed,
            key,
            model,
            state,
        }
    }

    /// Whether it lies in the pan.
    pub fn in_pan(&self) -> bool {
        matches!(self.place, Place::Pan(_))
    }

    /// Whether it lies on the board, foil over it or not.
    pub fn lies_on_board(&self) -> bool {
        matches!(self.place, Place::Rest(RestOn::Board | RestOn::Foil))
    }

    /// Where a knife cut it in halves; its halves lie opened side by side, as one body.
    pub fn halved(&self) -> Option<Cut> {
        self.model.halved_at()
    }

    /// Cuts it in halves at a distance from the middle of its long axis [m]; foil over it is taken off.
    pub(crate) fn halve(&mut self, at: f64) -> Result<(), Refused> {
        let model = self.model.halved(at).map_err(|e| match e {
            CutError::Halved => Refused::AlreadyHalved(self.id.clone()),
            CutError::Beside { most } => {
                Refused::BesideFood { food: self.id.clone(), most_mm: libm::floor(most * 1e3) as i64 }
            }
        })?;
        Arc::make_mut(&mut self.uneven).resize(model.patches().len(), 0.0);
        self.model = Arc::new(model);
        self.solver = FoodSolver::default();
        self.model.patch_geometry_into(&self.state, &mut self.geometry);
        self.limp = self.model.limp(&self.state);
        self.shape_count += 1;
        (self.resting_on, self.place) = (RestOn::Board, Place::Rest(RestOn::Board));
        Ok(())
    }

    /// Whether it is a body among others: no longer waiting.
    pub fn is_out(&self) -> bool {
        self.place != Place::Waiting
    }

    /// The upward direction in its body's frame [-].
    pub fn up(&self) -> [f64; 3] {
        self.pose.up()
    }

    /// Whether it lies upside down.
    pub fn upside_down(&self) -> bool {
        self.up()[2] < 0.0
    }

    /// Friction of its lower face on metal under a film of oil [-]: raw flesh clings, a crust does not, oil helps.
    pub(crate) fn friction(&self, film: f64, room: &Room) -> f64 {
        let data = &room.friction;
        let crust = self.model.face_browning(&self.state, self.up()).min(1.0);
        let dry = data.raw + crust * (data.crust - data.raw);
        let oiled = film / (film + 1e-3 * data.film_mm);
        dry * (1.0 + oiled * (data.oiled_factor - 1.0))
    }

    /// Core temperature [K].
    pub fn core(&self) -> f64 {
        self.model.core_temperature(&self.state)
    }

    /// Area-mean temperature of the face that lies below (`true`) or above [K].
    pub fn face(&self, below: bool) -> f64 {
        self.model.face_temperature(&self.state, self.up().map(|u| if below { u } else { -u }))
    }

    /// Mass [kg].
    pub fn mass(&self) -> f64 {
        self.state.mass(&self.model)
    }

    /// Steps into which the last tick was divided.
    pub fn substeps(&self) -> u32 {
        self.solver.substeps
    }

    /// Where its patches are in its body's frame, and how they look.
    pub fn patch_poses(&self) -> &[PatchPose] {
        &self.geometry.poses
    }

    /// What it covers of a floor as it is turned now.
    pub fn footprint(&self) -> Footprint {
        Footprint::of(&outline(&self.model.solid(&self.state), self.pose.rotation))
    }

    /// Lies flat in the pan, turned as the pan is.
    pub(crate) fn lie(&mut self) {
        self.lay_up = [0.0, 0.0, 1.0];
        self.near.forget();
    }

    /// How often its shape has been reckoned anew.
    pub fn shape_count(&self) -> u64 {
        self.shape_count
    }

    /// Present area of a patch [m²].
    pub fn patch_area(&self, patch: usize) -> f64 {
        present_area(&self.model.patches()[patch], &self.state)
    }

    /// Node of a patch.
    pub(crate) fn node_of(&self, patch: u32) -> usize {
        self.model.patches()[patch as usize].node as usize
    }

    /// Whether the face at a node is wet.
    pub(crate) fn is_wet(&self, node: usize) -> bool {
        self.state.water[node] > WET_SHARE * self.model.initial_water()[node]
    }

    /// Brings the geometry up to date with the shape; tells whether it has changed.
    pub(crate) fn follow_shape(&mut self) -> bool {
        if self.state.ticks < self.shaped_at + SHAPE_TICKS {
            return false;
        }
        self.shaped_at = self.state.ticks;
        self.shape_count += 1;
        self.model.patch_geometry_into(&self.state, &mut self.geometry);
        self.limp = self.model.limp(&self.state);
        true
    }

    /// Puts it onto wood of room temperature.
    pub(crate) fn onto_wood(&mut self, room: f64) {
        self.board = Board::at(room);
    }

    /// Starts a tick: nothing is touched.
    pub(crate) fn free_all(&mut self) {
        self.touch.clear();
        self.touch.resize(self.model.patches().len(), Touch::default());
    }

    /// Closes a patch that lies against other food to the air.
    pub(crate) fn close(&mut self, patch: u32) {
        self.touch[patch as usize] = Touch::CLOSED;
    }

    /// Looks where it is near to the pan, and for how long; `seen` is its pose in the pan's frame.
    pub(crate) fn meet_pan(&mut self, pan: &PanModel, surface: &PanShape, seen: &Pose, force: f64, now: f64, dt: f64) {
        let patches = (self.model.patches(), self.geometry.poses.as_slice());
        let shape = Seen { patches, limp: self.limp.as_ref(), count: self.shape_count };
        self.near.look(pan, surface, seen, shape);
        self.lost_contact_s = if self.near.patches.is_empty() { self.lost_contact_s + dt } else { 0.0 };
        let up = seen.up();
        let level: f64 = up.iter().zip(&self.lay_up).map(|(a, b)| a * b).sum();
        if level < 0.0 && !self.near.patches.is_empty() {
            self.flipped_at = Some(now);
        }
        if self.lost_contact_s > HOP_S || (level < 0.5 && !self.near.patches.is_empty()) {
            self.since_contact = 0.0;
            self.pan_force = force;
        }
        if !self.near.patches.is_empty() && level < 0.5 {
            self.lay_up = up;
        }
        self.pan_force += (force - self.pan_force) * dt / (dt + PRESSURE_S);
        if let Some(ridges) = &pan.ridges {
            self.note_ridges(ridges, seen);
        }
    }

    /// Takes leave of the pan.
    pub(crate) fn leave_pan(&mut self) {
        self.sear.leave();
        self.near.forget();
        self.since_contact = 0.0;
        self.pan_force = 0.0;
    }

    /// Touches the pan where it is near to it.
    pub(crate) fn touch_pan(&mut self, pan: &PanModel, pan_state: &PanState, room: &Room) {
        let near = core::mem::take(&mut self.near.patches);
        let area: f64 = near.iter().map(|n| self.patch_area(n.patch as usize)).sum();
        let face = FaceContact {
            since: self.since_contact,
            // Ridges carry the weight on their tops alone.
            pressure: self.pan_force / (area * pan.ridges.map_or(1.0, |r| r.share())).max(1e-6),
            film: 0.0,
            coating: pan.description.coating_w_m2k.unwrap_or(f64::INFINITY),
        };
        let mean = face.mean_gap(&room.contact);
        for n in &near {
            self.touch[n.patch as usize] = self.pan_touch(n, &face, mean, (pan, pan_state), room);
            if let Some(ridges) = pan.ridges.filter(|_| self.state.ticks.is_multiple_of(REFRESH_TICKS)) {
                self.sear_strip(n, &face, mean, (&ridges, pan_state), room);
            }
        }
        self.near.patches = near;
    }

    fn pan_touch(
        &self,
        near: &NearPatch,
        face: &FaceContact,
        mean: f64,
        (pan_model, pan): (&PanModel, &PanState),
        room: &Room,
    ) -> Touch {
        let (contact, rules) = (&room.contact, &room.rules_2013);
        let node = self.node_of(near.patch);
        let located = &near.located;
        let face = FaceContact { film: pan.oil_film(located), ..*face };
        let temperature = (0..3).map(|k| located.weights[k] * pan.temperature[located.nodes[k] as usize]).sum::<f64>();
        let wet = self.is_wet(node);
        let dome = self.dome_gap(near.patch as usize);
        let distance = mean + self.uneven[near.patch as usize] + near.gap + dome;
        let ridges = pan_model.ridges.filter(|_| located.nodes.iter().all(|n| (*n as usize) < pan_model.floor_nodes));
        let surface = &self.model.description().surface;
        if self.model.rules() == Rules::Paper2013 {
            let near = f64::from(u8::from(distance <= rules.contact_distance_mm * 1e-3));
            let share = ridges.map_or(1.0, |r| r.share());
            return Touch { conductance: rules.conductance_w_m2k * near * share, temperature };
        }
        let top = face.conductance(contact, distance) * steam_share(contact, temperature, wet) * surface.contact_share;
        let Some(ridges) = ridges else { return Touch { conductance: top, temperature } };
        let over = AcrossGroove {
            emissivity: [pan_model.description.surface.emissivity, surface.emissivity],
            temperature: [temperature, self.state.temperature[node]],
        };
        Touch { conductance: ridges.mixed(top, contact, &face, distance, &over), temperature }
    }

    /// How far a patch of a bent slice stands off [m]; 0 where the slice does not lie flat.
    pub(crate) fn dome_gap(&self, patch: usize) -> f64 {
        let flat = self.model.mesh().is_slice() && self.lay_up[2].abs() > 0.7;
        if !flat {
            return 0.0;
        }
        let [x, y, _] = self.model.mesh().position(self.model.patches()[patch].node as usize);
        self.model.dome_gap(&self.state, [x, y], self.lay_up)
    }

    /// Touches what lies under it outside of the pan.
    pub(crate) fn touch_ground(&mut self, under: Under, room: &Room) {
        let temperature = match under {
            Under::Air => return,
            Under::Wood => self.board.layers[0],
            Under::Glass(temperature) => temperature,
        };
        let touch = Touch { conductance: room.board.conductance_w_m2k, temperature };
        let model = Arc::clone(&self.model);
        model.patches_below(self.up()).for_each(|patch| self.touch[patch] = touch);
    }

    /// Gives the wood under it what the last tick took.
    pub(crate) fn warm_wood(&mut self, room: &Room, dt: f64) {
        let area: f64 = self.model.patches_below(self.up()).map(|i| self.patch_area(i)).sum();
        let taken = -self.solver.contact_heat.iter().sum::<f64>() / area;
        self.board.absorb(&room.board, taken, dt);
    }

    /// One tick between everything that was touched and the airs before its faces.
    pub(crate) fn advance(&mut self, air: [FreeAir; 3], dt: f64) -> Exchange {
        let air = if self.model.rules() == Rules::Paper2013 { air.map(Room::without_evaporation) } else { air };
        let around = Surroundings { touch: &self.touch, air: &air };
        let exchange = self.solver.advance(&self.model, &mut self.state, &around, dt);
        self.since_contact += dt;
        self.vapour_flow = exchange.evaporated / dt;
        exchange
    }

    /// Heat capacity of a node [J/K]; none before the first tick.
    pub(crate) fn capacity(&self, node: usize) -> Option<f64> {
        self.solver.capacity(node)
    }

    /// Gives heat to a node [J].
    pub(crate) fn give(&mut self, node: usize, heat: f64) {
        self.solver.give(&mut self.state, node, heat);
    }
}

/// Acceleration of gravity [m/s²] (standard).
pub const GRAVITY: f64 = 9.806_65;
/// A node with more than this share of its raw water has a wet face [-] (chosen: far above a crust, below held water).
pub const WET_SHARE: f64 = 0.4;
