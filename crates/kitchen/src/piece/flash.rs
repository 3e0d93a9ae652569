//! Juice on a face that meets the hot pan flashes to steam: the loud first second of a contact.
//!
//! Before a face has settled, its film of juice lies on the metal itself and boils by the boiling curve of a wet soft face. What the face
//! gives later reaches the pan through the gap that its steam keeps open ([`contact`](super::contact)).

use saute_food::{Exchange, Rules};

use crate::data::room::Room;
use crate::kelvin;
use crate::pan::pan_model::PanModel;
use crate::piece::piece_state::Piece;

/// Time from the start of a contact in which juice lies on the metal [s] (chosen: of the order in which a face settles).
const FLASHES_FOR_S: f64 = 2.0;

impl Piece {
    /// Boils off juice on the patches near the pan after a tick of `dt` [s], if their contact is new; adds it to `exchange`.
    pub(crate) fn flash_below(&mut self, pan: &PanModel, room: &Room, dt: f64, exchange: &mut Exchange) {
        if self.on_pan.since > FLASHES_FOR_S || self.model.rules() != Rules::Full {
            return;
        }
        let near = core::mem::take(&mut self.on_pan.near.patches);
        let mean = self.face_contact(&near, pan, room).mean_gap(&room.contact);
        let carried = pan.ridges.map_or(1.0, |ridges| ridges.share());
        for n in &near {
            let (patch, metal) = (n.patch as usize, self.touch(n.patch).temperature());
            if metal > kelvin(100.0) {
                let lies = carried * (1.0 - self.lifted_share(n, mean, room));
                let heat = room.cloth.boiling_flux(metal) * lies * self.patch_area(patch) * dt;
                self.solver.flash(&self.model, &mut self.state, patch, heat, exchange);
            }
        }
        self.on_pan.near.patches = near;
        self.vapour_flow = exchange.evaporated.max(0.0) / dt;
    }
}
