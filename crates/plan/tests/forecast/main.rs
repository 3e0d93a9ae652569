//! Tests of forecasts, one file for each promise.
#![allow(clippy::unwrap_used)]

mod band;
mod comparison;
mod cost;
mod desk;
mod exact;
mod others;
