//! "Plan my steak": the card with what is asked and what was found.

mod answer;
pub mod card;
mod form;
mod time_line;
