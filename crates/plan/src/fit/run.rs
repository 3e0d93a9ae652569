//! A fit that is carried out in one place, second by second of its cooks, with curves in the end.

use std::sync::Arc;

use saute_kitchen::Library;
use saute_recipe::Recipe;
use serde::{Deserialize, Serialize};

use super::curves::{Curves, Drawing};
use super::found::FitResult;
use super::observed::Observed;
use super::predict::{FitError, Job, Predicting};
use super::search::Fit;

/// What a fit gives.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Fitted {
    /// The parameters.
    pub found: FitResult,
    /// Id of the hob on which was cooked; none for that of the kitchen at home.
    pub hob: Option<String>,
    /// What the fitted kitchen would have shown.
    pub curves: Curves,
}

/// A fit that is under way.
#[derive(Clone, Debug)]
pub struct FitRun {
    fit: Fit,
    round: Vec<Slot>,
    drawing: Option<Box<Drawing>>,
    fitted: Option<Fitted>,
}

/// A job of the present round.
#[derive(Clone, Debug)]
enum Slot {
    Open(Box<Job>),
    Begun(Box<Predicting>),
    Done(Vec<f64>),
}

/// Rounds that a fit has about [-] (measured: four or five on the coarse mesh, two on the full one).
const USUAL_ROUNDS: f64 = 8.0;
/// Share of the work before which no estimate ends [-] (chosen).
const MOST_SHARE: f64 = 0.97;

impl FitRun {
    /// Begins a fit.
    ///
    /// # Errors
    ///
    /// As [`Fit::new`].
    pub fn new(recipe: Recipe, library: Arc<Library>, observed: &Observed) -> Result<Self, FitError> {
        let fit = Fit::new(recipe, library, observed)?;
        Ok(Self { fit, round: Vec::new(), drawing: None, fitted: None })
    }

    /// Goes on with the first jobs of the present round that are not done, at most so many at once. `cook` lets some seconds of theirs
    /// pass ([`Predicting::second`]) and returns the values of those that are over, in their order.
    ///
    /// # Errors
    ///
    /// If a cook cannot be compared with what was measured.
    pub fn go_on(
        &mut self,
        at_once: usize,
        cook: impl FnOnce(&mut [&mut Predicting]) -> Result<Vec<Option<Vec<f64>>>, FitError>,
    ) -> Result<(), FitError> {
        if let Some(found) = self.fit.found().copied() {
            return self.draw(found);
        }
        if self.round.is_empty() {
            self.round = self.fit.next_jobs().into_iter().map(|job| Slot::Open(Box::new(job))).collect();
        }
        let is_open = |slot: &&mut Slot| !matches!(slot, Slot::Done(_));
        let mut begun: Vec<&mut Slot> = self.round.iter_mut().filter(is_open).take(at_once).collect();
        for slot in &mut begun {
            if let Slot::Open(job) = &**slot {
                **slot = Slot::Begun(Box::new(Predicting::begin(job)?));
            }
        }
        let mut cooks: Vec<&mut Predicting> = begun
            .iter_mut()
            .filter_map(|slot| if let Slot::Begun(predicting) = &mut **slot { Some(&mut **predicting) } else { None })
            .collect();
        let values = cook(&mut cooks)?;
        for (slot, values) in begun.into_iter().zip(values) {
            if let Some(values) = values {
                *slot = Slot::Done(values);
            }
        }
        self.end_round();
        Ok(())
    }

    fn end_round(&mut self) {
        if !self.round.iter().all(|slot| matches!(slot, Slot::Done(_))) {
            return;
        }
        let values = |slot| if let Slot::Done(values) = slot { Some(values) } else { None };
        let values: Vec<Vec<f64>> = std::mem::take(&mut self.round).into_iter().filter_map(values).collect();
        self.fit.take(&values);
    }

    /// Cooks once more with what was found, for the curves.
    fn draw(&mut self, found: FitResult) -> Result<(), FitError> {
        if self.fitted.is_some() {
            return Ok(());
        }
        let mut drawing = match self.drawing.take() {
            Some(drawing) => drawing,
            None => Box::new(Drawing::begin(&self.fit.job_of(&found))?),
        };
        for _ in 0..SECONDS_AT_ONCE {
            if let Some(curves) = drawing.second()? {
                self.fitted = Some(Fitted { found, hob: self.fit.hob().map(str::to_owned), curves });
                return Ok(());
            }
        }
        self.drawing = Some(drawing);
        Ok(())
    }

    /// Returns the share of the work that is done; an estimate [-].
    pub fn share(&self) -> f64 {
        let done = self.round.iter().filter(|slot| matches!(slot, Slot::Done(_))).count();
        let of_round = done as f64 / self.round.len().max(1) as f64;
        ((self.fit.progress().0 as f64 + of_round) / USUAL_ROUNDS).min(MOST_SHARE)
    }

    /// Returns what was found, once the fit is over.
    pub fn fitted(&self) -> Option<&Fitted> {
        self.fitted.as_ref()
    }
}

/// Seconds of the last cook that pass at once [-] (chosen: a slice of some thousandths of a second).
const SECONDS_AT_ONCE: usize = 2;
