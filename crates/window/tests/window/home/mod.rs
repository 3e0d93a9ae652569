//! What goes from the window to a kitchen at home, and comes back from there.

mod at_home;
mod followed;
mod plan;
mod refused;
mod searching;
