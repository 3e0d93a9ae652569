//! Time: frames in which bodies move, ticks in which heat flows, and what is recorded of them.

pub mod energy;
pub mod event;
mod heat_tick;
mod motion;
