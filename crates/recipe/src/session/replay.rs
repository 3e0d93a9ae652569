//! A session played again.

use std::sync::Arc;

use saute_kitchen::bytes::Models;
use saute_kitchen::kitchen::SetupError;
use saute_kitchen::{Kitchen, Library};
use saute_schema::{InputError, LibraryError};

use crate::cook::runner::Runner;
use crate::session::moment::Moment;
use crate::session::playhead::{Departure, Played, Playhead, Stage};
use crate::session::recording::Recording;

/// A kitchen in which a recording is played; a clone of it is a keyframe.
#[derive(Clone, Debug)]
pub struct Replay {
    /// The kitchen.
    pub kitchen: Kitchen,
    /// The runner of the recipe's steps.
    pub runner: Runner,
    head: Playhead,
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
    /// The kitchen at home that it carries is none.
    #[error(transparent)]
    Home(#[from] LibraryError),
}

impl Replay {
    /// Returns the kitchen as the session began.
    ///
    /// # Errors
    ///
    /// If the library has not what the session needs.
    pub fn begin(recording: &Recording, library: &Library) -> Result<Self, ReplayError> {
        let beginning = recording.beginning();
        let library = &*beginning.library(library)?;
        let recipe = beginning.recipe(library)?;
        let kitchen = recipe.kitchen(library)?;
        Ok(Self::at(kitchen, Runner::new(Arc::new(recipe)), beginning.plays, Moment::default()))
    }

    /// Returns a live kitchen at a moment of its recording; `plays` is true while the recipe's steps are carried out.
    pub fn at(kitchen: Kitchen, runner: Runner, plays: bool, moment: Moment) -> Self {
        let head = Playhead::at(moment, plays, &kitchen);
        Self { kitchen, runner, head }
    }

    /// Shares known models, so that foods that are added again need not be built again.
    pub fn sharing(mut self, models: &Models) -> Self {
        self.head.share(models, &self.kitchen);
        self
    }

    /// The instant at which it is.
    pub fn moment(&self) -> Moment {
        self.head.moment
    }

    /// Returns true while the recipe's steps are carried out.
    pub fn plays(&self) -> bool {
        self.head.plays
    }

    /// The first departure from the recording; none as long as it is bit by bit the same.
    pub fn departure(&self) -> Option<&Departure> {
        self.head.departure.as_ref()
    }

    /// The error of the recipe's step that could not be carried out, neither then nor now.
    pub fn fault(&self) -> Option<&InputError> {
        self.head.fault.as_ref()
    }

    /// Returns the kitchen, and the runner if the recipe plays.
    pub fn into_parts(self) -> (Kitchen, Option<Runner>) {
        (self.kitchen, Some(self.runner).filter(|_| self.head.plays))
    }

    /// Goes on to a later moment and stops there.
    pub fn run_to(&mut self, recording: &Recording, library: &Library, moment: Moment) {
        while self.moment().frame < moment.frame {
            self.advance_frame(recording, library);
        }
        self.settle(recording, library, moment);
    }

    /// Carries out what is due at this frame, then advances by one frame.
    pub fn advance_frame(&mut self, recording: &Recording, library: &Library) -> Played {
        let Self { kitchen, runner, head } = self;
        head.advance_frame(&mut Stage { kitchen, runner, recording, library })
    }

    /// Carries out entries and steps of this frame up to a moment in it; returns them.
    pub fn settle(&mut self, recording: &Recording, library: &Library, until: Moment) -> Played {
        let Self { kitchen, runner, head } = self;
        head.settle(&mut Stage { kitchen, runner, recording, library }, until)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::Recipe;
    use crate::session::playhead::DepartureCause;

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
