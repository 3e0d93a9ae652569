//! The search for the parameters of a kitchen at home: rounds of jobs, and what they taught.

use std::borrow::Cow;
use std::sync::Arc;

use nalgebra::{DMatrix, DVector, SMatrix};
use saute_kitchen::Library;
use saute_recipe::{Recipe, Step, Trigger};

use super::found::{Estimate, Found};
use super::levels::Level;
use super::observed::{Observed, Sample};
use super::parameters::{COUNT, Logs, Parameters};
use super::predict::{FitError, Job};

/// Step of the transformed parameters for the differences [-] (chosen: changes of 2 % stand well above the rounding of a tick and below
/// the curvature).
const STEP: f64 = 0.02;
/// A round whose step is smaller than this share of the standard deviations ends a level [-] (chosen).
const SETTLED: f64 = 0.1;
/// Most rounds of a level [-] (chosen: five are usual).
const MOST_ROUNDS: usize = 12;
/// Longest step of a transformed parameter in one round [-] (chosen: a standard deviation of the prior).
const LONGEST: f64 = 0.5;

/// A fit that is under way.
///
/// Each round tries the present parameters and a neighbour in each of them; the shell runs the jobs of
/// [`Fit::next_jobs`] and returns their values in the same order to [`Fit::take`].
#[derive(Clone, Debug)]
pub struct Fit {
    recipe: Arc<Recipe>,
    library: Arc<Library>,
    samples: Arc<Vec<Sample>>,
    start: Logs,
    here: Logs,
    level: Level,
    levels: Vec<Level>,
    rounds: usize,
    damping: f64,
    best: Option<Point>,
    found: Option<Found>,
}

/// Parameters with what they predict.
#[derive(Clone, Debug)]
struct Point {
    logs: Logs,
    square: f64,
    normal: SMatrix<f64, COUNT, COUNT>,
    gradient: Logs,
}

impl Fit {
    /// Returns the fit of a recipe's cook to what was measured, on a coarse mesh first, then on the recipe's own.
    ///
    /// # Errors
    ///
    /// If nothing was measured, the recipe has no food, or a step waits for a condition.
    pub fn new(recipe: Recipe, library: Arc<Library>, observed: &Observed) -> Result<Self, FitError> {
        Self::on(recipe, library, observed, vec![Level::Coarse, Level::Full])
    }

    /// Returns the fit on the coarse mesh only: faster, and biased by what the mesh errs.
    ///
    /// # Errors
    ///
    /// As [`Fit::new`].
    pub fn coarse(recipe: Recipe, library: Arc<Library>, observed: &Observed) -> Result<Self, FitError> {
        Self::on(recipe, library, observed, vec![Level::Coarse])
    }

    /// Id of the hob that the recipe names.
    pub fn hob(&self) -> Option<&str> {
        self.recipe.hob_kind.as_deref()
    }

    fn on(recipe: Recipe, library: Arc<Library>, observed: &Observed, levels: Vec<Level>) -> Result<Self, FitError> {
        // The factors are those of the recipe's hob.
        let there = recipe.library(&library).map_err(|error| FitError::Cook(error.to_string()))?;
        let there = if let Cow::Owned(there) = there { Some(there) } else { None };
        let library = there.map_or(library, Arc::new);
        let samples = observed.samples();
        if samples.is_empty() {
            return Err(FitError::Nothing);
        }
        if recipe.foods.is_empty() {
            return Err(FitError::NoFood);
        }
        let waits = |step: &Step| matches!(step.trigger, Trigger::When(_));
        if let Some(at) = recipe.steps.iter().position(waits) {
            return Err(FitError::Condition { step: at + 1, line: recipe.steps[at].line });
        }
        let start = Parameters::of(&recipe, &library).logs();
        let (samples, level) = (Arc::new(samples), levels[0]);
        let (recipe, best, found) = (Arc::new(recipe), None, None);
        Ok(Self { recipe, library, samples, start, here: start, level, levels, rounds: 0, damping: 1e-3, best, found })
    }

    /// Returns the jobs of the next round; none when the fit has ended.
    pub fn next_jobs(&self) -> Vec<Job> {
        if self.found.is_some() {
            return Vec::new();
        }
        let points = std::iter::once(self.here).chain((0..COUNT).map(|k| {
            let mut beside = self.here;
            beside[k] += STEP;
            beside
        }));
        let job = |(number, logs)| Job {
            number,
            recipe: Arc::clone(&self.recipe),
            library: Arc::clone(&self.library),
            samples: Arc::clone(&self.samples),
            parameters: Parameters::from_logs(&logs),
            level: self.level,
        };
        points.enumerate().map(job).collect()
    }

