//! Planning with the simulator: it hands out work in small parts, and the program around it runs them.
//!
//! [`forecast`] says what comes of the present state of a cook, for what one may do now.

pub mod forecast;
