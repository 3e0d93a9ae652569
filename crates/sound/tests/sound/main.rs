//! Promises on rendered samples: each states why it matters to a cook.

mod ear;
mod played;
mod signals;
mod steam;
mod stove;
mod struck;
