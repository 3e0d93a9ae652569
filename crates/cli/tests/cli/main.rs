//! The command as its users see it: what it prints, writes, refuses, and how it exits.

// A test that unwraps in vain says where.
#![allow(clippy::unwrap_used)]

mod architecture;
mod bad_input;
mod cooked;
mod data_folder;
mod doneness;
mod food_check;
mod gallery;
mod groups;
mod haptics;
mod layers;
mod lists;
mod looks;
mod out_folder;
mod output;
mod recipes;
mod running;
mod schema;
mod sources;
mod stopping;
mod validation;
