//! What leads a person: studies, lessons, the tutorial, goals and results, plans, the kitchen at home.

mod at_home;
mod goal_choice;
mod guided;
mod plan;
mod result;
mod tutorial;
