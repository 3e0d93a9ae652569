//! A recipe being cooked: kitchen, runner and recorder together.

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

/// One cook from first to last step.
#[derive(Clone, Debug)]
pub struct Cook {
    /// The world.
    pub kitchen: Kitchen,
    /// The recipe's steps.
    pub runner: Runner,
    /// Series and extremes.
    pub recorder: Recorder,
    /// Steps so far.
    pub steps: Vec<StepRecord>,
    masses_at_start: Vec<f64>,
    scales: Vec<Arc<Scale>>,
}

impl Cook {
    /// Sets everything out; nothing has happened yet.
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

    /// Fires the steps that are due, then moves the world by one tick unless that ended the cook.
    pub fn advance(&mut self) -> Result<Vec<Fired>, InputError> {
        let fired = self.fire()?;
        self.tick();
        Ok(fired)
    }

    /// Fires the steps that are due now.
    pub fn fire(&mut self) -> Result<Vec<Fired>, InputError> {
        let fired = self.runner.poll(&mut self.kitchen)?;
        self.recorder.on_steps(&self.kitchen, &fired);
        self.steps.extend(fired.iter().cloned());
        Ok(fired)
    }

    /// Moves the world by one tick, unless the cook has stopped.
    pub fn tick(&mut self) {
        if self.stopped().is_none() {
            self.kitchen.step();
            self.recorder.observe(&self.kitchen);
        }
    }

    /// Why it stopped, once it has.
    pub fn stopped(&self) -> Option<StoppedBy> {
        self.runner.stopped()
    }

    /// The numbers of the cook so far.
    pub fn summary(&self, wall_s: f64) -> Summary {
        let (steps, masses) = (&self.steps, &self.masses_at_start);
        Summary::new(&self.kitchen, &self.recorder, &self.runner, steps, masses, &self.scales, wall_s)
    }
}
