//! Tests of forecasts, one file for each promise.
mod band;
mod comparison;
mod cost;
mod desk;
mod exact;
mod others;
