//! The search for the parameters of a kitchen at home: rounds of jobs, and what they taught.

use std::borrow::Cow;
use std::sync::Arc;

use nalgebra::{DMatrix, DVector, SMatrix};
use saute_kitchen::Library;
use saute_recipe::{Recipe, Step, Trigger};

use super::found::{Estimate, FitResult, Worst};
use super::levels::Level;
use super::observed::{Observed, Sample};
use super::parameters::{COUNT, Logs, Parameters};
use super::predict::{FitError, Job};

/// Step of the transformed parameters for the differences [-] (chosen: changes of 2 % are well above the rounding of a tick and below
/// the curvature).
const STEP: f64 = 0.02;
/// A round whose step is smaller than this share of the standard deviations ends a level [-] (chosen).
const SETTLED: f64 = 0.1;
/// Most rounds of a level [-] (chosen: five are usual).
const MOST_ROUNDS: usize = 12;
/// Longest step of a transformed parameter in one round [-] (chosen: a standard deviation of the prior).
const LONGEST: f64 = 0.5;
/// Standard deviations from which a residual counts less and less [-] (chosen: one in a million errs so far by chance; a probe that was
/// not there errs by thirty).
const OUTLYING: f64 = 5.0;

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
    bounds: [Logs; 2],
    level: Level,
    levels: Vec<Level>,
    rounds: usize,
    damping: f64,
    best: Option<Point>,
    found: Option<FitResult>,
}

/// Parameters with what they predict.
#[derive(Clone, Debug)]
struct Point {
    logs: Logs,
    loss: f64,
    misfit: f64,
    samples: usize,
    worst: Worst,
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
        let bounds = Parameters::bounds(&recipe, &library);
        let (samples, level) = (Arc::new(samples), levels[0]);
        let (recipe, best, found) = (Arc::new(recipe), None, None);
        Ok(Self {
            recipe,
            library,
            samples,
            start,
            here: start,
            bounds,
            level,
            levels,
            rounds: 0,
            damping: 1e-3,
            best,
            found,
        })
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
    pub(super) fn job_of(&self, found: &FitResult) -> Job {
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
        let is_better = self.best.as_ref().is_none_or(|best| point.loss < best.loss);
        if is_better {
            self.damping = (0.3 * self.damping).max(1e-6);
            self.best = Some(point);
        } else {
            self.damping = (10.0 * self.damping).min(1e6);
        }
        let Some(best) = self.best.clone() else { return };
        let step = self.within(best.logs + self.step(&best)) - best.logs;
        let deviations = covariance(&best.normal).diagonal().map(f64::sqrt);
        let is_small = (0..COUNT).all(|k| step[k].abs() < SETTLED * deviations[k]);
        if is_small || self.rounds.is_multiple_of(MOST_ROUNDS) {
            self.end_level(best, best_step(is_small, step));
        } else {
            self.here = best.logs + step;
        }
    }

    /// Returns what was found once the fit has ended.
    pub fn found(&self) -> Option<&FitResult> {
        self.found.as_ref()
    }

    /// The loss with its derivatives at the parameters that were tried: Σ c² ln(1 + (r/c)²) of the residuals r, of which each then counts
    /// with the weight 1/(1 + (r/c)²), c = [`OUTLYING`].
    fn point(&self, values: &[Vec<f64>]) -> Point {
        let residual = self.residual(&values[0]);
        let columns: Vec<DVector<f64>> =
            values[1..].iter().map(|row| (self.residual(row) - &residual) / STEP).collect();
        let counts = residual.map(|r| 1.0 / (1.0 + (r / OUTLYING) * (r / OUTLYING)));
        let jacobian = DMatrix::from_columns(&columns);
        let counted =
            DMatrix::from_columns(&columns.iter().map(|column| column.component_mul(&counts)).collect::<Vec<_>>());
        let (away, prior) = (self.here - self.start, Parameters::prior());
        let weights = prior.map(|deviation| 1.0 / (deviation * deviation));
        let normal = counted.transpose() * &jacobian;
        let gradient = counted.transpose() * &residual;
        let samples = values[0].iter().filter(|value| value.is_finite()).count().max(1);
        let loss: f64 = counts.iter().map(|count| -OUTLYING * OUTLYING * count.ln()).sum();
        Point {
            logs: self.here,
            loss: loss + away.component_mul(&away).dot(&weights),
            misfit: (residual.component_mul(&residual).dot(&counts) / samples as f64).sqrt(),
            samples,
            worst: self.worst(&values[0], &residual),
            normal: SMatrix::from_fn(|r, c| normal[(r, c)] + if r == c { weights[r] } else { 0.0 }),
            gradient: Logs::from_fn(|k, _| gradient[k] + weights[k] * away[k]),
        }
    }

