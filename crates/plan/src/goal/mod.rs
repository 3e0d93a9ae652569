//! What a cook is to give ([`Goal`]), what it gave ([`Outcome`]), how good that is ([`Score`]), and what would have made it
//! better ([`Judgement`]).

mod better;
mod course;
mod grey_band;
mod judgement;
pub mod mark;
mod outcome;
pub mod score;
mod target;

pub use better::Better;
pub use course::Course;
pub use judgement::{GoalVerdict, Judged, Judgement};
pub use outcome::Outcome;
pub(crate) use outcome::at_core;
pub use score::{Score, Shortfall, Term, TermKind};
pub use target::{Goal, TargetError, Wish};
