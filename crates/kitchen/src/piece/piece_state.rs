//! A piece of food: its model, state, place and contacts.

use std::sync::Arc;

use glam::DVec3;
use saute_food::advance::REFRESH_TICKS;
use saute_food::body::halving::{Cut, CutError};
use saute_food::{
    Exchange, FoodModel, FoodSolver, FoodState, FreeAir, PatchPose, PieceSpec, Rules, Surroundings, Touch, present_area,
};
use serde::{Deserialize, Serialize};

use crate::data::room::Room;
use crate::dynamics::extent::outline;
use crate::dynamics::{Contact, PanShape, Pose};
use crate::hands::command::{Refused, RestOn};
use crate::kitchen::PieceOrder;
use crate::pan::near_pan::NearPatch;
use crate::pan::pan_model::{PanModel, PanState};
use crate::pan::ridges::AcrossGroove;
use crate::piece::board::Board;
use crate::piece::contact::{FaceContact, PatchGap, wetness};
use crate::piece::contact_2013;
use crate::piece::layout::Footprint;
use crate::piece::medium::Media;
use crate::piece::pan_contact::PanContact;
use crate::piece::piece_shape::PieceShape;
use crate::piece::running::{Running, lands_on};
use crate::piece::sear_lines::SearRecord;

/// Place of a piece.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
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
    /// Wood, with its own layers below each piece.
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
    /// Size, seed and mesh from which its model was built.
    pub(crate) spec: PieceSpec,
    /// Hash of the data files of its food.
    pub(crate) data_hash: u64,
    /// Immutable model.
    pub model: Arc<FoodModel>,
    /// State of the food.
    pub state: FoodState,
    /// Place.
    pub place: Place,
    /// Pose of its rigid body in the kitchen.
    pub pose: Pose,
    /// Highest core temperature [K] and its time [s].
    pub core_peak: (f64, f64),
    /// Vapour flow in the last tick [kg/s].
    pub vapour_flow: f64,
    /// Part of the last tick's vapour that came from below before its lower face boiled [kg/s]: heard also where as much condenses above;
    /// not stored.
    pub early_steam: f64,
    /// Heat that it took from the pan and from liquids in it so far [J].
    pub heat_taken: f64,
    /// Surface on which it was put to rest.
    pub(crate) resting_on: RestOn,
    /// Contact with the pan.
    pub(crate) on_pan: PanContact,
    /// Contacts of its rigid body at the last tick with motion.
    pub(crate) contacts: Vec<Contact>,
    pub(crate) solver: FoodSolver,
    pub(crate) sear: SearRecord,
    pub(crate) shape: PieceShape,
    pub(crate) uneven: Arc<Vec<f64>>,
    pub(crate) board: Board,
    pub(crate) touch: Vec<Touch>,
    pub(crate) media: Media,
    /// A poured food that still runs.
    pub(crate) running: Option<Running>,
    /// Time for which it is still basted [s].
    pub(crate) basted_s: f64,
    /// Patches over which spooned fat runs in this tick; not stored.
    pub(crate) basted: Vec<u32>,
}

impl Piece {
    /// A waiting piece at a uniform temperature [K].
    pub(crate) fn new(
        (order, data_hash): (&PieceOrder, u64),
        key: u32,
        (model, uneven): (Arc<FoodModel>, Arc<Vec<f64>>),
        room: &Room,
    ) -> Self {
        let temperature = order.temperature;
        let state = FoodState::raw(&model, temperature);
        Self {
            core_peak: (temperature, 0.0),
            place: Place::Waiting,
            pose: Pose::default().turned(DVec3::Z, model.turned()),
            vapour_flow: 0.0,
            early_steam: 0.0,
            heat_taken: 0.0,
            resting_on: RestOn::Board,
            on_pan: PanContact::none(),
            contacts: Vec::new(),
            solver: FoodSolver::default(),
            sear: SearRecord::default(),
            shape: PieceShape::of(&model, &state),
            uneven,
            board: Board::at(room.temperature()),
            touch: Vec::new(),
            media: Media::default(),
            running: None,
            basted_s: 0.0,
            basted: Vec::new(),
            id: order.id.clone(),
            kind: order.kind.clone(),
            seed: order.seed,
            spec: order.spec(),
            data_hash,
            key,
            model,
            state,
        }
    }

