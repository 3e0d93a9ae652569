//! "My kitchen": the card with what was observed and what was found, and the word beside the pan.

pub mod at_home_state;
pub mod card;
pub mod chip;
mod entry;
mod found;
mod log;
