//! The half mirror's window, its picture, its calibration by hand, and stills of it.
//!
//! Room, hob and pan are left out of the picture; the pan remains as a black occluder.

pub mod aim;
pub mod frame;
pub mod pattern;
pub mod presenter;
pub mod view;
