//! Steam below a face that is colder than boiling water. Juice on a face that meets the hot pan flashes: the loud first second of a contact.
//!
//! While a face settles, more and more of its film of juice comes to lie on the metal: of a patch the share l = δ₀/δ by which it rests on the
//! pan ([`contact`](super::contact)), less where heat has made the flesh firm. What lies there boils at the rate r = h (T − T_b)/(L f), with
//! the largest film f. The rest waits. A face that has settled rides on its steam: its juice reaches the pan through the gap.
//!
//! The flesh itself boils where it touches the metal before its face as a whole is hot: a share of the heat through these places becomes steam.

use saute_food::water::latent_heat;
use saute_food::{Exchange, Rules};

use crate::data::room::Room;
use crate::kelvin;
use crate::pan::near_pan::NearPatch;
use crate::pan::pan_model::PanModel;
use crate::piece::contact::{FaceContact, lying};
use crate::piece::contact_gap::ContactGap;
use crate::piece::piece_state::Piece;

/// Conductance from metal to a film of juice that boils on it [W/(m²·K)] (chosen: the upper end of nucleate boiling, 5–10 kW/(m²·K); under
/// food that lies with its weight it does not fall on hotter metal).
const BOILS_W_M2K: f64 = 10_000.0;
/// Time constants of settling after which a face has settled [-] (chosen: less than a hundredth of the way is left).
const SETTLES: f64 = 5.0;
/// Share of the heat through the places that touch that makes steam, while the flesh behind them is cold [-] (chosen: an
/// eighth; the rest warms it).
const BECOMES_STEAM: f64 = 0.125;
/// So far below the boiling point that share begins to fall [K] (chosen: it ends without a step where the node itself boils).
const NEARLY_K: f64 = 10.0;

impl Piece {
    /// Boils off juice and water of the patches near the pan after a tick of `dt` [s], which do not boil as a whole yet; adds it to `exchange`.
    pub(crate) fn steam_below(&mut self, pan: &PanModel, room: &Room, dt: f64, exchange: &mut Exchange) {
        let contact = &room.contact;
        self.early_steam = 0.0;
        if self.model.rules() != Rules::Full {
            return;
        }
        let settles = self.on_pan.since < SETTLES * contact.settling_s;
        let near = core::mem::take(&mut self.on_pan.near.patches);
        let before = exchange.evaporated;
        let face = self.face_contact(&near, pan, room);
        let mean = face.mean_gap(contact);
        let carried = pan.ridges.map_or(1.0, |ridges| ridges.share());
        for n in &near {
            let excess = self.touch(n.patch).temperature() - kelvin(100.0);
            if excess > 0.0 && (settles || self.colder_than_boiling(n) > 0.0) {
                let heat = excess * carried * self.patch_area(n.patch as usize) * dt;
                let gap = self.gap_below(n, mean);
                if settles {
                    self.flash(n, lying(contact, gap), heat, exchange);
                }
                self.boil_where_it_touches(n, &face, gap, (heat, contact), exchange);
            }
        }
        self.on_pan.near.patches = near;
        self.early_steam = (exchange.evaporated - before) / dt;
        self.vapour_flow = exchange.evaporated.max(0.0) / dt;
    }

    /// How much the node of a patch is colder than boiling water [K]; not above 0 where it is not.
    fn colder_than_boiling(&self, n: &NearPatch) -> f64 {
        kelvin(100.0) - self.state.temperature[self.node_of(n.patch)]
    }

    /// Boils off what lies on the metal of the film below a patch: `lies` is the share by which the patch rests on the pan [-], `heat` what a
    /// conductance of 1 W/(m²·K) gives in the tick [J].
    fn flash(&mut self, n: &NearPatch, lies: f64, heat: f64, exchange: &mut Exchange) {
        let (patch, node) = (n.patch as usize, self.node_of(n.patch));
        let most = self.model.kinetics().water_holding.film_kg_m2 * self.patch_area(patch);
        let waits = (1.0 - lies * self.conforms(node)) * most;
        let boiling = BOILS_W_M2K * heat / (latent_heat(kelvin(100.0)) * most);
        // A dry crust soaks its juice up.
        let lying = self.wetness(node) * (self.state.juice[node] - waits).max(0.0);
        self.solver.flash(&self.model, &mut self.state, patch, lying * boiling / (1.0 + boiling), exchange);
    }

    /// Boils water off where a patch touches the metal, as far as its node is colder than boiling water; `heat` [J] is as above.
    fn boil_where_it_touches(
        &mut self,
        n: &NearPatch,
        face: &FaceContact,
        thickness: f64,
        (heat, contact): (f64, &ContactGap),
        exchange: &mut Exchange,
    ) {
        let heat = heat * (self.colder_than_boiling(n) / NEARLY_K).clamp(0.0, 1.0);
        let wetness = self.wetness(self.node_of(n.patch));
        let heat = BECOMES_STEAM * wetness * face.touching(contact, thickness, wetness) * heat;
        if heat > 0.0 {
            self.solver.boil_where_it_touches(&self.model, &mut self.state, n.patch as usize, heat, exchange);
        }
    }

    /// Share of the metal that the flesh of a node touches, relative to raw flesh [-]: under the same weight the area of real contact falls
    /// as the modulus rises (Greenwood and Williamson 1966 `[@greenwood-williamson-1966]`).
    fn conforms(&self, node: usize) -> f64 {
        let raw = self.model.kinetics().texture.raw_kpa;
        (raw / self.model.node_modulus_kpa(&self.state, node)).min(1.0)
    }
}
