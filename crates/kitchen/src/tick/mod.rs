//! Time: frames of rigid-body motion, ticks of heat and mass transfer, the energy account and the event log.

mod air_round;
pub(crate) mod clock;
pub mod energy;
pub mod event;
#[cfg(test)]
mod frozen_piece;
mod heat_tick;
pub(crate) mod lapse;
pub(crate) mod low_pass;
mod motion;
mod rest;
