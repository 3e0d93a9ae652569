//! What a cook is wanted to give ([`Goal`]), what it gave ([`Outcome`]), and how good that is ([`Score`]).

mod outcome;
mod score;
mod target;

pub use outcome::Outcome;
pub(crate) use outcome::at_core;
pub use score::{Score, Shortfall};
pub use target::{Goal, TargetError, Wish};