    /// Returns true if it is in or above the pan.
    pub fn in_pan(&self) -> bool {
        matches!(self.place, Place::Pan(_))
    }

    /// Returns true if it was poured and still runs.
    pub fn runs(&self) -> bool {
        self.running.is_some()
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
        // It may be stored before its next tick, with a contact of each patch.
        self.touch.resize(model.patches().len(), Touch::default());
        self.model = Arc::new(model);
        self.solver = FoodSolver::default();
        self.shape.update(&self.model, &self.state);
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
        if self.running.is_some() {
            return CLINGS;
        }
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
        self.shape.poses()
    }

    /// Footprint on a floor in its present orientation; of what has still to be poured, that with which it lands.
    pub fn footprint(&self) -> Footprint {
        if self.place == Place::Waiting && self.model.pool().is_some() {
            return lands_on();
        }
        Footprint::of(&outline(&self.model.solid(&self.state), self.pose.rotation))
    }

    /// Resets the contact record for a piece laid flat into the pan.
    pub(crate) fn lie(&mut self) {
        self.on_pan.lie();
    }

    /// Returns the low-pass filtered normal force on the pan [N].
    pub fn pan_force(&self) -> f64 {
        self.on_pan.force
    }

    /// Returns the time of the last flip [s].
    pub fn flipped_at(&self) -> Option<f64> {
        self.on_pan.flipped_at
    }

    /// Returns true if some of its surface is on the pan or close enough to be heated by it.
    pub fn is_near_pan(&self) -> bool {
        !self.on_pan.near.patches.is_empty()
    }

    /// Returns the patches near the pan, in their order.
    pub(crate) fn near_patches(&self) -> &[NearPatch] {
        &self.on_pan.near.patches
    }

    /// Number of updates of its shape [-].
    pub fn shape_count(&self) -> u64 {
        self.shape.count()
    }

    /// Present area of a patch [m²].
    pub fn patch_area(&self, patch: usize) -> f64 {
        present_area(&self.model.patches()[patch], &self.state)
    }

    /// Node of a patch.
    pub(crate) fn node_of(&self, patch: u32) -> usize {
        self.model.patches()[patch as usize].node as usize
    }

    /// Wet share of the face at a node [-].
    pub(crate) fn wetness(&self, node: usize) -> f64 {
        let held = self.state.water[node] / self.model.initial_water()[node];
        match self.model.rules() {
            Rules::Full => wetness(held),
            Rules::Paper2013 => contact_2013::wetness(held),
        }
    }

    /// Updates the geometry from the food's shape when due; returns true if it did.
    pub(crate) fn follow_shape(&mut self) -> bool {
        // What is held keeps its shape.
        let lies = self.on_pan.force > 0.0 || matches!(self.place, Place::Rest(_));
        (lies && self.drape()) || self.shape.follow(&self.model, &self.state)
    }

