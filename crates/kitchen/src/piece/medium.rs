//! Media around a piece in the pan: steam below lifted patches, water and oil in which it stands.
//!
//! A patch in a medium exchanges heat with it in addition to the pan. Both conductances act on one [`Touch`]; after the tick the
//! heat is divided between them exactly: q_m = h_m A Δt (T_m − T_eff) + q h_m / (h_p + h_m), with T_eff the mean of both
//! temperatures weighted by the conductances.

use glam::DVec3;
use saute_food::advance::REFRESH_TICKS;
use saute_food::water::latent_heat;
use saute_food::{Touch, ZERO_C};
use saute_heat::Located;
use serde::{Deserialize, Serialize};

use crate::data::room::Room;
use crate::dynamics::{PanShape, Pose};
use crate::liquids::bath::BathModel;
use crate::liquids::water_film::WATER_SPECIFIC_HEAT;
use crate::pan::pan_model::{PanModel, PanState};
use crate::piece::piece_state::Piece;
use crate::tick::low_pass::low_pass;

/// Temperature of steam below food [K].
const STEAM: f64 = ZERO_C + 100.0;
/// Depth of oil from which food is in it [m] (chosen: the film under a lying face is shallower).
const DEEP_OIL: f64 = 1.0e-3;
/// Largest share of a pool's heat capacity that one piece couples to in a tick [-] (chosen: stable for the 200 pieces that a
/// group may have).
const MOST_OF_POOL: f64 = 0.005;
/// Time constant over which the steam below a piece is averaged [s] (chosen).
const STEAM_S: f64 = 1.0;
/// Largest relative rise of the level by the food in a pool [-] (chosen: a full pan overflows).
const MOST_RISE: f64 = 1.0;

/// Kind of medium.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, Serialize)]
pub(crate) enum Medium {
    /// Steam at 100 °C.
    Steam,
    /// The pool of water.
    Water,
}

/// A patch in a medium.
#[derive(Clone, Copy, Debug, Deserialize, Serialize)]
struct InMedium {
    patch: u32,
    medium: Medium,
    /// Conductance to the medium, and to medium and pan together [W/(m²·K)].
    conductance: f64,
    whole: f64,
    /// Temperature of the medium, and the weighted mean of medium and pan [K].
    temperature: f64,
    mean: f64,
}

/// A patch in deep oil, which has the temperature of the metal below.
#[derive(Clone, Copy, Debug, Deserialize, Serialize)]
pub(crate) struct Oiled {
    pub(crate) patch: u32,
    pub(crate) located: Located,
}

/// Media around a piece.
#[derive(Clone, Debug, Default, Deserialize, Serialize)]
pub(crate) struct Media {
    patches: Vec<InMedium>,
    /// Patches below the surface of the pool.
    in_water: Vec<u32>,
    /// Patches below the surface of deep oil, apart from those near the pan and those under other food.
    pub(crate) in_oil: Vec<Oiled>,
    /// Steam that boils off below the piece, averaged [kg/s].
    steam: f64,
}

impl Media {
    /// Returns the media of the piece on another mesh, whose patches are to be found again.
    pub(crate) fn on_other_mesh(&self) -> Self {
        Self { steam: self.steam, ..Self::default() }
    }

    /// Returns true if it names some of so many patches and nodes of the pan.
    pub(crate) fn fits(&self, patches: usize, nodes: usize) -> bool {
        let named = self.patches.iter().map(|m| m.patch).chain(self.in_water.iter().copied());
        let mut named = named.chain(self.in_oil.iter().map(|oiled| oiled.patch));
        let mut located = self.in_oil.iter().flat_map(|oiled| oiled.located.nodes);
        named.all(|patch| (patch as usize) < patches) && located.all(|node| (node as usize) < nodes)
    }
}

/// Heat that a piece took from its media in one tick [J].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct MediaHeat {
    pub(crate) steam: f64,
    pub(crate) water: f64,
}

impl Piece {
    /// Couples lifted patches to the steam below them, and patches below the surface of a liquid to it. `seen` is the pose
    /// in the pan's frame, `mean` the mean gap of the face [m].
    pub(crate) fn stand_in_media(
        &mut self,
        (pan, state): (&PanModel, &PanState),
        surface: &PanShape,
        seen: &Pose,
        (mean, room): (f64, &Room),
        dt: f64,
    ) {
        if self.state.ticks.is_multiple_of(REFRESH_TICKS) {
            self.find_immersed(pan, state, surface, seen);
        }
        self.media.patches.clear();
        self.stand_in_oil(&pan.liquids.bath, state);
        self.stand_in_water(&pan.liquids.bath, state, dt);
        if self.media.in_water.is_empty() && self.media.steam > 0.0 {
            self.stand_in_steam(state, mean, room);
        }
    }

    /// Finds the patches below the surfaces of water and oil.
    fn find_immersed(&mut self, pan: &PanModel, state: &PanState, surface: &PanShape, seen: &Pose) {
        let mut media = core::mem::take(&mut self.media);
        media.in_water.clear();
        media.in_oil.clear();
        let liquids = &state.liquids;
        let oil = liquids.film.iter().any(|film| *film > DEEP_OIL);
        if liquids.pool.mass > 0.0 || oil {
            let rise = if liquids.pool.mass > 0.0 { (self.mass() / liquids.pool.mass).min(MOST_RISE) } else { 0.0 };
            for (patch, pose) in self.patch_poses().iter().enumerate() {
                let Some(over) = surface.over(seen.to_world(DVec3::from_array(pose.position))) else { continue };
                let located = pan.locator.locate_or_nearest(&pan.section, over.on_mesh);
                if liquids.pool.mass > 0.0 && over.gap < (1.0 + rise) * pan.liquids.water_depth(liquids, &located) {
                    media.in_water.push(patch as u32);
                } else if over.gap < state.oil_film(&located) && state.oil_film(&located) > DEEP_OIL {
                    media.in_oil.push(Oiled { patch: patch as u32, located });
                }
            }
        }
        self.media = media;
    }

