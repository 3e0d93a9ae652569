//! What is ahead of the piece that the panels show: forecasts as a line of words, as a table, and as curves.

pub mod future_curves;
pub mod line;
pub mod table;
