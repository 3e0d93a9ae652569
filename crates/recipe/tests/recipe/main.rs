//! What recipes and sessions promise, in one program.

mod actions;
mod conditions;
#[path = "../../../kitchen/tests/kitchen/draws/mod.rs"]
mod draws;
mod ends;
mod frozen;
mod recipes;
mod repeat;
mod sessions;
mod shipped;
mod stoves;
