//! What a fit found: the parameters with their uncertainty.

use saute_kitchen::Library;
use saute_kitchen::data::at_home::KitchenAtHome;
use saute_kitchen::food::description::Confidence;
use serde::{Deserialize, Serialize};

use super::observed::Quantity;
use super::parameters::Parameters;

/// Quantile of the normal distribution for a two-sided interval of 90 % [-].
const Z90: f64 = 1.644_853_626_951_472_2;

/// A value with its 90 % interval.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
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

    /// Returns true if a value is within the 90 % interval.
    pub fn holds(&self, value: f64) -> bool {
        (self.low..=self.high).contains(&value)
    }
}

/// Misfit from which the model does not describe a log [-] (chosen: residuals of twice the errors of thermometers).
pub const LARGEST_MISFIT: f64 = 2.0;

/// Misfit up to which what was found is of medium confidence, above it of low [-] (chosen: as the thermometers err).
const GOOD_MISFIT: f64 = 1.0;

/// Where a fit misses what was measured most.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct Worst {
    /// What was measured.
    pub quantity: Quantity,
    /// Time of the cook [s].
    pub at_s: f64,
    /// What was read [K, kg].
    pub read: f64,
    /// What the fitted kitchen would have shown [K, kg].
    pub expected: f64,
    /// How far they are apart, over the thermometer's standard deviation [-].
    pub off: f64,
}

/// What a fit found.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct FitResult {
    /// Electrical power that reaches the pan's metal [-].
    pub hob_efficiency: Estimate,
    /// Factor on the contact conductance between food and pan [-].
    pub contact: Estimate,
    /// Thickness of the food [mm].
    pub thickness_mm: Estimate,
    /// Root mean square of the residuals over their standard deviations, outlying ones counted less [-]; above 1 the model does not
    /// describe the log, and the intervals are widened by it.
    pub misfit: f64,
    /// Number of values that were compared [-].
    pub samples: usize,
    /// Where it misses most.
    pub worst: Worst,
    /// True if a value is at the end of the range in which it was searched.
    pub is_at_bound: bool,
    /// Number of rounds [-].
    pub rounds: usize,
}

impl FitResult {
    /// Returns true if the model describes what was measured.
    pub fn describes(&self) -> bool {
        self.misfit <= LARGEST_MISFIT
    }

    /// Returns the most likely parameters.
    pub fn parameters(&self) -> Parameters {
        let Self { hob_efficiency, contact, thickness_mm, .. } = self;
        Parameters {
            hob_efficiency: hob_efficiency.value,
            contact: contact.value,
            thickness: 1e-3 * thickness_mm.value,
        }
    }

    /// Returns the kitchen that was found with the data of a library, as factors on the shipped data: a library that contains an earlier
    /// fit has its factors in it already.
    pub fn at_home(&self, library: &Library, log: &str) -> KitchenAtHome {
        let (assumed, earlier) = (library.hob.efficiency(), &library.at_home);
        let Self { samples, misfit, .. } = self;
        KitchenAtHome {
            hob: earlier.hob.clone(),
            hob_factor: earlier.hob_factor * self.hob_efficiency.value / assumed,
            contact_factor: earlier.contact_factor * self.contact.value,
            source: format!("fitted to {samples} values of {log}; misfit {misfit:.2}"),
            confidence: if *misfit <= GOOD_MISFIT { Confidence::Medium } else { Confidence::Low },
        }
    }
}
