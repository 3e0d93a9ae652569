//! What recipes and sessions promise, in one program.

mod actions;
mod conditions;
mod ends;
mod frozen;
mod individual;
mod recipes;
mod repeat;
mod sessions;
mod shipped;
mod stoves;
