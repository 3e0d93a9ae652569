//! Steam of a face that is not as hot as boiling water: its film flashes on a hot surface, and it boils where it touches.

use crate::advance::{Exchange, FoodSolver};
use crate::model::FoodModel;
use crate::state::FoodState;
use crate::water::air_film::HOTTEST_WET;
use crate::water::vapour::latent_heat;

/// Largest share of a node's water that boils off in a tick [-] (chosen: as in air).
const MOST_AT_ONCE: f64 = 0.2;

impl FoodSolver {
    /// Turns free juice on the face of a patch into steam [kg], at most what is there, between two ticks. Adds it to `exchange`, and the heat
    /// that it took to the patch's contact: Q = m (L + h(T_b) − h(T)).
    ///
    /// The juice leaves at the boiling point, the flesh keeps its temperature. Ice does not flash.
    pub fn flash(
        &mut self,
        model: &FoodModel,
        state: &mut FoodState,
        patch: usize,
        mass: f64,
        exchange: &mut Exchange,
    ) {
        let node = model.shape.patches[patch].node as usize;
        let (t, juice) = (state.temperature[node], state.juice[node]);
        if !state.healthy || juice <= 0.0 || mass <= 0.0 || t < crate::ZERO_C {
            return;
        }
        let (cold, steam) = (model.properties.water_enthalpy(t), steam_enthalpy(model));
        let mass = mass.min(juice);
        // The other side books this juice and its heat: they stay gone if the next tick is undone.
        for state in self.sound.iter_mut().chain([state]) {
            state.enthalpy[node] -= mass * cold;
            state.water[node] -= mass;
            state.rising[node] *= 1.0 - mass / juice;
            state.juice[node] -= mass;
            state.evaporated += mass;
        }
        exchange.evaporated += mass;
        exchange.evaporation += mass * steam;
        self.contact_heat[patch] += mass * (steam - cold);
    }

    /// Turns water of the node of a patch into steam with `heat` [J] that the node has just got from its contact. Adds it to `exchange`.
    ///
    /// It boils where the face touches the metal, before the node as a whole does: m = Q / (L + h(T_b) − h(T)).
    pub fn boil_where_it_touches(
        &mut self,
        model: &FoodModel,
        state: &mut FoodState,
        patch: usize,
        heat: f64,
        exchange: &mut Exchange,
    ) {
        let node = model.shape.patches[patch].node as usize;
        let (t, Some(capacity)) = (state.temperature[node], self.capacity(node)) else { return };
        if !state.healthy || t < crate::ZERO_C {
            return;
        }
        let steam = steam_enthalpy(model);
        let rise = steam - model.properties.water_enthalpy(t);
        let mass = (heat / rise).min(MOST_AT_ONCE * state.water[node]);
        for state in self.sound.iter_mut().chain([state]) {
            state.enthalpy[node] -= mass * steam;
            state.temperature[node] -= mass * rise / capacity;
            state.water[node] -= mass;
            state.evaporated += mass;
        }
        exchange.evaporated += mass;
        exchange.evaporation += mass * steam;
    }
}

/// Enthalpy of steam at the boiling point, above liquid water at 0 °C [J/kg].
fn steam_enthalpy(model: &FoodModel) -> f64 {
    model.properties.water_enthalpy(HOTTEST_WET) + latent_heat(HOTTEST_WET)
}
