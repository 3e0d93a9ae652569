//! "Plan my steak": the card with what is asked and what was found, and the strip of a cook that follows a plan.

mod answer;
pub mod card;
mod form;
pub mod strip;
mod time_line;
