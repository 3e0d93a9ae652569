//! What is measured at every hour, and what must hold.

use saute_kitchen::Kitchen;
use saute_kitchen::food::{FoodModel, FoodState};

/// Largest error of the balances over the gross exchange [-].
pub const IMBALANCE: f64 = 1e-9;

/// Figures of one hour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Figures {
    /// Error of the energy balance over the gross exchange [-].
    pub energy: f64,
    /// Largest error of the mass balance of a piece over what it lost and has [-].
    pub mass: f64,
}

impl Figures {
    /// Measures a kitchen.
    pub fn of(kitchen: &Kitchen) -> Self {
        let energy = kitchen.energy();
        let gross = energy.hob.abs() + energy.air.abs() + energy.evaporation.abs() + energy.other.abs();
        let pieces = kitchen.pieces().iter();
        let mass = pieces.map(|p| mass_error(&p.model, &p.state)).fold(0.0, f64::max);
        Self { energy: energy.imbalance.abs() / gross.max(1.0), mass }
    }

    /// Returns true if both balances close.
    pub fn balance(&self) -> bool {
        self.energy <= IMBALANCE && self.mass <= IMBALANCE
    }
}

/// Returns the error of raw mass less all that left, over the raw mass [-].
fn mass_error(model: &FoodModel, state: &FoodState) -> f64 {
    let raw = model.raw_mass();
    let lost = state.evaporated + state.dripped + state.rendered;
    (raw - lost - state.mass(model)).abs() / raw
}
