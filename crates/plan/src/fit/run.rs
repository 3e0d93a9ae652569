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
use crate::round::{End, Round, Shared};

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
    round: Round<Job, Predicting, Vec<f64>>,
    drawing: Option<Box<Drawing>>,
    fitted: Option<Fitted>,
}

/// Rounds that a fit has about [-] (measured: four or five on the coarse mesh, two on the full one).
const USUAL_ROUNDS: f64 = 8.0;
/// Share of the work before which no estimate ends [-] (chosen).
const MOST_SHARE: f64 = 0.97;

impl FitRun {
    /// Begins a fit; one of two who share it begins its rounds at the back.
    ///
    /// # Errors
    ///
    /// As [`Fit::new`].
    pub fn new(recipe: Recipe, library: Arc<Library>, observed: &Observed, end: End) -> Result<Self, FitError> {
        let fit = Fit::new(recipe, library, observed)?;
        Ok(Self { fit, round: Round::new(end), drawing: None, fitted: None })
    }

    /// Goes on with the next jobs of the present round that are not done, at most so many at once. `cook` lets some seconds of theirs
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
        self.fill_round();
        self.round.go_on(at_once, Predicting::begin, cook)?;
        self.end_round();
        Ok(())
    }

    /// Takes the own values since the last call, for a twin that fits the same.
    pub fn shares(&mut self) -> Vec<Shared<Vec<f64>>> {
        self.round.shares()
    }

    /// Takes the values of a job of a twin.
    pub fn take(&mut self, shared: Shared<Vec<f64>>) {
        if self.fit.found().is_none() {
            self.fill_round();
            self.round.take(shared);
            self.end_round();
        }
    }

    fn fill_round(&mut self) {
        if self.round.is_empty() {
            self.round.begin(self.fit.next_jobs());
        }
    }

    fn end_round(&mut self) {
        if let Some(values) = self.round.end() {
            self.fit.take(&values);
        }
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
        let (done, all) = self.round.done();
        let of_round = done as f64 / all.max(1) as f64;
        ((self.fit.progress().0 as f64 + of_round) / USUAL_ROUNDS).min(MOST_SHARE)
    }

    /// Returns what was found, once the fit is over.
    pub fn fitted(&self) -> Option<&Fitted> {
        self.fitted.as_ref()
    }
}

/// Seconds of the last cook that pass at once [-] (chosen: a slice of some thousandths of a second).
const SECONDS_AT_ONCE: usize = 2;
