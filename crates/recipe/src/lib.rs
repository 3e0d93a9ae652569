//! Recipes: the file format, its checks, the runner that plays it in a kitchen, and the record of what came of it.
//!
//! A [`Recipe`] is checked text in SI units. A [`Cook`] is a [`Kitchen`](saute_kitchen::Kitchen), a [`Runner`] and a
//! [`Recorder`] together; a [`Summary`] is its result. Nothing here opens a file or reads a clock.
//!
//! A recipe is a list of steps. Between ticks, `Runner::poll` starts each step that is due; it continues when the
//! duration of the action has passed and the kitchen is no longer busy with it. The value of an action is a table; a
//! bare value is shorthand for one. The documentation, ranges and defaults of actions are those of the JSON Schema,
//! from which `saute list actions` is printed. A group is several pieces under one name: the runner finds places for
//! them and sends the kitchen one command for each. `saute cook`, `saute shot`, the tests and the window play recipes
//! through the same `Cook`.

mod check;
pub mod cook;
pub mod file;
pub mod recipe;
pub mod summary;

pub use cook::play::{Cook, Fired};
pub use cook::recorder::{self, Recorder};
pub use cook::runner::{self, Runner, StoppedBy};
pub use cook::step_record;
pub use file::{action_file, recipe_file, shorthand};
pub use recipe::{Action, Deed, Group, Recipe, Step, Target, Trigger};
pub use saute_kitchen::{InputError, InputText};
pub use summary::{Summary, cook_summary, group_summary};
