//! Time is turned: travel to any instant, and what was done is done again on the way on.

use saute_kitchen::FRAMES_PER_TICK;
use saute_recipe::session::{Deed, Entry};
use saute_recipe::{Moment, Recording, Replay, Runner};
use web_time::Duration;

use super::Ahead;
use super::line::Line;
use super::travel::Travel;
use crate::Session;
use crate::hands::Hands;
use crate::playback::Purpose;

impl<H: Hands> Session<H> {
    /// True until the instant to which time was turned is reached; a near one is shown meanwhile.
    pub fn is_travelling(&self) -> bool {
        self.timeline.travel.is_some() || self.timeline.catches_up
    }

    /// The instant that is shown or on its way.
    pub(super) fn here(&self) -> Moment {
        self.timeline.travel.as_ref().map_or_else(|| self.recording.moment(), |travel| travel.to)
    }

    /// The recording with what was done after the shown instant.
    pub(crate) fn longest(&self) -> &Recording {
        self.timeline.course.ahead.as_ref().map_or(&self.recording, |ahead| &ahead.line.recording)
    }

    /// Stops time while the strip is dragged, or lets it go on.
    pub fn hold_time(&mut self, held: bool) {
        self.timeline.is_held = held;
        self.owed_s = 0.0;
    }

    /// Returns true while time does not go on: paused, held, or on its way to another instant.
    pub fn time_stands(&self) -> bool {
        self.paused || self.timeline.is_held || self.is_travelling()
    }

    /// Turns time to an instant of the cook [s]; what was ahead happens again when time goes on.
    pub fn scrub(&mut self, time_s: f64) {
        self.turn_to(time_s, true);
    }

    /// Turns time to an instant of the cook [s] from which another way is tried; what was ahead does not happen again and is kept as a branch
    /// once time goes on.
    pub fn try_from(&mut self, time_s: f64) {
        self.turn_to(time_s, false);
    }

    fn turn_to(&mut self, time_s: f64, is_followed: bool) {
        if self.timeline.catches_up {
            return;
        }
        let longest = self.longest();
        let tick = (time_s.max(0.0) / saute_kitchen::TICK_S).round() as u64;
        let end = longest.moment();
        let frame = tick * u64::from(FRAMES_PER_TICK);
        let to = if frame >= end.frame { end } else { longest.moment_at(frame) };
        self.timeline.course.redo.clear();
        self.travel_to(to, is_followed);
    }

    /// Begins to travel to a moment of the longest line.
    pub(super) fn travel_to(&mut self, to: Moment, is_followed: bool) {
        if to == self.here() {
            return;
        }
        self.open_ahead(is_followed);
        let travel = self.timeline.travel.take();
        let Some(ahead) = &self.timeline.course.ahead else { return };
        let nearest = ahead.line.keyframes.before(to).cloned().expect("the beginning is a keyframe");
        let traces = ahead.line.traces.until(to);
        let from = nearest.moment;
        let replay = match travel {
            Some(travel) if (from..=to).contains(&travel.replay.moment()) => travel.replay,
            None if (from..=to).contains(&self.recording.moment()) => self.as_replay(),
            _ => {
                let replay = nearest.replay(&self.library, &mut self.timeline.course.models);
                self.kitchen = replay.kitchen.clone();
                self.start_afresh();
                replay
            }
        };
        self.show_traces(traces);
        self.playback.forget();
        let apart = self.timeline.apart();
        self.timeline.travel = Some(Travel::new(replay, to, apart));
    }

    /// Keeps the present line as what is ahead, if nothing does yet.
    fn open_ahead(&mut self, is_followed: bool) {
        if self.timeline.course.ahead.is_none() {
            self.keep_keyframe();
            self.timeline.course.ahead = Some(Ahead { line: self.line(), is_followed });
        }
        if let Some(ahead) = &mut self.timeline.course.ahead {
            ahead.is_followed = is_followed;
        }
    }

    /// The shown instant, from which a recording can be played on.
    fn as_replay(&mut self) -> Replay {
        self.timeline.course.models.learn(&self.kitchen);
        let (runner, plays) = self.runner_here();
        Replay::at(self.kitchen.clone(), runner, plays, self.recording.moment()).sharing(&self.timeline.course.models)
    }

    /// The runner of the shown instant, also of a recipe that was left, and whether it plays.
    pub(crate) fn runner_here(&self) -> (Runner, bool) {
        let runner = self.runner.as_ref().or(self.left.as_ref()).cloned();
        (runner.unwrap_or_else(|| Runner::new(self.recipe.clone())), self.runner.is_some())
    }

