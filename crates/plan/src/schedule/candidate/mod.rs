//! One candidate of a search: how it is cooked and rested, and what came of it.

mod cooking;
mod fork;
pub(crate) mod job;
mod stove;

pub use cooking::Cooking;
pub(crate) use stove::work_of_second;
