//! Recipes: the file format, its checks, the runner that executes a recipe in a kitchen, and the summary of the result.
//!
//! A [`Recipe`] is a checked recipe file in SI units. A [`Cook`] joins a [`Kitchen`](saute_kitchen::Kitchen), a [`Runner`]
//! and a [`Recorder`]; a [`Summary`] is its result. This crate opens no file and reads no clock.
//!
//! Between ticks, [`Runner::poll`] starts each step that is due; the next step waits until the duration of the action has
//! passed and the kitchen has finished it. [`ActionKind`] lists the actions. The value of an action is a table; a bare
//! value is shorthand for one. The documentation, ranges and defaults of actions are those of the JSON Schema, from which
//! `saute list actions` is printed. A group is several pieces under one name: the runner finds places for them and sends
//! the kitchen one command for each. `saute cook`, `saute shot` and the tests play recipes through [`Cook`].
//!
//! A thin steak on a hot pan, for five seconds:
//!
//! ```
//! use saute_kitchen::Library;
//! use saute_recipe::{Cook, Recipe, StoppedBy};
//!
//! let text = r#"
//! [pan]
//! initial_c = 180
//! [[food]]
//! id = "steak"
//! kind = "beef-lean"
//! size_mm = [60, 50, 15]
//! initial_c = 5
//! mesh = "2013"
//! [[step]]
//! put = "steak"
//! [[step]]
//! at_s = 5
//! end = true
//! "#;
//! let library = Library::embedded()?;
//! let mut cook = Cook::new(Recipe::parse(text, "thin.toml", &library)?, &library)?;
//! while cook.stopped().is_none() {
//!     cook.advance()?;
//! }
//! assert_eq!(cook.stopped(), Some(StoppedBy::End));
//!
//! let summary = cook.summary(0.0);
//! assert_eq!(summary.simulated_s, 5.0);
//! let steak = &summary.foods[0];
//! // The lower face is hot, the core still at 5 °C.
//! assert!(steak.surfaces.bottom.temperature_c > 40.0, "{} °C", steak.surfaces.bottom.temperature_c);
//! assert!((steak.core_c.end - 5.0).abs() < 0.5, "{} °C", steak.core_c.end);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod action;
mod check;
pub mod condition;
pub mod cook;
pub mod file;
pub mod full_pan;
pub mod probe;
pub mod recipe;
pub mod session;
pub mod summary;

pub use action::{Action, ActionKind, FoodAction, PanAction, Repeat, RepeatEnd};
pub use condition::{Condition, Measured, Side};
pub use cook::play::{Cook, Fired};
pub use cook::recorder::{self, Recorder};
pub use cook::runner::{self, Runner, StoppedBy};
pub use cook::runner_state::RunnerState;
pub use cook::step_record;
pub use file::{recipe_file, shorthand, step_file};
pub use recipe::{Group, Recipe, Step, Target, Trigger};
pub use session::{Moment, Recording, Replay};
pub use summary::{Summary, cook_summary, group_summary};
