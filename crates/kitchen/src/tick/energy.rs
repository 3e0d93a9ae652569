//! The energy account: where the hob's energy went.

use serde::Serialize;

/// Energy account since the start [J]. Each term is the sum of its own fluxes or a difference of its own state.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
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