    /// Residuals over their standard deviations; a row after the end of the cook has none.
    fn residual(&self, row: &[f64]) -> DVector<f64> {
        let of = |(value, sample): (&f64, &Sample)| (value - sample.value) / sample.sigma;
        let or_none = |residual: f64| if residual.is_finite() { residual } else { 0.0 };
        DVector::from_iterator(row.len(), row.iter().zip(self.samples.iter()).map(of).map(or_none))
    }

    /// The sample that is missed most.
    fn worst(&self, values: &[f64], residual: &DVector<f64>) -> Worst {
        let at = residual.iamax();
        let Sample { quantity, at_s, value, .. } = self.samples[at];
        Worst { quantity, at_s, read: value, expected: values[at], off: residual[at].abs() }
    }

    /// The nearest parameters whose kitchen a file can state.
    fn within(&self, logs: Logs) -> Logs {
        logs.sup(&self.bounds[0]).inf(&self.bounds[1])
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
        self.here = self.within(best.logs + step);
        let next = self.levels.iter().position(|level| *level == self.level).map_or(0, |at| at + 1);
        if let Some(level) = self.levels.get(next) {
            (self.level, self.best, self.damping) = (*level, None, 1e-3);
            return;
        }
        let covariance = covariance(&best.normal) * (best.misfit * best.misfit).max(1.0);
        let at = |k: usize, z: f64| {
            let mut logs = self.here;
            logs[k] += z * covariance[(k, k)].sqrt();
            Parameters::from_logs(&logs)
        };
        self.found = Some(FitResult {
            hob_efficiency: Estimate::of(|z| at(0, z).hob_efficiency),
            contact: Estimate::of(|z| at(1, z).contact),
            thickness_mm: Estimate::of(|z| 1e3 * at(2, z).thickness),
            misfit: best.misfit,
            samples: best.samples,
            worst: best.worst,
            is_at_bound: (0..COUNT).any(|k| self.bounds.iter().any(|bound| self.here[k] == bound[k])),
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

#[cfg(test)]
mod tests {
    use super::super::observed::Quantity;
    use super::*;

    const RECIPE: &str = "[[food]]\nid = \"steak\"\nkind = \"beef-lean\"\nsize_mm = [40, 30, 20]\ninitial_c = 5\n[[step]]\nat_s = 5\n\
                          put = \"steak\"\n[[step]]\nat_s = 60\nend = true\n";

    /// Fits to thirty values that are linear in the parameters; a kitchen with `truth` gives them, but for those at `wrong`.
    fn found(truth: &Logs, wrong: &[usize]) -> (FitResult, Arc<Library>) {
        let library = Arc::new(Library::embedded().expect("embedded data"));
        let recipe = Recipe::parse(RECIPE, "steak.toml", &library).expect("a recipe");
        let of = |logs: &Logs, k: usize| {
            300.0 + 20.0 * logs[0] * (k % 3) as f64 + 15.0 * logs[1] * (k % 5) as f64 + 9.0 * logs[2]
        };
        let curve: Vec<(f64, f64)> =
            (0..30).map(|k| (k as f64, if wrong.contains(&k) { 273.15 } else { of(truth, k) })).collect();
        let mut observed = Observed::default();
        observed.add_curve(Quantity::Core, &curve);
        let mut fit = Fit::coarse(recipe, Arc::clone(&library), &observed).expect("a fit");
        while fit.found().is_none() {
            let values: Vec<Vec<f64>> =
                fit.next_jobs().iter().map(|job| (0..30).map(|k| of(&job.parameters.logs(), k)).collect()).collect();
            fit.take(&values);
        }
        (*fit.found().expect("has ended"), library)
    }

    fn truth() -> Logs {
        Parameters { hob_efficiency: 0.8, contact: 1.4, thickness: 0.02 }.logs()
    }

    #[test]
    fn a_probe_that_was_not_there_for_a_while_moves_nothing_and_is_named_as_the_worst() {
        let (whole, _) = found(&truth(), &[]);
        let (with, _) = found(&truth(), &[11, 12]);
        assert!((whole.contact.value - 1.4).abs() < 0.02, "{whole:?}");
        assert!((with.contact.value - whole.contact.value).abs() < 0.05 && with.describes(), "{with:?}");
        assert!(with.worst.at_s == 11.0 || with.worst.at_s == 12.0, "{:?}", with.worst);
        assert!(with.worst.read == 273.15 && with.worst.expected > 290.0, "{:?}", with.worst);
    }

    #[test]
    fn no_kitchen_is_found_that_a_file_cannot_state() {
        for logs in [Logs::new(-6.0, 4.0, -4.0), Logs::new(9.0, -4.0, -4.0)] {
            let (found, library) = found(&logs, &[]);
            let at_home = found.at_home(&library, "log.csv");
            let text = at_home.to_file();
            assert!(found.is_at_bound && library.in_kitchen(Some(&text)).is_ok(), "{text}");
        }
    }
}
