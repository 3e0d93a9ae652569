//! A piece of food in the kitchen: its place, its contacts and their heat transfer.

pub(crate) mod basting;
pub mod board;
pub mod building_time;
pub mod carry_over;
pub mod contact;
mod contact_2013;
pub mod contact_gap;
mod early_steam;
pub(crate) mod food_contact;
pub mod layout;
pub(crate) mod medium;
pub mod memory;
pub(crate) mod pan_contact;
pub(crate) mod piece_shape;
pub mod piece_state;
mod repour;
pub(crate) mod running;
pub mod sear_lines;
pub(crate) mod work;

pub use piece_state::{Piece, Place};
