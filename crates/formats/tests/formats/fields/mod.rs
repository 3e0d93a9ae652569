//! Promise: the files of fields hold the kitchen's own numbers on cells that fill the bodies.

mod brick;
mod lab;
mod notes;
mod pieces;
mod vtu;
