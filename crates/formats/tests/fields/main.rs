//! Promise: the files of fields hold the kitchen's own numbers on cells that fill the bodies.

#![allow(clippy::unwrap_used)]

mod brick;
mod lab;
mod pieces;
mod vtu;