    /// Returns the job of what was found, on the mesh of the last level.
    pub(super) fn job_of(&self, found: &Found) -> Job {
        Job {
            number: 0,
            recipe: Arc::clone(&self.recipe),
            library: Arc::clone(&self.library),
            samples: Arc::clone(&self.samples),
            parameters: found.parameters(),
            level: self.level,
        }
    }

    /// Returns the number of rounds so far, and the most that can follow [-].
    pub fn progress(&self) -> (usize, usize) {
        (self.rounds, MOST_ROUNDS * self.levels.len())
    }

    /// Takes the values of a round, in the order of its jobs.
    pub fn take(&mut self, values: &[Vec<f64>]) {
        self.rounds += 1;
        let point = self.point(values);
        let is_better = self.best.as_ref().is_none_or(|best| point.square < best.square);
        if is_better {
            self.damping = (0.3 * self.damping).max(1e-6);
            self.best = Some(point);
        } else {
            self.damping = (10.0 * self.damping).min(1e6);
        }
        let Some(best) = self.best.clone() else { return };
        let step = self.step(&best);
        let deviations = covariance(&best.normal).diagonal().map(f64::sqrt);
        let is_small = (0..COUNT).all(|k| step[k].abs() < SETTLED * deviations[k]);
        if is_small || self.rounds.is_multiple_of(MOST_ROUNDS) {
            self.end_level(best, best_step(is_small, step));
        } else {
            self.here = best.logs + step;
        }
    }

    /// Returns what was found once the fit has ended.
    pub fn found(&self) -> Option<&Found> {
        self.found.as_ref()
    }

    /// The sum of squares with its derivatives at the parameters that were tried.
    fn point(&self, values: &[Vec<f64>]) -> Point {
        let weighted = |row: &[f64]| {
            let of = |(value, sample): (&f64, &Sample)| (value - sample.value) / sample.sigma;
            DVector::from_iterator(row.len(), row.iter().zip(self.samples.iter()).map(of))
        };
        let residual = weighted(&values[0]);
        let columns: Vec<DVector<f64>> = values[1..].iter().map(|row| (weighted(row) - &residual) / STEP).collect();
        let jacobian = DMatrix::from_columns(&columns);
        let (away, prior) = (self.here - self.start, Parameters::prior());
        let weights = prior.map(|deviation| 1.0 / (deviation * deviation));
        let normal = jacobian.transpose() * &jacobian;
        let gradient = jacobian.transpose() * &residual;
        Point {
            logs: self.here,
            square: residual.norm_squared() + away.component_mul(&away).dot(&weights),
            normal: SMatrix::from_fn(|r, c| normal[(r, c)] + if r == c { weights[r] } else { 0.0 }),
            gradient: Logs::from_fn(|k, _| gradient[k] + weights[k] * away[k]),
        }
    }

    /// The damped Gauss–Newton step from a point, shortened where it is long.
    fn step(&self, from: &Point) -> Logs {
        let mut damped = from.normal;
        for k in 0..COUNT {
            damped[(k, k)] *= 1.0 + self.damping;
        }
        let step = -(covariance(&damped) * from.gradient);
        step * (LONGEST / step.amax()).min(1.0)
    }

    /// Goes on with the next level, or ends with what was found.
    fn end_level(&mut self, best: Point, step: Logs) {
        self.here = best.logs + step;
        let next = self.levels.iter().position(|level| *level == self.level).map_or(0, |at| at + 1);
        if let Some(level) = self.levels.get(next) {
            (self.level, self.best, self.damping) = (*level, None, 1e-3);
            return;
        }
        let freedom = self.samples.len();
        let spread = (best.square / freedom as f64).max(1.0);
        let covariance = covariance(&best.normal) * spread;
        let at = |k: usize, z: f64| {
            let mut logs = self.here;
            logs[k] += z * covariance[(k, k)].sqrt();
            Parameters::from_logs(&logs)
        };
        self.found = Some(Found {
            hob_efficiency: Estimate::of(|z| at(0, z).hob_efficiency),
            contact: Estimate::of(|z| at(1, z).contact),
            thickness_mm: Estimate::of(|z| 1e3 * at(2, z).thickness),
            misfit: (best.square / freedom as f64).sqrt(),
            samples: freedom,
            rounds: self.rounds,
        });
    }
}

/// The last small step is taken without being tried; a long one is not.
fn best_step(is_small: bool, step: Logs) -> Logs {
    if is_small { step } else { Logs::zeros() }
}

/// Inverse of a normal matrix; the prior keeps it positive definite.
fn covariance(normal: &SMatrix<f64, COUNT, COUNT>) -> SMatrix<f64, COUNT, COUNT> {
    normal.try_inverse().unwrap_or_else(SMatrix::zeros)
}
