//! The window, tested through the window.

mod foods;
mod hand;
mod harness;
mod japanese;
mod mirror;
mod pan;
mod settings;
mod steak;
mod views;
