//! The window, tested through the window.

mod at_hand;
mod contrast;
mod cook;
mod foods;
mod forecasts;
mod guided;
mod hand;
mod harness;
mod home;
mod japanese;
mod keys;
mod language;
mod mirror;
mod pan;
mod photo;
mod settings;
mod sound;
mod steak;
mod teaching;
mod time;
mod touch;
mod views;
mod ways;
