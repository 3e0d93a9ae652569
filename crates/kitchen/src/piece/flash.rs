//! Juice on a face that meets the hot pan flashes to steam: the loud first second of a contact.
//!
//! While a face settles, more and more of its film of juice comes to lie on the metal: of a patch the share l = δ₀/δ by which it rests on the
//! pan ([`contact`](super::contact)), less where heat has made the flesh firm. What lies there boils at the rate r = h (T − T_b)/(L f), with
//! the largest film f. The rest waits. A face that has settled rides on its steam: its juice reaches the pan through the gap.

use saute_food::water::latent_heat;
use saute_food::{Exchange, Rules};

use crate::data::room::Room;
use crate::kelvin;
use crate::pan::pan_model::PanModel;
use crate::piece::piece_state::Piece;

/// Conductance from metal to a film of juice that boils on it [W/(m²·K)] (chosen: the middle of nucleate boiling, 5–10 kW/(m²·K); under
/// food that lies with its weight it does not fall on hotter metal).
const BOILS_W_M2K: f64 = 7500.0;
/// Time constants of settling after which a face has settled [-] (chosen: less than a hundredth of the way is left).
const SETTLES: f64 = 5.0;

impl Piece {
    /// Boils off juice on the patches near the pan after a tick of `dt` [s], while the face settles; adds it to `exchange`.
    pub(crate) fn flash_below(&mut self, pan: &PanModel, room: &Room, dt: f64, exchange: &mut Exchange) {
        let contact = &room.contact;
        let settled = self.on_pan.since / contact.settling_s;
        if settled > SETTLES || self.model.rules() != Rules::Full {
            return;
        }
        let near = core::mem::take(&mut self.on_pan.near.patches);
        let mean = self.face_contact(&near, pan, room).mean_gap(contact);
        let carried = pan.ridges.map_or(1.0, |ridges| ridges.share());
        let film = self.model.kinetics().water_holding.film_kg_m2;
        for n in &near {
            let (patch, node) = (n.patch as usize, self.node_of(n.patch));
            let excess = self.touch(n.patch).temperature() - kelvin(100.0);
            if excess > 0.0 {
                let lies = carried * self.conforms(node) * (1e-3 * contact.gap_mm / self.gap_below(n, mean)).min(1.0);
                let waits = (1.0 - lies) * film * self.patch_area(patch);
                let rate = BOILS_W_M2K * excess / (latent_heat(kelvin(100.0)) * film);
                // A dry crust soaks its juice up.
                let gone =
                    self.wetness(node) * (self.state.juice[node] - waits).max(0.0) * (1.0 - 1.0 / (1.0 + rate * dt));
                self.solver.flash(&self.model, &mut self.state, patch, gone, exchange);
            }
        }
        self.on_pan.near.patches = near;
        self.vapour_flow = exchange.evaporated.max(0.0) / dt;
    }

    /// Share of the metal that the flesh of a node touches, relative to raw flesh [-]: under the same weight the area of real contact falls
    /// as the modulus rises (Greenwood and Williamson 1966 `[@greenwood-williamson-1966]`).
    fn conforms(&self, node: usize) -> f64 {
        let raw = self.model.kinetics().texture.raw_kpa;
        (raw / self.model.node_modulus_kpa(&self.state, node)).min(1.0)
    }
}
