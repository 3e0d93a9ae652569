//! Juice that leaves otherwise than by itself, under a press and out of a fresh cut, and the shape that a press leaves.
//!
//! Only free juice can be squeezed out: flesh that holds its water, as all raw flesh does, gives none. Juice that leaves takes
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
    /// Presses a piece under a pressure [Pa] for `dt` [s]; returns the juice that ran off.
    pub(crate) fn press(&self, state: &mut FoodState, pressure: f64, dt: f64) -> Runoff {
        if pressure <= 0.0 {
            return Runoff::default();
        }
        self.flatten(state, pressure, dt);
        self.squeeze(state, pressure, dt)
    }

    /// Flattens a slice that is not ice: its strain ε creeps towards the share s of the elastic one that stays, dε/dt = (s p/E − ε)/τ, and
    /// never back.
    fn flatten(&self, state: &mut FoodState, pressure: f64, dt: f64) {
        let stays = self.kinetics.texture.set_share * pressure / (1e3 * self.elastic_modulus_kpa(state));
        let left = stays.min(FLATTEST) - state.stretch.flattened;
        let ice = self.description.freezing.as_ref();
        let frozen = ice.is_some_and(|ice| self.core_temperature(state) < ZERO_C + ice.begins_c);
        let is_slice = matches!(self.shape.mesh.layout(), Layout::Upright(_));
        if self.shape.contracts && is_slice && !frozen && left > 0.0 {
            state.stretch.flattened += left * dt / (SQUEEZED_S + dt);
        }
    }

    /// Squeezes free juice out of a piece under a pressure [Pa] for `dt` [s].
    ///
    /// dF/dt = −F/τ · p/(p + p½): the loss rises with the force and levels off.
    fn squeeze(&self, state: &mut FoodState, pressure: f64, dt: f64) -> Runoff {
        let rate = dt / SQUEEZED_S * pressure / (pressure + HALF_PA);
        let mut runoff = Runoff::default();
        (0..state.juice.len()).for_each(|node| self.let_out(state, node, rate, &mut runoff));
        state.dripped += runoff.mass;
        runoff
    }

    /// Lets free juice bleed from a halved piece towards its fresh faces for `dt` [s]: dF/dt = −F v(T)/d at a distance d.
    pub(crate) fn bleed(&self, state: &mut FoodState, dt: f64) -> Runoff {
        let mut runoff = Runoff::default();
        let Some(cut) = self.halved_at() else { return runoff };
        let speed = THROUGH_CLEFTS * 1e-6 * self.kinetics.water_holding.juice_speed_um_s;
        let speed = arrhenius(THICKENS_KJ_MOL, STATED_C, speed);
        for node in 0..state.juice.len() {
            let away = libm::fabs(self.shape.along(node) - cut.at);
            if state.juice[node] > 0.0 && away < DRAWN_M {
                let rate = speed(state.temperature[node].max(ZERO_C)) * dt / away.max(1e-4);
                self.let_out(state, node, rate, &mut runoff);
            }
        }
        state.dripped += runoff.mass;
        runoff
    }

    /// Lets a share rate/(1 + rate) of a node's free juice out, at its own temperature.
    fn let_out(&self, state: &mut FoodState, node: usize, rate: f64, runoff: &mut Runoff) {
        if state.juice[node] <= 0.0 {
            return;
        }
        let share = rate / (1.0 + rate);
        let mass = share * state.juice[node];
        let enthalpy = mass * self.properties.water_enthalpy(state.temperature[node]);
        state.juice[node] -= mass;
        state.rising[node] -= share * state.rising[node];
        state.water[node] -= mass;
        state.enthalpy[node] -= enthalpy;
        runoff.mass += mass;
        runoff.enthalpy += enthalpy;
    }
}
