//! The coach: what happens to the food, and what to perceive next.

pub mod coach;
pub mod hear;
