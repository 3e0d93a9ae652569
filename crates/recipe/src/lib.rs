//! Recipes: the file format, its checks, the runner that plays it in a kitchen, and the record of what came of it.
//!
//! A [`Recipe`] is checked text in SI units. A [`Cook`] is a [`Kitchen`](saute_kitchen::Kitchen), a [`Runner`] and a
//! [`Recorder`] together; a [`Summary`] is its result. Nothing here opens a file or reads a clock.

pub mod action;
mod check;
pub mod cook;
pub mod file;
pub mod recipe;
pub mod summary;

pub use action::{Action, ActionKind, FoodAction, PanAction};
pub use cook::play::{Cook, Fired};
pub use cook::recorder::{self, Recorder};
pub use cook::runner::{self, Runner, StoppedBy};
pub use cook::step_record;
pub use file::{action_file, recipe_file, shorthand, step_file};
pub use recipe::{Group, Recipe, Step, Target, Trigger};
pub use saute_kitchen::{InputError, InputText};
pub use summary::{Summary, cook_summary, group_summary};
