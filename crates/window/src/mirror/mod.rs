//! The half mirror's window, its picture, its calibration by hand.
//!
//! Room, hob and pan are left out of the picture; the pan remains as a black occluder.

pub mod aim;
pub mod callback;
pub mod pattern;
pub mod view;