    /// Heat from oil: it has the temperature of the metal, so the contact is one with the pan.
    fn stand_in_oil(&mut self, bath: &BathModel, state: &PanState) {
        if self.media.in_oil.is_empty() {
            return;
        }
        let area: f64 = self.model.patches().iter().map(|p| p.area).sum();
        let conductance = bath.oil(self.vapour_flow / area);
        let mut in_oil = core::mem::take(&mut self.media.in_oil);
        // Since they were found, some may have come near the pan or under other food.
        in_oil.retain(|oiled| self.touch(oiled.patch) == Touch::Air);
        for Oiled { patch, located } in &in_oil {
            let temperature = state.metal_at(located);
            self.set_touch(*patch, Touch::Contact { conductance, temperature });
        }
        for oiled in in_oil.iter().filter(|_| self.state.healthy) {
            let node = self.node_of(oiled.patch);
            self.state.oiled[node] = 1.0;
        }
        self.media.in_oil = in_oil;
    }

    /// Heat from the pool, to each of its patches; a face that lies keeps its contact with the pan alone.
    fn stand_in_water(&mut self, bath: &BathModel, state: &PanState, dt: f64) {
        let pool = state.liquids.pool;
        if pool.mass <= 0.0 || self.media.in_water.is_empty() {
            return;
        }
        let [length, width, height] = self.model.size();
        let half = 0.5 * length.min(width).min(height);
        let patches = core::mem::take(&mut self.media.in_water);
        let area: f64 = patches.iter().map(|p| self.patch_area(*p as usize)).sum();
        let most = MOST_OF_POOL * pool.mass * WATER_SPECIFIC_HEAT / (area * dt);
        for &patch in &patches {
            let face = self.state.temperature[self.node_of(patch)];
            let conductance = bath.water(pool.temperature, face, half).min(most) * self.lifted(patch);
            self.couple(patch, Medium::Water, conductance, pool.temperature);
        }
        self.media.in_water = patches;
    }

    /// Heat from the steam that rises below the piece to the patches that do not lie; no more than the steam contains.
    fn stand_in_steam(&mut self, pan: &PanState, mean: f64, room: &Room) {
        let near = core::mem::take(&mut self.on_pan.near.patches);
        let lifted = |piece: &Self, n: &crate::pan::near_pan::NearPatch| {
            let share = piece.lifted_share(n, pan, mean, room);
            let colder = (STEAM - piece.state.temperature[piece.node_of(n.patch)]).max(0.0);
            (share, share * colder * piece.patch_area(n.patch as usize) * room.contact.steam_w_m2k)
        };
        let demand: f64 = near.iter().map(|n| lifted(self, n).1).sum();
        if demand > 0.0 {
            let share = (self.media.steam * latent_heat(STEAM) / demand).min(1.0);
            for n in &near {
                let (part, wanted) = lifted(self, n);
                if wanted > 0.0 {
                    self.couple(n.patch, Medium::Steam, share * part * room.contact.steam_w_m2k, STEAM);
                }
            }
        }
        self.on_pan.near.patches = near;
    }

    /// Share of a patch that does not lie on the pan: all of one that is not near it [-].
    fn lifted(&self, patch: u32) -> f64 {
        match self.touch(patch) {
            Touch::Air => 1.0,
            Touch::Closed | Touch::Fixed { .. } => 0.0,
            Touch::Contact { conductance, .. } => LIES / (LIES + conductance),
        }
    }

    /// Adds the conductance to a medium to the contact of a patch.
    fn couple(&mut self, patch: u32, medium: Medium, conductance: f64, temperature: f64) {
        let touch = self.touch(patch);
        if conductance <= 0.0 || touch == Touch::Closed {
            return;
        }
        let whole = touch.conductance() + conductance;
        let mean = (touch.conductance() * touch.temperature() + conductance * temperature) / whole;
        self.set_touch(patch, Touch::Contact { conductance: whole, temperature: mean });
        self.media.patches.push(InMedium { patch, medium, conductance, whole, temperature, mean });
    }

    /// Divides the heat of the last tick: subtracts what the media gave from the contact heat, which is the pan's then.
    pub(crate) fn take_media_heat(&mut self, dt: f64) -> MediaHeat {
        let mut heat = MediaHeat::default();
        for i in 0..self.media.patches.len() {
            let m = self.media.patches[i];
            let contact = self.solver.contact_heat[m.patch as usize];
            let own = m.conductance * self.patch_area(m.patch as usize) * dt * (m.temperature - m.mean);
            let part = own + contact * m.conductance / m.whole;
            self.solver.contact_heat[m.patch as usize] -= part;
            match m.medium {
                Medium::Steam => heat.steam += part,
                Medium::Water => heat.water += part,
            }
        }
        heat
    }

    /// Forgets the steam below the piece, which lies on another face now.
    pub(crate) fn lose_steam(&mut self) {
        self.media.steam = 0.0;
    }

    /// Adds the steam of the last tick below the piece [kg] to its average.
    pub(crate) fn average_steam(&mut self, boiled: f64, dt: f64) {
        low_pass(&mut self.media.steam, boiled / dt, STEAM_S, dt);
    }
}

/// Contact conductance to the pan at which half of a patch counts as lying [W/(m²·K)] (chosen: a gap of half a millimetre).
const LIES: f64 = 100.0;
