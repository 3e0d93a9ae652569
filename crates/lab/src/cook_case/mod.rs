//! Validation cases that are cooks: a recipe, and what must come of it.

mod case;
mod course;

pub use case::{CookCase, Seen, SeenAt};
pub use course::{Coordinate, Course};
