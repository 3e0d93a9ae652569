//! Promises of studies and lessons, without a window.

mod analysis;
mod lessons;
mod protocols;
mod way;
