//! Tests of a piece of food on a plate, by what they promise.

mod balance;
mod body;
mod change;
mod composition;
mod juice;
mod run;
