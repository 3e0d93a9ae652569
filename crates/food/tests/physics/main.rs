//! Tests of a piece of food on a plate, one file for each promise.

mod balance;
mod body;
mod change;
mod colour;
mod composition;
mod ice;
mod juice;
mod reduced;
mod run;
