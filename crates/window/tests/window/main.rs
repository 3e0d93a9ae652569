//! The window, tested through the window.

mod advice;
mod at_hand;
mod contrast;
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
mod now;
mod pan;
mod photo;
mod settings;
mod steak;
mod teaching;
mod time;
mod touch;
mod unseen;
mod views;
mod ways;
