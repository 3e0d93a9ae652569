//! Lessons for a class: scenarios with locks, hidden read-outs and questions at which the cook pauses, and the results of a class.
//!
//! A [`Scenario`] is a checked scenario file. A [`Lesson`] watches a cook of it: it states when a question is due, keeps answers, and finds
//! the truth to compare them with in the cook itself. [`ResultRow`] is what a student hands in, [`ClassSummary`] what a class did. This module
//! has no clock and opens no file.

mod check;
mod collect;
mod early_truth;
mod histogram;
mod lesson;
pub mod rest;
mod result_row;
mod scenario;
pub mod scenario_file;
pub mod shipped;

pub use self::collect::{ClassSummary, QuestionSummary, ScenarioSummary};
pub use self::histogram::Bar;
pub use self::lesson::{Asked, Lesson};
pub use self::result_row::{MOST_QUESTIONS, RestKind, ResultRow, from_csv, to_csv};
pub use self::scenario::{Ask, Predict, Scenario, When, Words};
pub use self::scenario_file::{Deed, Locked};
