//! Juice that leaves otherwise than by itself, under a press and out of a fresh cut, and the shape that a press leaves.
//!
//! Only free juice can be squeezed out: flesh that binds its water, as all raw flesh does, gives none. Juice that leaves takes
//! its own heat with it, so that nothing is cooled by its leaving.

use saute_heat::Layout;

use crate::ZERO_C;
use crate::change::changes::arrhenius;
use crate::model::FoodModel;
use crate::state::FoodState;
use crate::water::juice::Runoff;

/// Pressure at which half of the free juice follows the press [Pa] (chosen: 40 N on a patty of 110 mm; a hand's weight
/// loses most of what a heavy press does).
const HALF_PA: f64 = 4.0e3;
/// Time in which what follows the press leaves [s] (chosen: the juice of a pressed patty has run out within half a minute).
const SQUEEZED_S: f64 = 20.0;
/// Speed of juice towards a fresh cut relative to that along the fibres [-] (chosen: the clefts between the bundles are
/// opened, and a steak that is cut at once loses about one per cent more).
const THROUGH_CLEFTS: f64 = 3.0;
/// Activation energy of that speed [kJ/mol] (chosen: the juice of rested meat, with its dissolved proteins, is seen to be
/// thicker; water alone has 16).
const THICKENS_KJ_MOL: f64 = 60.0;
/// Temperature at which that speed is stated [°C] (that of the release of juice).
const STATED_C: f64 = 65.0;
/// Distance beyond which a cut draws no juice [m] (chosen: the width of a few bundles).
const DRAWN_M: f64 = 0.015;

/// Largest strain that presses leave [-] (chosen: a smashed patty has little more than half its thickness).
const FLATTEST: f64 = 0.5;

impl FoodModel {
    /// Flattens a slice that is not ice under a pressure [Pa] for `dt` [s].
    ///
    /// Its strain ε creeps towards the share s of the elastic one that stays, dε/dt = (s p/E − ε)/τ, and never back.
    pub(crate) fn flatten(&self, state: &mut FoodState, pressure: f64, dt: f64) {
        let is_slice = matches!(self.shape.mesh.layout(), Layout::Upright(_));
        if pressure <= 0.0 || !self.shape.contracts || !is_slice || self.core_is_ice(state) {
            return;
        }
        let stays = self.kinetics.texture.set_share * pressure / (1e3 * self.elastic_modulus_kpa(state));
        let more = stays.min(FLATTEST) - state.stretch.flattened;
        state.stretch.flattened += more.max(0.0) * dt / (SQUEEZED_S + dt);
    }

    /// Squeezes free juice out of a piece under a pressure [Pa] for `dt` [s].
    ///
    /// dF/dt = −F/τ · p/(p + p½): the loss rises with the force and levels off.
    pub(crate) fn squeeze(&self, state: &mut FoodState, pressure: f64, dt: f64, runoff: &mut Runoff) {
        if pressure <= 0.0 {
            return;
        }
        let rate = dt / SQUEEZED_S * pressure / (pressure + HALF_PA);
        for node in 0..state.juice.len() {
            let left = state.juice[node] / (1.0 + rate);
            self.let_out(state, node, left, runoff);
        }
    }

    /// Lets free juice bleed from a halved piece towards its fresh faces for `dt` [s]: dF/dt = −F v(T)/d at a distance d.
    pub(crate) fn bleed(&self, state: &mut FoodState, dt: f64, runoff: &mut Runoff) {
        let Some(cut) = self.halved_at() else { return };
        let at_stated = THROUGH_CLEFTS * 1e-6 * self.kinetics.water_holding.juice_speed_um_s;
        let speed = arrhenius(THICKENS_KJ_MOL, STATED_C, at_stated);
        for node in 0..state.juice.len() {
            if state.juice[node] <= 0.0 {
                continue;
            }
            let away = libm::fabs(self.shape.along(node) - cut.at);
            if away < DRAWN_M {
                let rate = speed(state.temperature[node].max(ZERO_C)) * dt / away.max(1e-4);
                let left = state.juice[node] / (1.0 + rate);
                self.let_out(state, node, left, runoff);
            }
        }
    }
}
