//! The window, tested through the window.

mod foods;
mod harness;
mod japanese;
mod pan;
mod settings;
mod steak;
mod views;
