//! "Plan my steak": the card with what is asked and what was found.

mod answer;
pub mod card;
mod form;
pub mod plan_state;
mod time_line;
