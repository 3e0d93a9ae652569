//! Kinds of evidence for expected values.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The kind of evidence for the expected values of a case.
#[derive(Clone, Copy, Debug, Deserialize, Serialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub enum Evidence {
    /// A closed-form or series solution, or an identity.
    Exact,
    /// A published measurement or computation.
    Measured,
    /// A range on which kitchen practice or several sources agree.
    KitchenBand,
    /// Values for comparison only, as cooks' tables: the case passes or fails nothing.
    Information,
}

impl Evidence {
    /// All kinds, strongest first.
    pub const ALL: [Self; 4] = [Self::Exact, Self::Measured, Self::KitchenBand, Self::Information];

    /// Returns whether a value holds that is `within` its tolerance or not; none for information.
    pub fn judge(self, within: bool) -> Option<bool> {
        (self != Self::Information).then_some(within)
    }
}
