//! A piece of food: its model, state, place and contacts.

use std::sync::Arc;

use saute_food::advance::REFRESH_TICKS;
use saute_food::body::halving::{Cut, CutError};
use saute_food::body::limp::Limp;
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

/// Place of a piece.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    /// Waiting at its start temperature, without heat exchange.
    Waiting,
    /// In or above the pan, with its centre at this point relative to the pan's centre [m].
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

/// Ground below a piece outside the pan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Under {
    /// Air, or the wires of a rack.
    Air,
    /// Wood, with layers of its own below each piece.
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
    /// Key: unique and constant during the life of the kitchen.
    pub key: u32,
    /// Immutable model.
    pub model: Arc<FoodModel>,
    /// State of the food.
    pub state: FoodState,
    /// Place.
    pub place: Place,
    /// Pose of its rigid body in the kitchen.
    pub pose: Pose,
    /// Time since the start of the contact of its lower face [s].
    pub since_contact: f64,
    /// Time of the last flip [s].
    pub flipped_at: Option<f64>,
    /// Highest core temperature [K] and its time [s].
    pub core_peak: (f64, f64),
    /// Vapour flow in the last tick [kg/s].
    pub vapour_flow: f64,
    /// Low-pass filtered normal force on the pan [N].
    pub pan_force: f64,
    /// Surface on which it was put to rest.
    pub(crate) resting_on: RestOn,
    pub(crate) near: NearPan,
    /// Contacts of its rigid body at the last tick with motion.
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

/// Longest loss of contact that does not restart the contact [s] (chosen: a hop of a few millimetres).
const HOP_S: f64 = 0.15;
/// Time constant of the contact force's low-pass filter [s] (chosen: longer than the impact of a landing).
const PRESSURE_S: f64 = 0.3;
/// Ticks between two updates of the shape [-] (chosen: the ticks at which the food model recomputes it).
const SHAPE_TICKS: u64 = 20;

impl Piece {
    /// A waiting piece at a uniform temperature [K].
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

    /// Returns true if it is in or above the pan.
    pub fn in_pan(&self) -> bool {
        matches!(self.place, Place::Pan(_))
    }

    /// Returns true if it rests on the board, with or without foil.
    pub fn lies_on_board(&self) -> bool {
        matches!(self.place, Place::Rest(RestOn::Board | RestOn::Foil))
    }

    /// The cut that halved it; the halves lie open side by side as one body.
    pub fn halved(&self) -> Option<Cut> {
        self.model.halved_at()
    }

    /// Halves it at a distance from the centre of its long axis [m] and removes the foil.
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

    /// Returns true if it has a rigid body, that is, once it no longer waits.
    pub fn is_out(&self) -> bool {
        self.place != Place::Waiting
    }

    /// Upward direction in its body's frame [-].
    pub fn up(&self) -> [f64; 3] {
        self.pose.up()
    }

    /// Returns true if it lies upside down.
    pub fn upside_down(&self) -> bool {
        self.up()[2] < 0.0
    }

    /// Friction coefficient of its lower face on metal with a film of oil [-]; browning and oil reduce it.
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

    /// Area-mean temperature of the lower (`true`) or upper face [K].
    pub fn face(&self, below: bool) -> f64 {
        self.model.face_temperature(&self.state, self.up().map(|u| if below { u } else { -u }))
    }

    /// Mass [kg].
    pub fn mass(&self) -> f64 {
        self.state.mass(&self.model)
    }

    /// Substeps of the last tick [-].
    pub fn substeps(&self) -> u32 {
        self.solver.substeps
    }

    /// Poses of its patches in its body's frame.
    pub fn patch_poses(&self) -> &[PatchPose] {
        &self.geometry.poses
    }

    /// Footprint on a floor in its present orientation.
    pub fn footprint(&self) -> Footprint {
        Footprint::of(&outline(&self.model.solid(&self.state), self.pose.rotation))
    }

    /// Resets the contact record for a piece laid flat into the pan.
    pub(crate) fn lie(&mut self) {
        self.lay_up = [0.0, 0.0, 1.0];
        self.near.forget();
    }

    /// Number of updates of its shape [-].
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

    /// Returns true if the face at a node is wet.
    pub(crate) fn is_wet(&self, node: usize) -> bool {
        self.state.water[node] > WET_SHARE * self.model.initial_water()[node]
    }

    /// Updates the geometry from the food's shape every [`SHAPE_TICKS`]; returns true if it did.
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

