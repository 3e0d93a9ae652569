//! Tests of forecasts, one file for each promise.
#![allow(clippy::unwrap_used)]

mod band;
mod comparison;
mod desk;
mod exact;
