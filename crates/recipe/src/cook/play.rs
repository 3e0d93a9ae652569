//! A cook: kitchen, runner and recorder together.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::Arc;

use saute_food::Scale;

use crate::cook::recorder::Recorder;
use crate::cook::runner::{Runner, StoppedBy};
use crate::cook::step_record::StepRecord;
use crate::recipe::Recipe;
use crate::session::playhead::{Played, Playhead, Stage};
use crate::session::{Deed, Departure, Entry, Moment, Recording, ReplayError};
use crate::summary::cook_summary::Summary;
use saute_kitchen::data::library::Library;
use saute_kitchen::kitchen::{Kitchen, SetupError};
use saute_schema::InputError;

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
    /// Keys of the pieces of these masses.
    weighed: Vec<u32>,
    scales: Vec<Arc<Scale>>,
    session: Option<Session>,
}

/// The session that a cook plays again.
#[derive(Clone, Debug)]
struct Session {
    recording: Arc<Recording>,
    library: Arc<Library>,
    head: Playhead,
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
            weighed: kitchen.pieces().iter().map(|piece| piece.key).collect(),
            runner: Runner::new(Arc::new(recipe)),
            steps: Vec::new(),
            scales: library.scales.clone(),
            kitchen,
            recorder,
            session: None,
        })
    }

    /// Builds the kitchen of a session at time 0; it cooks as it was cooked then, up to the end of the recording.
    ///
    /// # Errors
    ///
    /// If the library has not what the session needs.
    pub fn again(recording: Recording, library: Arc<Library>) -> Result<Self, ReplayError> {
        let beginning = recording.beginning();
        let there = match beginning.library(&library)? {
            Cow::Borrowed(_) => None,
            Cow::Owned(there) => Some(Arc::new(there)),
        };
        let library = there.unwrap_or(library);
        let mut cook = Self::new(beginning.recipe(&library)?, &library)?;
        let head = Playhead::at(Moment::default(), beginning.plays, &cook.kitchen);
        cook.session = Some(Session { recording: Arc::new(recording), library, head });
        Ok(cook)
    }

    /// The session that it plays again; none if it cooks a recipe.
    pub fn recording(&self) -> Option<&Recording> {
        self.session.as_ref().map(|session| session.recording.as_ref())
    }

    /// The first departure from the session; none as long as it is bit by bit the same.
    pub fn departure(&self) -> Option<&Departure> {
        self.session.as_ref()?.head.departure.as_ref()
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

    /// Fires the steps that are due now and returns them; of a session also what hands did.
    ///
    /// # Errors
    ///
    /// As [`Cook::advance`].
    pub fn fire(&mut self) -> Result<Vec<Fired>, InputError> {
        if self.session.is_some() {
            return Ok(self.settle());
        }
        let fired = self.runner.poll(&mut self.kitchen)?;
        self.recorder.on_steps(&self.kitchen, &fired);
        self.steps.extend(fired.iter().cloned());
        Ok(fired)
    }

    /// Advances the kitchen by one tick, unless the cook has stopped.
    pub fn tick(&mut self) {
        if self.session.is_some() {
            while self.stopped().is_none() && !self.frame_of_session() {}
        } else if self.stopped().is_none() {
            self.kitchen.step();
            self.recorder.observe(&self.kitchen);
        }
    }

    /// Returns the reason for which the cook stopped; none while it goes on.
    pub fn stopped(&self) -> Option<StoppedBy> {
        let Some(Session { recording, head, .. }) = &self.session else { return self.runner.stopped() };
        let (here, end) = (head.moment, recording.moment());
        let is_at_end = here.frame >= end.frame && here.entries >= end.entries && (here.steps_done || !end.steps_done);
        is_at_end.then(|| self.runner.stopped().unwrap_or(StoppedBy::Hand))
    }

    /// Carries out what was done at this frame of the session; returns it as steps.
    fn settle(&mut self) -> Vec<Fired> {
        let Self { kitchen, runner, session: Some(Session { recording, library, head }), .. } = self else {
            return Vec::new();
        };
        let end = recording.moment();
        let all = Moment { frame: head.moment.frame, entries: usize::MAX, steps_done: true };
        let until = if head.moment.frame >= end.frame { end } else { all };
        let played = head.settle(&mut Stage { kitchen, runner, recording, library }, until);
        self.note(played)
    }

    /// Plays a frame of the session; returns true if it ended a tick.
    fn frame_of_session(&mut self) -> bool {
        let Self { kitchen, runner, session: Some(Session { recording, library, head }), .. } = self else {
            return true;
        };
        let played = head.advance_frame(&mut Stage { kitchen, runner, recording, library });
        let ticked = played.ticked;
        self.note(played);
        if ticked {
            self.recorder.observe(&self.kitchen);
        }
        ticked
    }

    /// Notes what was played; returns it as steps, without the motions of hands that no recipe can state.
    fn note(&mut self, played: Played) -> Vec<Fired> {
        let Some(session) = &self.session else { return Vec::new() };
        let recording = Arc::clone(&session.recording);
        let (before, after): (Vec<_>, Vec<_>) =
            recording.entries()[played.entries].iter().partition(|entry| !entry.after_steps);
        let is_stock = |entry: &&Entry| matches!(entry.deed, Deed::Add(_) | Deed::Remove(_));
        if before.iter().chain(&after).any(is_stock) {
            self.weigh();
        }
        let as_steps = |entries: Vec<&Entry>| entries.into_iter().filter_map(Entry::as_step).collect::<Vec<_>>();
        let steps = [as_steps(before), played.fired, as_steps(after)].concat();
        self.recorder.on_steps(&self.kitchen, &steps);
        self.steps.extend(steps.iter().cloned());
        steps
    }

    /// Weighs pieces that were added; those that were removed count no longer.
    fn weigh(&mut self) {
        let pieces = self.kitchen.pieces();
        let known = std::mem::take(&mut self.masses_at_start);
        let kept = self.weighed.iter().zip(known);
        let kept: BTreeMap<u32, f64> = kept.map(|(key, mass)| (*key, mass)).collect();
        self.masses_at_start = pieces.iter().map(|p| kept.get(&p.key).copied().unwrap_or_else(|| p.mass())).collect();
        self.weighed = pieces.iter().map(|p| p.key).collect();
    }

    /// Returns the numbers of the cook up to now. `wall_s` is the wall time of the simulation [s].
    pub fn summary(&self, wall_s: f64) -> Summary {
        let (steps, masses) = (&self.steps, &self.masses_at_start);
        let summary = Summary::new(&self.kitchen, &self.recorder, &self.runner, steps, masses, &self.scales, wall_s);
        if self.stopped() == Some(StoppedBy::Hand) {
            return Summary { stopped_by: StoppedBy::Hand, waiting_step: None, ..summary };
        }
        summary
    }
}
