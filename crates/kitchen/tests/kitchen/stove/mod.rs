//! What tests of a kitchen begin with.

use saute_kitchen::{Command, Kitchen, Library, TICK_S};

/// The data that the program carries.
pub fn library() -> Library {
    Library::embedded().expect("embedded data")
}

/// Lets a kitchen go on for a time [s].
pub fn run(kitchen: &mut Kitchen, seconds: f64) {
    (0..(seconds / TICK_S).round() as usize).for_each(|_| kitchen.step());
}

/// Has a command carried out that the kitchen must take.
pub fn apply(kitchen: &mut Kitchen, command: Command) {
    kitchen.apply(&command).expect("accepted");
}

/// Energy that does not add up, relative to what moved [-].
pub fn imbalance(kitchen: &Kitchen) -> f64 {
    let e = kitchen.energy();
    let moved = e.hob.abs() + e.pan_stored.abs() + e.evaporation.abs() + e.air.abs() + e.other.abs();
    e.imbalance.abs() / moved.max(1.0)
}
