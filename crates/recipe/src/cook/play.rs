//! A cook: kitchen, runner and recorder together.

use std::sync::Arc;

use saute_food::Scale;

use crate::cook::recorder::Recorder;
use crate::cook::runner::{Runner, StoppedBy};
use crate::cook::step_record::StepRecord;
use crate::recipe::Recipe;
use crate::summary::cook_summary::Summary;
use saute_kitchen::InputError;
use saute_kitchen::data::library::Library;
use saute_kitchen::kitchen::{Kitchen, SetupError};

/// A step that has just been carried out.
pub type Fired = StepRecord;

/// The execution of one recipe in a kitchen.
#[derive(Clone, Debug)]
pub struct Cook {
    /// The kitchen.
    pub kitchen: Kitchen,
    /// The runner of the recipe's steps.
    pub runner: Runner,
    /// Time series and extremes.
    pub recorder: Recorder,
    /// Steps that were carried out.
    pub steps: Vec<StepRecord>,
    masses_at_start: Vec<f64>,
    scales: Vec<Arc<Scale>>,
}

impl Cook {
    /// Builds the kitchen of a recipe at time 0.
    ///
    /// # Errors
    ///
    /// Returns an error if the pan or a food cannot be built.
    pub fn new(recipe: Recipe, library: &Library) -> Result<Self, SetupError> {
        let kitchen = recipe.kitchen(library)?;
        let mut recorder = Recorder::default();
        recorder.observe(&kitchen);
        Ok(Self {
            masses_at_start: kitchen.pieces().iter().map(saute_kitchen::Piece::mass).collect(),
            runner: Runner::new(Arc::new(recipe)),
            steps: Vec::new(),
            scales: library.scales.clone(),
            kitchen,
            recorder,
        })
    }

    /// Fires the steps that are due, then advances the kitchen by one tick unless the cook has stopped. Returns the
    /// fired steps.
    ///
    /// # Errors
    ///
    /// Returns an error with the line of a step that cannot be carried out.
    pub fn advance(&mut self) -> Result<Vec<Fired>, InputError> {
        let fired = self.fire()?;
        self.tick();
        Ok(fired)
    }

    /// Fires the steps that are due now and returns them.
    ///
    /// # Errors
    ///
    /// As [`Cook::advance`].
    pub fn fire(&mut self) -> Result<Vec<Fired>, InputError> {
        let fired = self.runner.poll(&mut self.kitchen)?;
        self.recorder.on_steps(&self.kitchen, &fired);
        self.steps.extend(fired.iter().cloned());
        Ok(fired)
    }

    /// Advances the kitchen by one tick, unless the cook has stopped.
    pub fn tick(&mut self) {
        if self.stopped().is_none() {
            self.kitchen.step();
            self.recorder.observe(&self.kitchen);
        }
    }

    /// Returns the reason for which the cook stopped; none while it goes on.
    pub fn stopped(&self) -> Option<StoppedBy> {
        self.runner.stopped()
    }

    /// Returns the numbers of the cook up to now. `wall_s` is the wall time of the simulation [s].
    pub fn summary(&self, wall_s: f64) -> Summary {
        let (steps, masses) = (&self.steps, &self.masses_at_start);
        Summary::new(&self.kitchen, &self.recorder, &self.runner, steps, masses, &self.scales, wall_s)
    }
}
