//! Where the hob's energy went.

use serde::Serialize;

/// Energy since the start [J]; each term is summed from its own fluxes or taken from its own state.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Energy {
    /// Electrical energy from the hob.
    pub hob: f64,
    /// Stored in the pan, in what is liquid in it, and in its lid.
    pub pan_stored: f64,
    /// Stored in foods.
    pub food_stored: f64,
    /// Convection and radiation to air and walls.
    pub air: f64,
    /// Enthalpy of the vapour above liquid water at 0 °C.
    pub evaporation: f64,
    /// Losses of the hob, heat in glass, cloth and board, oil and juice that left pan or food.
    pub other: f64,
    /// `hob` less all others.
    pub imbalance: f64,
}

impl Energy {
    /// Fills in `imbalance`.
    pub fn balanced(mut self) -> Self {
        self.imbalance = self.hob - self.pan_stored - self.food_stored - self.air - self.evaporation - self.other;
        self
    }
}