    /// Travels on for no longer than `budget`; at least by a frame.
    pub fn travel_on(&mut self, budget: Duration) {
        // Who cannot wait plays it here.
        let waits = budget < Duration::MAX;
        if !waits {
            self.playback.forget();
        }
        if self.timeline.catches_up {
            if !(waits && self.catch_up_elsewhere()) {
                self.catch_up(budget);
            }
            return;
        }
        let Some(mut travel) = self.timeline.travel.take() else { return };
        let Some(ahead) = &mut self.timeline.course.ahead else { return };
        let models = &mut self.timeline.course.models;
        let purpose = Purpose::Shown(travel.to);
        if waits && self.playback.play_elsewhere(purpose, &mut travel, &mut ahead.line, &self.library, models) {
            self.timeline.travel = Some(travel);
            return self.timeline.thin();
        }
        if travel.go_on(&mut ahead.line, &self.library, budget) {
            return self.arrive(travel);
        }
        self.timeline.travel = Some(travel);
        self.timeline.thin();
        self.timeline.pack_on();
    }

    /// Travels to the end at once.
    pub fn finish_travel(&mut self) {
        self.travel_on(Duration::MAX);
    }

    fn arrive(&mut self, travel: Travel) {
        let Some(ahead) = self.timeline.course.ahead.take() else { return };
        let to = travel.to;
        if to == ahead.line.recording.moment() {
            self.recording = ahead.line.recording;
            self.timeline.course.keyframes = ahead.line.keyframes;
            self.show_traces(ahead.line.traces);
            self.take_kitchen(travel.replay);
            return;
        }
        self.recording = ahead.line.recording.clone();
        self.recording.truncate(to);
        self.timeline.course.keyframes = ahead.line.keyframes.until(to);
        let mut traces = ahead.line.traces.until(to);
        traces.settle(&travel.replay.kitchen);
        self.show_traces(traces);
        self.timeline.course.ahead = Some(ahead);
        self.take_kitchen(travel.replay);
    }

    /// The kitchen of a replay is the one that is shown.
    pub(crate) fn take_kitchen(&mut self, replay: Replay) {
        let plays = replay.plays() && replay.runner.stopped().is_none();
        self.kitchen = replay.kitchen;
        let left = self.plays && self.recording.is_taken_over() && replay.runner.stopped().is_none();
        (self.runner, self.left) = match plays {
            true => (Some(replay.runner), None),
            false => (None, left.then_some(replay.runner)),
        };
        self.listen();
        // What was heard on the way is recorded already.
        drop(self.kitchen.take_carried_out());
        self.start_afresh();
        self.keep_keyframe();
    }

    /// The entries of a recording after the shown instant happen when time goes on.
    pub(crate) fn lay_ahead(&mut self, recording: Recording) {
        let line = Line { recording, ..self.line() };
        self.timeline.course.ahead = Some(Ahead { line, is_followed: true });
        self.rejoin();
    }

    /// Returns true while something is ahead.
    pub fn lies_ahead(&self) -> bool {
        self.timeline.course.ahead.is_some()
    }

    /// Does again what was done at this frame, where time follows what is ahead.
    pub(crate) fn follow(&mut self, after_steps: bool) {
        while let Some(entry) = self.due(after_steps) {
            self.do_again(&entry);
        }
    }

    fn due(&self, after_steps: bool) -> Option<Entry> {
        let ahead = self.timeline.course.ahead.as_ref().filter(|ahead| ahead.is_followed)?;
        let next = ahead.line.recording.entries().get(self.recording.entries().len())?;
        (next.frame == self.kitchen.frame() && next.after_steps == after_steps).then(|| next.clone())
    }

    /// What the kitchen carried out once it carries out again: nothing is refused.
    fn do_again(&mut self, entry: &Entry) {
        match &entry.deed {
            Deed::TakeOver => self.leave_recipe(),
            Deed::Resume => self.runner = self.left.take(),
            Deed::Command(_) | Deed::Add(_) | Deed::Remove(_) => {}
        }
        drop(entry.deed.carry_out(&mut self.kitchen, &self.library, &mut self.timeline.course.models));
        drop(self.kitchen.take_carried_out());
        self.recording.restore(entry.clone());
        self.note_last();
        self.weigh_new();
    }

    /// Where what was ahead is reached again, nothing is ahead.
    pub(crate) fn rejoin(&mut self) {
        let here = self.recording.moment();
        let is_end = |ahead: &mut Ahead| ahead.is_followed && ahead.line.recording.moment() <= here;
        if self.is_travelling() {
            return;
        }
        if let Some(ahead) = self.timeline.course.ahead.take_if(is_end) {
            self.timeline.course.keyframes.join(ahead.line.keyframes);
            self.probes = ahead.line.traces.probes;
        }
    }
}