    /// Lets a poured piece sink onto its lower face; returns true if that changed its shape.
    pub(crate) fn drape(&mut self) -> bool {
        let draped = f64::from(u8::from(self.upside_down()));
        let sinks = self.model.pool().is_some() && self.state.stretch.draped != draped;
        if sinks {
            self.state.stretch.draped = draped;
            self.shape.update(&self.model, &self.state);
        }
        sinks
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

    /// Returns the contact of every patch in the last tick; empty before its first one.
    pub fn touches(&self) -> &[Touch] {
        &self.touch
    }

    /// Returns the contact of a patch in this tick.
    pub(crate) fn touch(&self, patch: u32) -> Touch {
        self.touch[patch as usize]
    }

    /// Sets the contact of a patch in this tick.
    pub(crate) fn set_touch(&mut self, patch: u32, touch: Touch) {
        self.touch[patch as usize] = touch;
    }

    /// Closes a patch in contact with other food to the air.
    pub(crate) fn close(&mut self, patch: u32) {
        self.touch[patch as usize] = Touch::Closed;
    }

    /// Updates the patches near the pan, the time of contact and the filtered force; `seen` is its pose in the pan's
    /// frame.
    pub(crate) fn meet_pan(&mut self, pan: &PanModel, surface: &PanShape, seen: &Pose, force: f64, now: f64, dt: f64) {
        self.on_pan.near.look(pan, surface, seen, self.shape.seen(&self.model));
        self.on_pan.follow(seen.up(), force, now, dt);
        if self.on_pan.since == 0.0 {
            self.lose_steam();
        }
        if let Some(ridges) = &pan.ridges {
            self.note_ridges(ridges, seen);
        }
    }

    /// Ends the contact with the pan.
    pub(crate) fn leave_pan(&mut self) {
        self.sear.leave();
        self.basted_s = 0.0;
        self.media = Media::default();
        self.on_pan.leave();
    }

    /// Sets the contacts of the patches near the pan for a tick of `dt` [s].
    pub(crate) fn touch_pan(
        &mut self,
        (pan, pan_state): (&PanModel, &PanState),
        (surface, seen): (&PanShape, &Pose),
        room: &Room,
        dt: f64,
    ) {
        let near = core::mem::take(&mut self.on_pan.near.patches);
        let mut mean = 0.0;
        if self.model.rules() == Rules::Paper2013 {
            self.touch_pan_2013(&near, (pan, pan_state), room);
        } else {
            let face = self.face_contact(&near, pan, room);
            mean = face.mean_gap(&room.contact);
            for n in &near {
                let gap = self.gap_below(n, mean);
                self.oil(n, self.lifted_over(n, gap, mean, pan_state, room), pan_state, room);
                self.touch[n.patch as usize] = self.pan_touch(n, &face, gap, (pan, pan_state), room);
                if let Some(ridges) = pan.ridges.filter(|_| self.state.ticks.is_multiple_of(REFRESH_TICKS)) {
                    self.sear_strip(n, &face, mean, (&ridges, pan_state), room);
                    self.tan_between(n, &face, mean, (pan, &ridges, pan_state), room);
                }
            }
        }
        self.on_pan.near.patches = near;
        if self.model.rules() == Rules::Full {
            self.stand_in_media((pan, pan_state), surface, seen, (mean, room), dt);
        }
    }

    /// Oils the node of a patch that is in a film; the film does not reach the share of a patch that is lifted off it.
    fn oil(&mut self, near: &NearPatch, lifted: f64, pan: &PanState, room: &Room) {
        let film = self.film_below(near, pan, room);
        let node = self.node_of(near.patch);
        let lies = 1.0 - lifted;
        let covers = lies * film / (film + 1e-3 * room.oil.clinging_mm);
        // A frozen piece no longer changes.
        if self.state.healthy {
            self.state.oiled[node] = self.state.oiled[node].max(covers);
        }
    }

    /// Contact of the whole lower face, without oil.
    pub(crate) fn face_contact(&self, near: &[NearPatch], pan: &PanModel, room: &Room) -> FaceContact {
        let area: f64 = near.iter().map(|n| self.patch_area(n.patch as usize)).sum();
        let [length, width, _] = self.model.size();
        FaceContact {
            since: self.on_pan.since,
            // Ridges carry the weight on their tops only.
            pressure: self.on_pan.force / (area * pan.ridges.map_or(1.0, |r| r.share())).max(1e-6),
            escape: (0.5 * length.min(width)).min(1e-3 * room.contact.vent_spacing_mm),
            film: 0.0,
            coating: pan.description.coating_w_m2k,
        }
    }

    /// Gap below a patch near the pan [m].
    pub(crate) fn gap_below(&self, near: &NearPatch, mean: f64) -> f64 {
        mean + self.uneven[near.patch as usize] + near.gap + self.dome_gap(near.patch as usize)
    }

    /// Share of a patch near the pan that is lifted off it by more than the gap of a face that lies [-].
    pub(crate) fn lifted_share(&self, near: &NearPatch, pan: &PanState, mean: f64, room: &Room) -> f64 {
        self.lifted_over(near, self.gap_below(near, mean), mean, pan, room)
    }

    /// As [`Self::lifted_share`], over a known gap [m]; what fat fills is not lifted.
    #[inline]
    fn lifted_over(&self, near: &NearPatch, gap: f64, mean: f64, pan: &PanState, room: &Room) -> f64 {
        let lifted = lifted_share(gap - mean, room);
        if !self.waves() || lifted == 0.0 {
            return lifted;
        }
        lifted * (1.0 - (self.film_below(near, pan, room) / gap).min(1.0))
    }

    /// Thickness of the film of fat below a patch near the pan: below a slice that waves it gathers [m].
    #[inline]
    fn film_below(&self, near: &NearPatch, pan: &PanState, room: &Room) -> f64 {
        pan.oil_film(&near.located) * if self.waves() { room.contact.wave_film } else { 1.0 }
    }

    /// Returns true if the piece is a thin slice that waves.
    #[inline]
    fn waves(&self) -> bool {
        self.state.stretch.waves > 0.0
    }

    fn pan_touch(
        &self,
        near: &NearPatch,
        face: &FaceContact,
        thickness: f64,
        (pan_model, pan): (&PanModel, &PanState),
        room: &Room,
    ) -> Touch {
        let (contact, located, node) = (&room.contact, &near.located, self.node_of(near.patch));
        let face = FaceContact { film: self.film_below(near, pan, room), ..*face };
        let temperature = pan.metal_at(located);
        let surface = &self.model.description().surface;
        let gap = PatchGap { thickness, pan: temperature, wetness: self.wetness(node) };
        let top = face.conductance(contact, &gap) * surface.contact_share;
        let ridges = pan_model.ridges.filter(|_| located.nodes.iter().all(|n| (*n as usize) < pan_model.floor_nodes));
        let Some(ridges) = ridges else { return Touch::Contact { conductance: top, temperature } };
        let over = self.across_groove(pan_model, temperature, node);
        Touch::Contact { conductance: ridges.mixed(top, contact, &face, &gap, &over), temperature }
    }

    /// The surfaces of pan and node that face each other across a groove.
    pub(crate) fn across_groove(&self, pan: &PanModel, metal: f64, node: usize) -> AcrossGroove {
        AcrossGroove {
            emissivity: [pan.description.surface.emissivity, self.model.description().surface.emissivity],
            temperature: [metal, self.state.temperature[node]],
        }
    }

    /// Contacts by the rules of 2013: a fixed conductance within a distance.
    fn touch_pan_2013(&mut self, near: &[NearPatch], (pan_model, pan): (&PanModel, &PanState), room: &Room) {
        let rules = &room.rules_2013;
        let area: f64 = near.iter().map(|n| self.patch_area(n.patch as usize)).sum();
        let share = pan_model.ridges.map_or(1.0, |r| r.share());
        let pressure = self.on_pan.force / (area * share).max(1e-6);
        let mean = contact_2013::mean_gap(rules, self.on_pan.since, pressure);
        for n in near {
            let reached = f64::from(u8::from(self.gap_below(n, mean) <= rules.contact_distance_mm * 1e-3));
            let floor = n.located.nodes.iter().all(|n| (*n as usize) < pan_model.floor_nodes);
            let share = pan_model.ridges.filter(|_| floor).map_or(1.0, |r| r.share());
            let conductance = rules.conductance_w_m2k * reached * share;
            self.touch[n.patch as usize] = Touch::Contact { conductance, temperature: pan.metal_at(&n.located) };
        }
    }

    /// Gap below a patch of a domed slice [m]; 0 if the slice does not lie flat.
    pub(crate) fn dome_gap(&self, patch: usize) -> f64 {
        let flat = self.model.mesh().is_slice() && self.on_pan.lay_up[2].abs() > 0.7;
        if !flat {
            return 0.0;
        }
        self.model.patch_dome_gap(&self.state, patch, self.on_pan.lay_up)
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

    /// Advances the food by one tick with its contacts, the air at its faces and the force of a press on it [N], which a slice
    /// on its edge does not feel.
    pub(crate) fn advance(&mut self, air: [FreeAir; 3], force: f64, dt: f64) -> Exchange {
        let area = || self.model.patches_below(self.up()).map(|i| self.patch_area(i)).sum::<f64>();
        let lies = !self.model.mesh().is_slice() || self.up()[2].abs() > 0.7;
        let pressed = if lies && force > 0.0 { force / area().max(1e-6) } else { 0.0 };
        let around = Surroundings { touch: &self.touch, air: &air, pressed };
        let exchange = self.solver.advance(&self.model, &mut self.state, &around, dt);
        self.on_pan.since += dt;
        self.vapour_flow = exchange.evaporated.max(0.0) / dt;
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

/// Friction of what runs [-] (chosen: above that of the pan, which then counts; it hardly slides as a whole, its film flows).
const CLINGS: f64 = 4.0;

/// Share of a patch that is lifted off the pan by more than the gap of a face that lies, given how far it is lifted [m] [-].
fn lifted_share(lift: f64, room: &Room) -> f64 {
    let from = 1e-3 * room.contact.gap_mm;
    if lift > from { 1.0 - from / lift } else { 0.0 }
}
