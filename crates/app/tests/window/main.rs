//! The window, tested through the window.

mod foods;
mod harness;
mod pan;
mod steak;
mod views;
