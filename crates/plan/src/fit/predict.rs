//! What a kitchen with given parameters would have measured: one job of a fit.

use std::sync::Arc;

use saute_kitchen::{Kitchen, Library, TICKS_PER_S};
use saute_recipe::{Cook, Recipe};

use super::levels::Level;
use super::observed::{END, Quantity, Sample};
use super::parameters::Parameters;

/// A reason for which a cook cannot be compared with a log.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FitError {
    /// Nothing was measured.
    #[error(
        "the log holds no value that can be compared; give a column of core or pan temperatures, a weight or a class"
    )]
    Nothing,
    /// The recipe has no food.
    #[error("the recipe has no food; a fit needs the food that was cooked")]
    NoFood,
    /// A step waits for a condition.
    #[error(
        "step {step} (line {line}) waits for a condition, which the simulation meets at another time than your kitchen did; write at_s with the time at which you did it"
    )]
    Condition {
        /// Number of the step, from 1.
        step: usize,
        /// Line in the recipe, from 1.
        line: usize,
    },
    /// The kitchen cannot be built or the recipe cannot be carried out with parameters that were tried.
    #[error("{0}")]
    Cook(String),
    /// The cook ended before a value was measured.
    #[error(
        "a value was measured at {at_s:.0} s, but the recipe ends at {end_s:.0} s; let the recipe last longer, or shift the log's time"
    )]
    Ended {
        /// Time of the value [s].
        at_s: f64,
        /// End of the recipe [s].
        end_s: f64,
    },
}

/// A cook with parameters that are tried.
#[derive(Clone, Debug)]
pub struct Job {
    /// Number within its round.
    pub number: usize,
    pub(super) recipe: Arc<Recipe>,
    pub(super) library: Arc<Library>,
    pub(super) samples: Arc<Vec<Sample>>,
    pub(super) parameters: Parameters,
    pub(super) level: Level,
}

impl Job {
    /// Cooks, and returns the values at the times of the samples [K, kg]; NaN for a row of a log after the end of the cook.
    ///
    /// # Errors
    ///
    /// If the kitchen cannot be built, a step cannot be carried out, or the cook ends before all rows or before another value.
    pub fn run(&self) -> Result<Vec<f64>, FitError> {
        let mut predicting = Predicting::begin(self)?;
        loop {
            if let Some(values) = predicting.second()? {
                return Ok(values);
            }
        }
    }

    /// The kitchen in which it cooks, and what.
    pub(super) fn cook(&self) -> Result<Cook, FitError> {
        let mut library = (*self.library).clone();
        self.parameters.set_in(&mut library);
        let mut recipe = (*self.recipe).clone();
        self.parameters.set_in_recipe(&mut recipe);
        self.level.set_in(&mut recipe);
        Cook::new(recipe, &library).map_err(|e| FitError::Cook(e.to_string()))
    }
}

/// A job that is under way, second by second: it can be left and gone on with.
#[derive(Clone, Debug)]
pub struct Predicting {
    cook: Cook,
    samples: Arc<Vec<Sample>>,
    values: Vec<f64>,
}

impl Predicting {
    /// Begins a job.
    ///
    /// # Errors
    ///
    /// If the kitchen cannot be built.
    pub fn begin(job: &Job) -> Result<Self, FitError> {
        Ok(Self { cook: job.cook()?, samples: Arc::clone(&job.samples), values: Vec::new() })
    }

    /// Cooks on for a second at most; returns the values of all samples once the last one is reached [K, kg].
    ///
    /// # Errors
    ///
    /// As [`Job::run`].
    pub fn second(&mut self) -> Result<Option<Vec<f64>>, FitError> {
        for _ in 0..TICKS_PER_S {
            while let Some(sample) = self.samples.get(self.values.len()) {
                match reached(&self.cook, sample)? {
                    Reached::NotYet => break,
                    Reached::Now => self.values.push(value(&self.cook.kitchen, sample.quantity)),
                    Reached::Never => self.values.push(f64::NAN),
                }
            }
            if self.values.len() == self.samples.len() {
                return self.all().map(Some);
            }
            self.cook.advance().map_err(|e| FitError::Cook(e.to_string()))?;
        }
        Ok(None)
    }

    /// The values of all samples, if one of them was reached.
    fn all(&mut self) -> Result<Vec<f64>, FitError> {
        match self.samples.first() {
            Some(first) if self.values.iter().all(|value| value.is_nan()) => {
                Err(FitError::Ended { at_s: first.at_s, end_s: self.cook.kitchen.time_s() })
            }
            _ => Ok(std::mem::take(&mut self.values)),
        }
    }
}

/// Whether a cook has reached the time of a sample.
enum Reached {
    NotYet,
    Now,
    Never,
}

/// A log may go on after the cook; a weight or a class that was noted then is a mistake.
fn reached(cook: &Cook, sample: &Sample) -> Result<Reached, FitError> {
    let end_s = cook.kitchen.time_s();
    if end_s >= sample.at_s - 0.5 * saute_kitchen::TICK_S {
        return Ok(Reached::Now);
    }
    match cook.stopped() {
        None => Ok(Reached::NotYet),
        Some(_) if sample.at_s == END => Ok(Reached::Now),
        Some(_) if matches!(sample.quantity, Quantity::Pan | Quantity::Core) => Ok(Reached::Never),
        Some(_) => Err(FitError::Ended { at_s: sample.at_s, end_s }),
    }
}

/// A quantity now [K, kg]; of several foods, that of the first.
pub(super) fn value(kitchen: &Kitchen, quantity: Quantity) -> f64 {
    let of_food = |measure: fn(&saute_kitchen::Piece) -> f64| kitchen.pieces().first().map_or(0.0, measure);
    match quantity {
        Quantity::Pan => kitchen.pan_temperature(),
        Quantity::Core => of_food(saute_kitchen::Piece::core),
        Quantity::CorePeak => of_food(|piece| piece.core_peak.0),
        Quantity::Mass => of_food(saute_kitchen::Piece::mass),
    }
}
