//! What goals, forecasts, plans and fits promise, in one program: one is linked sooner than many.

// A test that fails at an unwrap names its line.
#![allow(clippy::unwrap_used)]

mod advised;
mod fit;
mod forecast;
mod judgement;
mod logs;
mod verified;
