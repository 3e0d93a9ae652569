//! The energy account: where the hob's energy went.

use serde::{Deserialize, Serialize};

/// Energy account since the start [J]. Each term is the sum of its own fluxes or a difference of its state.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Energy {
    /// Electrical energy from the hob.
    pub hob: f64,
    /// Stored in the pan, its liquids and its lid.
    pub pan_stored: f64,
    /// Stored in foods.
    pub food_stored: f64,
    /// Convection and radiation to air and walls.
    pub air: f64,
    /// Enthalpy of the vapour above liquid water at 0 °C.
    pub evaporation: f64,
    /// Losses of the hob, heat in glass, cloth and board, oil and juice that left pan or food.
    pub other: f64,
    /// `hob` minus all other terms; zero up to rounding and linearisation.
    pub imbalance: f64,
}

impl Energy {
    /// Returns the account with `imbalance` computed.
    pub fn balanced(mut self) -> Self {
        self.imbalance = self.hob - self.pan_stored - self.food_stored - self.air - self.evaporation - self.other;
        self
    }
}

/// Running sums behind the energy account [J].
#[derive(Clone, Copy, Debug, Deserialize, Serialize)]
pub(crate) struct EnergyAccount {
    /// Sums of the fluxes.
    pub(crate) flows: Energy,
    pan_at_start: f64,
    foods_at_start: f64,
}

impl EnergyAccount {
    /// An account that starts with the energy stored in the pan [J] and without foods.
    pub(crate) fn new(pan_stored: f64) -> Self {
        Self { flows: Energy::default(), pan_at_start: pan_stored, foods_at_start: 0.0 }
    }

    /// Adds energy that a command brought into the pan's store [J].
    pub(crate) fn add_to_pan(&mut self, stored: f64) {
        self.pan_at_start += stored;
    }

    /// Adds the energy stored in a new food [J].
    pub(crate) fn add_food(&mut self, stored: f64) {
        self.foods_at_start += stored;
    }

    /// Removes the energy stored in a food that leaves the kitchen [J].
    pub(crate) fn remove_food(&mut self, stored: f64) {
        self.foods_at_start -= stored;
    }

    /// Returns the balanced account, given the energy stored now in the pan and in the foods [J].
    pub(crate) fn balance(&self, pan_stored: f64, foods_stored: f64) -> Energy {
        Energy {
            pan_stored: pan_stored - self.pan_at_start,
            food_stored: foods_stored - self.foods_at_start,
            ..self.flows
        }
        .balanced()
    }
}
