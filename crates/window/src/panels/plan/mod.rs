//! "Plan my steak": the card with the request and the result.

mod answer;
pub mod card;
mod form;
mod time_line;
