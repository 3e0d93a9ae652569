//! Reasons why bytes are no kitchen.

use crate::kitchen::SetupError;

/// Reason why a kitchen cannot be restored from bytes.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BytesError {
    /// The bytes do not begin as a kitchen.
    #[error("these bytes are no kitchen: give what Kitchen::to_bytes returned")]
    NoKitchen,
    /// Another version of the format.
    #[error(
        "the kitchen was stored in format {found}, this program reads format {known}: use the program that stored it"
    )]
    Format {
        /// Format of the bytes.
        found: u16,
        /// Format of this program.
        known: u16,
    },
    /// Another version of the program, whose physics may differ.
    #[error(
        "the kitchen was stored by saute {found}, this is saute {this}: use the program that stored it, or replay its session"
    )]
    Program {
        /// Version that stored it.
        found: String,
        /// This version.
        this: &'static str,
    },
    /// Bytes are missing at the end.
    #[error("the kitchen is cut off: {missing} bytes are missing at its end; store it again")]
    Truncated {
        /// Number of missing bytes [-].
        missing: u64,
    },
    /// Bytes were changed.
    #[error("the kitchen is damaged: its bytes are not those that were stored; store it again")]
    Damaged,
    /// The data files have changed since.
    #[error("{what} is not the one with which the kitchen was stored: use the --data folder of then")]
    OtherData {
        /// What differs, as `the food "mine"`.
        what: String,
    },
    /// The pan or a food can no longer be built.
    #[error(transparent)]
    Setup(#[from] SetupError),
}