    /// Replaces the wood below it by wood at room temperature [K].
    pub(crate) fn onto_wood(&mut self, room: f64) {
        self.board = Board::at(room);
    }

    /// Clears all contacts at the start of a tick.
    pub(crate) fn free_all(&mut self) {
        self.touch.clear();
        self.touch.resize(self.model.patches().len(), Touch::default());
    }

    /// Closes a patch in contact with other food to the air.
    pub(crate) fn close(&mut self, patch: u32) {
        self.touch[patch as usize] = Touch::Closed;
    }

    /// Updates the patches near the pan, the time of contact and the filtered force; `seen` is its pose in the pan's
    /// frame.
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

    /// Ends the contact with the pan.
    pub(crate) fn leave_pan(&mut self) {
        self.sear.leave();
        self.near.forget();
        self.since_contact = 0.0;
        self.pan_force = 0.0;
    }

    /// Sets the contacts of the patches near the pan.
    pub(crate) fn touch_pan(&mut self, pan: &PanModel, pan_state: &PanState, room: &Room) {
        let near = core::mem::take(&mut self.near.patches);
        let area: f64 = near.iter().map(|n| self.patch_area(n.patch as usize)).sum();
        let face = FaceContact {
            since: self.since_contact,
            // Ridges carry the weight on their tops only.
            pressure: self.pan_force / (area * pan.ridges.map_or(1.0, |r| r.share())).max(1e-6),
            film: 0.0,
            coating: pan.description.coating_w_m2k,
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
            return Touch::Contact { conductance: rules.conductance_w_m2k * near * share, temperature };
        }
        let top = face.conductance(contact, distance) * steam_share(contact, temperature, wet) * surface.contact_share;
        let Some(ridges) = ridges else { return Touch::Contact { conductance: top, temperature } };
        let over = AcrossGroove {
            emissivity: [pan_model.description.surface.emissivity, surface.emissivity],
            temperature: [temperature, self.state.temperature[node]],
        };
        Touch::Contact { conductance: ridges.mixed(top, contact, &face, distance, &over), temperature }
    }

    /// Gap below a patch of a domed slice [m]; 0 if the slice does not lie flat.
    pub(crate) fn dome_gap(&self, patch: usize) -> f64 {
        let flat = self.model.mesh().is_slice() && self.lay_up[2].abs() > 0.7;
        if !flat {
            return 0.0;
        }
        let [x, y, _] = self.model.mesh().position(self.model.patches()[patch].node as usize);
        self.model.dome_gap(&self.state, [x, y], self.lay_up)
    }

    /// Sets the contacts with the ground outside the pan.
    pub(crate) fn touch_ground(&mut self, under: Under, room: &Room) {
        let temperature = match under {
            Under::Air => return,
            Under::Wood => self.board.layers[0],
            Under::Glass(temperature) => temperature,
        };
        let touch = Touch::Contact { conductance: room.board.conductance_w_m2k, temperature };
        let model = Arc::clone(&self.model);
        model.patches_below(self.up()).for_each(|patch| self.touch[patch] = touch);
    }

    /// Adds the heat of the last tick to the wood below it.
    pub(crate) fn warm_wood(&mut self, room: &Room, dt: f64) {
        let area: f64 = self.model.patches_below(self.up()).map(|i| self.patch_area(i)).sum();
        let taken = -self.solver.contact_heat.iter().sum::<f64>() / area;
        self.board.absorb(&room.board, taken, dt);
    }

    /// Advances the food by one tick with its contacts and the air at its faces.
    pub(crate) fn advance(&mut self, air: [FreeAir; 3], dt: f64) -> Exchange {
        let air = if self.model.rules() == Rules::Paper2013 { air.map(Room::without_evaporation) } else { air };
        let around = Surroundings { touch: &self.touch, air: &air };
        let exchange = self.solver.advance(&self.model, &mut self.state, &around, dt);
        self.since_contact += dt;
        self.vapour_flow = exchange.evaporated / dt;
        exchange
    }

    /// Heat capacity of a node [J/K]; `None` before the first tick.
    pub(crate) fn capacity(&self, node: usize) -> Option<f64> {
        self.solver.capacity(node)
    }

    /// Adds heat to a node [J].
    pub(crate) fn give(&mut self, node: usize, heat: f64) {
        self.solver.give(&mut self.state, node, heat);
    }
}

/// Share of the raw water above which the face of a node is wet [-] (chosen: far above a crust, below bound water).
pub const WET_SHARE: f64 = 0.4;
