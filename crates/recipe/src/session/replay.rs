//! A session played again.

use std::sync::Arc;

use saute_kitchen::bytes::Models;
use saute_kitchen::kitchen::SetupError;
use saute_kitchen::{FRAME_S, InputError, Kitchen, Library, Refused};

use crate::cook::runner::Runner;
use crate::cook::step_record::StepRecord;
use crate::session::entry::{Deed, Entry};
use crate::session::moment::Moment;
use crate::session::recording::Recording;

/// A kitchen in which a recording is played; a clone of it is a keyframe.
#[derive(Clone, Debug)]
pub struct Replay {
    /// The kitchen.
    pub kitchen: Kitchen,
    /// The runner of the recipe's steps.
    pub runner: Runner,
    plays: bool,
    moment: Moment,
    departure: Option<Departure>,
    fault: Option<InputError>,
    models: Models,
}

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

/// Why a replay cannot begin.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ReplayError {
    /// The recipe cannot be used.
    #[error(transparent)]
    Recipe(#[from] InputError),
    /// Pan or food cannot be built.
    #[error(transparent)]
    Setup(#[from] SetupError),
}

impl Replay {
    /// Returns the kitchen as the session began.
    ///
    /// # Errors
    ///
    /// If the library has not what the session needs.
    pub fn begin(recording: &Recording, library: &Library) -> Result<Self, ReplayError> {
        let beginning = recording.beginning();
        let recipe = beginning.recipe(library)?;
        let kitchen = recipe.kitchen(library)?;
        Ok(Self::at(kitchen, Runner::new(Arc::new(recipe)), beginning.plays, Moment::default()))
    }

    /// Returns a live kitchen at a moment of its recording; `plays` is true while the recipe's steps are carried out.
    pub fn at(kitchen: Kitchen, runner: Runner, plays: bool, moment: Moment) -> Self {
        let models = Models::of(&kitchen);
        Self { kitchen, runner, plays, moment, departure: None, fault: None, models }
    }

    /// Shares known models, so that foods that are added again need not be built again.
    pub fn sharing(mut self, models: &Models) -> Self {
        self.models = models.clone();
        self.models.learn(&self.kitchen);
        self
    }

    /// The instant at which it is.
    pub fn moment(&self) -> Moment {
        self.moment
    }

    /// Returns true while the recipe's steps are carried out.
    pub fn plays(&self) -> bool {
        self.plays
    }

    /// The first departure from the recording; none as long as it is bit by bit the same.
    pub fn departure(&self) -> Option<&Departure> {
        self.departure.as_ref()
    }

    /// The error of the recipe's step that could not be carried out, neither then nor now.
    pub fn fault(&self) -> Option<&InputError> {
        self.fault.as_ref()
    }

    /// Returns the kitchen, and the runner if the recipe plays.
    pub fn into_parts(self) -> (Kitchen, Option<Runner>) {
        (self.kitchen, Some(self.runner).filter(|_| self.plays))
    }

    /// Goes on to a later moment and stops there.
    pub fn run_to(&mut self, recording: &Recording, library: &Library, moment: Moment) {
        while self.moment.frame < moment.frame {
            self.advance_frame(recording, library);
        }
        self.settle(recording, library, moment);
    }

    /// Carries out what is due at this frame, then advances by one frame.
    pub fn advance_frame(&mut self, recording: &Recording, library: &Library) -> Played {
        let all = Moment { steps_done: true, entries: usize::MAX, ..self.moment };
        let mut played = self.settle(recording, library, all);
        played.ticked = self.kitchen.advance_frame();
        self.moment = Moment { frame: self.kitchen.frame(), steps_done: false, ..self.moment };
        played
    }

    /// Carries out entries and steps of this frame up to a moment in it; returns them.
    pub fn settle(&mut self, recording: &Recording, library: &Library, until: Moment) -> Played {
        let first = self.moment.entries;
        if !self.moment.steps_done {
            self.compare(recording);
        }
        self.carry_out(recording, library, until, false);
        let mut fired = Vec::new();
        if until.steps_done && !self.moment.steps_done {
            fired = self.poll();
            self.moment.steps_done = true;
        }
        self.carry_out(recording, library, until, true);
        Played { fired, entries: first..self.moment.entries, ticked: false }
    }

    /// Compares the state at the beginning of a frame with the recorded hash.
    fn compare(&mut self, recording: &Recording) {
        let is_at_start =
            recording.entries().get(self.moment.entries.wrapping_sub(1)).is_none_or(|e| e.frame < self.moment.frame);
        let Some(recorded) = recording.hashes().get(&self.moment.frame).copied().filter(|_| is_at_start) else {
            return;
        };
        let found = self.kitchen.state_hash();
        if found != recorded {
            self.depart(DepartureCause::Hash { recorded, found });
        }
    }

    fn depart(&mut self, cause: DepartureCause) {
        let time_s = self.moment.frame as f64 * FRAME_S;
        self.departure.get_or_insert(Departure { time_s, cause });
    }

    fn carry_out(&mut self, recording: &Recording, library: &Library, until: Moment, after_steps: bool) {
        let is_due = |entry: &&Entry, frame: u64| entry.frame == frame && entry.after_steps == after_steps;
        while self.moment.entries < until.entries {
            let next = recording.entries().get(self.moment.entries);
            let Some(entry) = next.filter(|entry| is_due(entry, self.moment.frame)) else { return };
            self.moment.entries += 1;
            self.carry_out_one(&entry.deed, library);
        }
    }

    fn carry_out_one(&mut self, deed: &Deed, library: &Library) {
        match deed {
            Deed::TakeOver => self.plays = false,
            Deed::Resume => self.plays = true,
            Deed::Command(command) => {
                if let Err(refused) = self.kitchen.apply(command) {
                    self.depart(DepartureCause::Refused(refused));
                }
            }
            Deed::Add(order) => {
                if let Err(error) = self.kitchen.add_with(library, order, &mut self.models) {
                    self.depart(DepartureCause::Setup(error));
                }
            }
            Deed::Remove(food) => self.kitchen.remove(food),
        }
    }

    /// Carries out the steps of the recipe that are due. A step that fails ends the recipe, as it did when it was recorded.
    fn poll(&mut self) -> Vec<StepRecord> {
        if !self.plays || !self.kitchen.is_between_ticks() || self.runner.stopped().is_some() {
            return Vec::new();
        }
        self.runner.poll(&mut self.kitchen).unwrap_or_else(|error| {
            self.fault = Some(error);
            self.plays = false;
            Vec::new()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::Recipe;

    #[test]
    fn a_replay_says_where_it_departs() {
        let library = Library::embedded().expect("embedded data");
        let text = "[[step]]\nhob_w = 900\n[[step]]\nat_s = 40\nend = true\n";
        let recipe = Recipe::parse(text, "warm.toml", &library).expect("parses");
        let mut recording = Recording::begin(&recipe, true, &library);
        let mut live = Replay::begin(&recording, &library).expect("begins");
        while live.kitchen.time_s() < 25.0 {
            live.advance_frame(&recording.clone(), &library);
            recording.observe(&live.kitchen);
        }
        assert_eq!(live.departure(), None);
        let played = |recording: &Recording| {
            let mut replay = Replay::begin(recording, &library).expect("begins");
            replay.run_to(recording, &library, recording.moment());
            replay.departure().cloned()
        };
        assert_eq!(played(&recording), None);
        recording.restore_hash(1200, 7);
        let departure = played(&recording).expect("departs");
        assert!(matches!(departure.cause, DepartureCause::Hash { recorded: 7, .. }));
        assert!(
            departure.to_string().starts_with("the replay departs at 20.0 s: the state has the hash "),
            "{departure}"
        );
    }
}
