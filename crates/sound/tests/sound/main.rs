//! Promises on rendered samples: each says why it matters to a cook.

mod ear;
mod played;
mod signals;
mod steam;
mod struck;
