//! "My kitchen": what was observed at a real stove, the fit to it, and the kitchen that was found.

use saute_session::at_home::entered::{Cooked, Row};
use saute_session::at_home::open_log::Columns;

/// Scale in whose classes what was seen on the cut is stated.
pub const SCALE: &str = "chefs";

/// What is done about the kitchen at home.
#[derive(Clone, Debug, PartialEq)]
pub enum AtHomeAct {
    /// Changes what was entered by hand.
    Rows(Vec<Row>),
    /// Chooses the columns of the log.
    Columns(Columns),
    /// Chooses what was cooked.
    Cooked(Cooked),
    /// Puts the log away.
    NoLog,
    /// Fits the kitchen.
    Fit,
    /// Ends the fit.
    Cancel,
    /// Keeps the kitchen that was found, and cooks in it from now on.
    Keep,
    /// Cooks in the kitchen that is kept, or in the typical one.
    Use(bool),
    /// Forgets the kitchen that is kept.
    Forget,
}
