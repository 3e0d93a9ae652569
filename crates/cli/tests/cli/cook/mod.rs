//! `saute cook`: recipes, what it prints and writes, refusals and exit codes.

mod bad_input;
pub mod cooked;
mod doneness;
mod fields;
mod groups;
mod out_folder;
mod output;
mod recipes;
mod stopping;
mod wav;
