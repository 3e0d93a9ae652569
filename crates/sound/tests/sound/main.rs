//! Promises on rendered samples: each says why it matters to a cook.

mod ear;
mod signals;
mod steam;
mod struck;
