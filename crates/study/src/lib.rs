//! Studies: protocols with phases, conditions and questionnaires, the logs of their participants, and the analysis of logs.
//!
//! A [`Protocol`] is a checked protocol file. A [`Study`] is one participant's way through it: [`Event`]s become rows of the log
//! ([`LogRow`]), whose columns are described in [`dictionary`]. [`Simulation`] lets simulated participants take part, [`Analysis`] makes
//! learning curves of logs. [`class`] has lessons and the results of a class. This crate has no clock and opens no file: the window and
//! the command line write the rows.
//!
//! Nothing personal is kept: a participant is a code ([`Participant`]), times are relative.

pub mod analysis;
mod check;
pub mod class;
mod csv_rows;
pub mod dictionary;
mod log_row;
mod measures;
mod pace;
mod participant;
mod protocol;
pub mod protocol_file;
mod random;
mod set_out;
pub mod shipped;
pub mod simulated;
mod state;

pub use self::analysis::Analysis;
pub use self::log_row::{LogError, LogRow, RowKind, from_csv, to_csv, with_all_columns};
pub use self::measures::{Measures, Times};
pub use self::pace::{Pace, PaceMeter};
pub use self::participant::{NoCode, Participant};
pub use self::protocol::{
    Answering, Condition, CookForReal, Item, LIKERT_STEPS, Phase, Protocol, Questionnaire, Simulate, Task,
};
pub use self::simulated::Simulation;
pub use self::state::{Answer, Answers, Event, Stage, Study, StudyError};
