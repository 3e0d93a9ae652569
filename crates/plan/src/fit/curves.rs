//! What a fitted kitchen would have shown all along: curves next to the log.

use saute_kitchen::TICKS_PER_S;
use serde::{Deserialize, Serialize};

use super::observed::Quantity;
use super::predict::{FitError, Job, value};

/// Time between two points [s] (chosen: a curve of ten minutes has 150).
const EVERY_S: u32 = 4;

/// Curves of pan and core: times [s] and temperatures [K].
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Curves {
    /// Mean temperature of the pan's floor.
    pub pan: Vec<(f64, f64)>,
    /// Temperature of the core of the first food.
    pub core: Vec<(f64, f64)>,
}

/// The cook of a job to the end of its recipe, second by second.
#[derive(Clone, Debug)]
pub struct Drawing {
    cook: saute_recipe::Cook,
    elapsed_s: u32,
    curves: Curves,
}

impl Drawing {
    /// Begins with the kitchen of a job.
    ///
    /// # Errors
    ///
    /// If the kitchen cannot be built.
    pub fn begin(job: &Job) -> Result<Self, FitError> {
        Ok(Self { cook: job.cook()?, elapsed_s: 0, curves: Curves::default() })
    }

    /// Cooks on for a second; returns the curves at the end of the recipe.
    ///
    /// # Errors
    ///
    /// If a step cannot be carried out.
    pub fn second(&mut self) -> Result<Option<Curves>, FitError> {
        let kitchen = &self.cook.kitchen;
        if self.elapsed_s.is_multiple_of(EVERY_S) {
            let now = kitchen.time_s();
            self.curves.pan.push((now, value(kitchen, Quantity::Pan)));
            self.curves.core.push((now, value(kitchen, Quantity::Core)));
        }
        if self.cook.stopped().is_some() {
            return Ok(Some(std::mem::take(&mut self.curves)));
        }
        for _ in 0..TICKS_PER_S {
            self.cook.advance().map_err(|e| FitError::Cook(e.to_string()))?;
        }
        self.elapsed_s += 1;
        Ok(None)
    }
}
