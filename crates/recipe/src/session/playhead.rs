//! Where a replay is in its recording, and what it carries out next.

use saute_kitchen::bytes::Models;
use saute_kitchen::kitchen::SetupError;
use saute_kitchen::{FRAME_S, Kitchen, Library, Refused};
use saute_schema::InputError;

use crate::cook::runner::Runner;
use crate::cook::step_record::StepRecord;
use crate::session::entry::{Deed, Entry};
use crate::session::moment::Moment;
use crate::session::recording::Recording;

/// What was done in one frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Played {
    /// Steps of the recipe.
    pub fired: Vec<StepRecord>,
    /// Indices of the recording's entries.
    pub entries: core::ops::Range<usize>,
    /// True if the frame ended a tick.
    pub ticked: bool,
}

/// Where a replay departs from its recording.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("the replay departs at {time_s:.1} s: {cause}")]
pub struct Departure {
    /// Time at which it was found [s].
    pub time_s: f64,
    /// What differs.
    pub cause: DepartureCause,
}

/// What differs from a recording.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum DepartureCause {
    /// The hash of the state, taken every ten seconds.
    #[error("the state has the hash {found:016x}, recorded was {recorded:016x}")]
    Hash {
        /// Hash that was recorded.
        recorded: u64,
        /// Hash of the replay.
        found: u64,
    },
    /// A command that was carried out is refused.
    #[error("a command that was carried out is refused: {0}")]
    Refused(Refused),
    /// A food that was added cannot be built.
    #[error("a food that was added cannot be built: {0}")]
    Setup(SetupError),
}

/// The place of a replay in its recording.
#[derive(Clone, Debug)]
pub(crate) struct Playhead {
    pub(crate) moment: Moment,
    pub(crate) plays: bool,
    pub(crate) departure: Option<Departure>,
    pub(crate) fault: Option<InputError>,
    models: Models,
}

/// What a recording is played in.
pub(crate) struct Stage<'a> {
    pub(crate) kitchen: &'a mut Kitchen,
    pub(crate) runner: &'a mut Runner,
    pub(crate) recording: &'a Recording,
    pub(crate) library: &'a Library,
}

impl Playhead {
    /// A place from which nothing was carried out yet; `plays` is true while the recipe's steps are carried out.
    pub(crate) fn at(moment: Moment, plays: bool, kitchen: &Kitchen) -> Self {
        Self { moment, plays, departure: None, fault: None, models: Models::of(kitchen) }
    }

    /// Shares known models.
    pub(crate) fn share(&mut self, models: &Models, kitchen: &Kitchen) {
        self.models = models.clone();
        self.models.learn(kitchen);
    }

    /// Carries out what is due at this frame, then advances by one frame.
    pub(crate) fn advance_frame(&mut self, stage: &mut Stage) -> Played {
        let all = Moment { steps_done: true, entries: usize::MAX, ..self.moment };
        let mut played = self.settle(stage, all);
        played.ticked = stage.kitchen.advance_frame();
        self.moment = Moment { frame: stage.kitchen.frame(), steps_done: false, ..self.moment };
        played
    }

    /// Carries out entries and steps of this frame up to a moment in it; returns them.
    pub(crate) fn settle(&mut self, stage: &mut Stage, until: Moment) -> Played {
        let first = self.moment.entries;
        if !self.moment.steps_done {
            self.compare(stage);
        }
        self.carry_out(stage, until, false);
        let mut fired = Vec::new();
        if until.steps_done && !self.moment.steps_done {
            fired = self.poll(stage);
            self.moment.steps_done = true;
        }
        self.carry_out(stage, until, true);
        // What a listening kitchen heard is in the recording already.
        drop(stage.kitchen.take_carried_out());
        Played { fired, entries: first..self.moment.entries, ticked: false }
    }

    /// Compares the state at the beginning of a frame with the recorded hash.
    fn compare(&mut self, stage: &Stage) {
        let Moment { frame, entries, .. } = self.moment;
        let before = entries.checked_sub(1).and_then(|last| stage.recording.entries().get(last));
        let is_at_start = before.is_none_or(|entry| entry.frame < frame);
        let recorded = stage.recording.hashes().get(&frame).filter(|_| is_at_start);
        let Some((recorded, found)) = recorded.map(|recorded| (*recorded, stage.kitchen.state_hash())) else { return };
        if found != recorded {
            self.depart(DepartureCause::Hash { recorded, found });
        }
    }

    fn depart(&mut self, cause: DepartureCause) {
        let time_s = self.moment.frame as f64 * FRAME_S;
        self.departure.get_or_insert(Departure { time_s, cause });
    }

    fn carry_out(&mut self, stage: &mut Stage, until: Moment, after_steps: bool) {
        let is_due = |entry: &&Entry, frame: u64| entry.frame == frame && entry.after_steps == after_steps;
        while self.moment.entries < until.entries {
            let next = stage.recording.entries().get(self.moment.entries);
            let Some(entry) = next.filter(|entry| is_due(entry, self.moment.frame)) else { return };
            self.moment.entries += 1;
            self.carry_out_one(&entry.deed, stage);
        }
    }

    fn carry_out_one(&mut self, deed: &Deed, stage: &mut Stage) {
        match deed {
            Deed::TakeOver => self.plays = false,
            Deed::Resume => self.plays = true,
            Deed::Command(_) | Deed::Add(_) | Deed::Remove(_) => {}
        }
        if let Err(cause) = deed.carry_out(stage.kitchen, stage.library, &mut self.models) {
            self.depart(cause);
        }
    }

    /// Carries out the steps of the recipe that are due. A step that fails ends the recipe, as it did when it was recorded.
    fn poll(&mut self, stage: &mut Stage) -> Vec<StepRecord> {
        if !self.plays || !stage.kitchen.is_between_ticks() || stage.runner.stopped().is_some() {
            return Vec::new();
        }
        stage.runner.poll(stage.kitchen).unwrap_or_else(|error| {
            self.fault = Some(error);
            self.plays = false;
            Vec::new()
        })
    }
}
