//! The numbers of a session that is played again.

use std::sync::Arc;

use saute_food::Scale;
use saute_kitchen::{Command, Library, Piece};

use crate::action::Action;
use crate::cook::recorder::Recorder;
use crate::cook::runner::StoppedBy;
use crate::cook::step_record::StepRecord;
use crate::session::entry::Deed;
use crate::session::recording::Recording;
use crate::session::replay::{Played, Replay, ReplayError};
use crate::summary::cook_summary::Summary;

/// A replay with its time series and the steps that were carried out.
#[derive(Clone, Debug)]
pub struct ReplayedCook {
    /// The replay.
    pub replay: Replay,
    /// Time series and extremes.
    pub recorder: Recorder,
    /// Steps of the recipe and commands of hands, as steps; motions of hands that no recipe can state are left out.
    pub steps: Vec<StepRecord>,
    masses_at_start: Vec<f64>,
    scales: Vec<Arc<Scale>>,
}

impl ReplayedCook {
    /// Begins to play a recording.
    ///
    /// # Errors
    ///
    /// If the library has not what the session needs.
    pub fn begin(recording: &Recording, library: &Library) -> Result<Self, ReplayError> {
        let replay = Replay::begin(recording, library)?;
        let mut recorder = Recorder::default();
        recorder.observe(&replay.kitchen);
        let masses_at_start = replay.kitchen.pieces().iter().map(Piece::mass).collect();
        Ok(Self { replay, recorder, steps: Vec::new(), masses_at_start, scales: library.scales.clone() })
    }

    /// Returns true until the end of the recording is reached.
    pub fn goes_on(&self, recording: &Recording) -> bool {
        self.replay.moment().frame < recording.moment().frame
    }

    /// Advances by one frame.
    pub fn advance_frame(&mut self, recording: &Recording, library: &Library) {
        let played = self.replay.advance_frame(recording, library);
        let ticked = played.ticked;
        self.note(recording, played);
        if ticked {
            self.recorder.observe(&self.replay.kitchen);
        }
    }

    /// Carries out what was carried out at the last instant.
    pub fn finish(&mut self, recording: &Recording, library: &Library) {
        let played = self.replay.settle(recording, library, recording.moment());
        self.note(recording, played);
    }

    fn note(&mut self, recording: &Recording, played: Played) {
        let entries = &recording.entries()[played.entries];
        let (before, after): (Vec<_>, Vec<_>) = entries.iter().partition(|entry| !entry.after_steps);
        for entry in before {
            self.note_deed(&entry.deed, entry.time_s());
        }
        self.recorder.on_steps(&self.replay.kitchen, &played.fired);
        self.steps.extend(played.fired);
        for entry in after {
            self.note_deed(&entry.deed, entry.time_s());
        }
    }

    fn note_deed(&mut self, deed: &Deed, time_s: f64) {
        match deed {
            Deed::Command(command) => self.steps.extend(step_of(command, time_s)),
            Deed::Add(_) | Deed::Remove(_) => self.weigh(),
            Deed::TakeOver | Deed::Resume => {}
        }
    }

    /// Weighs pieces that were added; those that were removed count no longer.
    fn weigh(&mut self) {
        let pieces = self.replay.kitchen.pieces();
        self.masses_at_start.truncate(pieces.len());
        self.masses_at_start.extend(pieces[self.masses_at_start.len()..].iter().map(Piece::mass));
    }

    /// Returns the numbers of the session up to now. `wall_s` is the wall time of the simulation [s].
    pub fn summary(&self, wall_s: f64) -> Summary {
        let Replay { kitchen, runner, .. } = &self.replay;
        let summary =
            Summary::new(kitchen, &self.recorder, runner, &self.steps, &self.masses_at_start, &self.scales, wall_s);
        if runner.stopped().is_some() {
            return summary;
        }
        Summary { stopped_by: StoppedBy::Hand, waiting_step: None, ..summary }
    }
}

/// Returns a command as the step of a recipe; none for a motion that no recipe can state.
pub(super) fn step_of(command: &Command, time_s: f64) -> Option<StepRecord> {
    let action = Action::of_command(command)?;
    let foods = action.target().map(|target| target.foods.clone()).unwrap_or_default();
    Some(StepRecord::new(action, foods, time_s))
}
