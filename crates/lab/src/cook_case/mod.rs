//! Cook cases: validation cases that cook a recipe and compare its results with expected bands.

mod case;
mod course;

pub use case::{CookCase, Seen, SeenAt};
pub use course::{Coordinate, Course};
