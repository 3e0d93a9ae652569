//! A travel along what was done, to any instant, in slices of a frame's time.

use std::sync::Arc;

use saute_recipe::{Moment, Replay};
use web_time::{Duration, Instant};

use super::keyframes::COMPUTED_PER_KEYFRAME;
use super::line::Line;
use crate::playback::{Instant as PlayedInstant, Playback, Purpose, WORTH_FRAMES};
use saute_kitchen::Library;
use saute_kitchen::bytes::Models;

/// A travel that has not arrived.
pub(super) struct Travel {
    pub(super) replay: Replay,
    pub(super) to: Moment,
    /// Computing time since the last keyframe.
    computed: Duration,
    /// Frames between two keyframes at least.
    apart: u64,
}

impl Travel {
    /// A travel from where a replay is.
    pub(super) fn new(replay: Replay, to: Moment, apart: u64) -> Self {
        Self { replay, to, computed: Duration::ZERO, apart }
    }

    /// A travel along a line to a moment: it goes on from where an earlier one is if that is near, else from a keyframe.
    pub(super) fn toward(
        to: Moment,
        earlier: &mut Option<Self>,
        line: &Line,
        library: &Library,
        (models, apart): (&mut Models, u64),
    ) -> Self {
        match earlier.take_if(|travel| travel.is_near(to, line)) {
            Some(travel) => Self { to, apart, ..travel },
            None => {
                let nearest = line.keyframes.before(to).expect("the beginning is a keyframe");
                Self::new(nearest.replay(library, models), to, apart)
            }
        }
    }

    /// Returns true if a moment is reached sooner from here than from any keyframe of its line.
    pub(super) fn is_near(&self, to: Moment, line: &Line) -> bool {
        let here = self.replay.moment();
        here <= to && line.keyframes.before(to).is_none_or(|nearest| nearest.moment <= here)
    }

    /// Goes on along a line for no longer than `budget`, at least by a frame; returns true when it has arrived.
    pub(super) fn go_on(&mut self, line: &mut Line, library: &Library, budget: Duration) -> bool {
        let begun = Instant::now();
        while self.replay.moment().frame < self.to.frame {
            self.step(line, library);
            if begun.elapsed() >= budget && self.replay.moment().frame < self.to.frame {
                return false;
            }
        }
        self.replay.settle(&line.recording, library, self.to);
        true
    }

    pub(super) fn into_replay(self) -> Replay {
        self.replay
    }

    /// Plays a frame again; keeps a keyframe after much computing, so that the way is short the next time.
    fn step(&mut self, line: &mut Line, library: &Library) {
        let begun = Instant::now();
        let Replay { kitchen, .. } = &self.replay;
        let moment = self.replay.moment();
        let is_apart =
            || line.keyframes.before(moment).is_none_or(|last| last.moment.frame + self.apart <= moment.frame);
        if self.computed >= COMPUTED_PER_KEYFRAME
            && is_apart()
            && kitchen.is_between_ticks()
            && !line.keyframes.has(moment)
        {
            line.keyframes.keep(kitchen, &self.replay.runner, self.replay.plays(), moment);
            self.computed = Duration::ZERO;
        }
        self.replay.advance_frame(&line.recording, library);
        self.computed += begun.elapsed();
    }
}

impl Playback {
    /// Lets the helper play a long way, and keeps the keyframes that come back; returns false where the way is short, or at its end.
    pub(super) fn play_elsewhere(
        &mut self,
        purpose: Purpose,
        travel: &mut Travel,
        line: &mut Line,
        library: &Library,
        models: &mut Models,
    ) -> bool {
        let rest = travel.to.frame.saturating_sub(travel.replay.moment().frame);
        if !self.has_helper() || rest < WORTH_FRAMES && !self.is_open(purpose) {
            return false;
        }
        self.ask(purpose, travel.to, || (line.recording.to_file(), Some(PlayedInstant::of(&travel.replay))));
        let recipe = Arc::clone(travel.replay.runner.recipe());
        for stop in self.stops(purpose) {
            line.keyframes.keep_stop(&stop, &recipe);
            if stop.is_last()
                && let Some(replay) = stop.into_replay(&recipe, library, models)
            {
                travel.replay = replay;
            }
        }
        self.is_open(purpose)
    }
}
