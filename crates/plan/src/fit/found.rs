//! What a fit found: the parameters with their uncertainty.

use serde::Serialize;

/// Quantile of the normal distribution for a two-sided interval of 90 % [-].
const Z90: f64 = 1.644_853_626_951_472_2;

/// A value with its 90 % interval.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Estimate {
    /// Most likely value.
    pub value: f64,
    /// Lower end of the 90 % interval.
    pub low: f64,
    /// Upper end of the 90 % interval.
    pub high: f64,
}

impl Estimate {
    /// Returns the estimate of a value by what it is at a number of standard deviations from the middle.
    pub(super) fn of(value: impl Fn(f64) -> f64) -> Self {
        Self { value: value(0.0), low: value(-Z90), high: value(Z90) }
    }

    /// Returns true if a value lies within the 90 % interval.
    pub fn holds(&self, value: f64) -> bool {
        (self.low..=self.high).contains(&value)
    }
}

/// What a fit found.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Found {
    /// Electrical power that reaches the pan's metal [-].
    pub hob_efficiency: Estimate,
    /// Factor on the contact conductance between food and pan [-].
    pub contact: Estimate,
    /// Thickness of the food [mm].
    pub thickness_mm: Estimate,
    /// Root mean square of the residuals over their standard deviations [-]; above 1 the model does not describe the log, and the
    /// intervals are widened by it.
    pub misfit: f64,
    /// Number of values that were compared [-].
    pub samples: usize,
    /// Number of rounds [-].
    pub rounds: usize,
}
