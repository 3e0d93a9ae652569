//! Work off the frame ([`work`](crate::work)): a cook that is played again.
//!
//! The window gives a [`PlayOrder`] to its [`Helper`] and goes on drawing. [`Playing`](self::playing::Playing) on the other side plays
//! the recording in slices, and answers with [`Stop`]s on the way: keyframes that the window keeps, the last one where it was bound
//! for. Without a helper the window plays the cook itself.

mod caught_up;
pub mod playing;

use std::sync::Arc;

use saute_kitchen::bytes::Models;
use saute_kitchen::{Kitchen, Library};
use saute_recipe::{Moment, Recipe, Recorder, Replay, Runner, RunnerState};
use serde::{Deserialize, Serialize};

use super::mark::Mark;
use crate::work::Helper;

/// Frames that are played faster than they are handed over (chosen: two seconds; a kitchen as bytes takes some thousandths of a second).
pub(super) const WORTH_FRAMES: u64 = 120;

/// A cook to be played.
#[derive(Debug, Deserialize, Serialize)]
pub struct PlayOrder {
    /// Its number, by which answers are known.
    number: u64,
    /// The file of the recording.
    recording: Vec<u8>,
    /// From where on; from the beginning, with curves and marks, unless given.
    from: Option<Instant>,
    /// Up to where.
    to: Moment,
}

/// An instant of a cook as bytes.
#[derive(Debug, Deserialize, Serialize)]
pub struct Instant {
    moment: Moment,
    kitchen: Vec<u8>,
    runner: RunnerState,
    plays: bool,
}

impl Instant {
    pub(super) fn of(replay: &Replay) -> Self {
        let Replay { kitchen, runner, .. } = replay;
        let (moment, plays) = (replay.moment(), replay.plays());
        Self { moment, kitchen: kitchen.to_bytes(), runner: runner.state(), plays }
    }

    /// The instant, from which the cook can be played on; none if the bytes are of another program.
    fn replay(self, recipe: &Arc<Recipe>, library: &Library, models: &mut Models) -> Option<Replay> {
        let kitchen = Kitchen::from_bytes_with(&self.kitchen, library, models).ok()?;
        let runner = Runner::resumed(Arc::clone(recipe), self.runner);
        Some(Replay::at(kitchen, runner, self.plays, self.moment).sharing(models))
    }
}

/// What comes back: an instant on the way.
#[derive(Debug, Deserialize, Serialize)]
pub struct Stop {
    number: u64,
    at: Instant,
    /// What belongs to the way there, if it was played from the beginning.
    traced: Option<Traced>,
    /// True if the order is done.
    is_last: bool,
}

impl Stop {
    /// True if the order is done.
    pub(super) fn is_last(&self) -> bool {
        self.is_last
    }

    /// Its moment, its kitchen as bytes, its runner, and whether the recipe plays.
    pub(super) fn instant(&self, recipe: &Arc<Recipe>) -> (Moment, &[u8], Runner, bool) {
        let Instant { moment, kitchen, runner, plays } = &self.at;
        (*moment, kitchen, Runner::resumed(Arc::clone(recipe), runner.clone()), *plays)
    }

    /// The instant, from which the cook can be played on.
    pub(super) fn into_replay(self, recipe: &Arc<Recipe>, library: &Library, models: &mut Models) -> Option<Replay> {
        self.at.replay(recipe, library, models)
    }
}

/// What a cook leaves behind: its recording with hashes, curves and marks.
#[derive(Debug, Deserialize, Serialize)]
struct Traced {
    recording: Vec<u8>,
    recorder: Recorder,
    marks: Vec<Mark>,
    start_mass_g: std::collections::BTreeMap<String, f64>,
}

/// The window's side: the helper, and its last request.
#[derive(Default)]
pub(super) struct Playback {
    helper: Option<Box<dyn Helper>>,
    asked: u64,
    /// The request that is not done.
    open: Option<(u64, Purpose)>,
}

/// What an order is for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Purpose {
    /// The cook that is shown, at a moment.
    Shown(Moment),
    /// A way next to it, by its number: it follows the clock.
    Beside(u64),
}

impl Playback {
    /// Lets a helper play cooks from now on.
    pub fn employ(&mut self, helper: Box<dyn Helper>) {
        self.helper = Some(helper);
    }

    /// Returns true while an order for this purpose is under way.
    pub(super) fn is_open(&self, purpose: Purpose) -> bool {
        self.open.is_some_and(|(_, open)| open == purpose)
    }

    /// Returns true if there is a helper.
    pub fn has_helper(&self) -> bool {
        self.helper.is_some()
    }

    /// Sends an order unless it is open already. What is shown comes first: a way next to it waits.
    pub(super) fn ask(&mut self, purpose: Purpose, to: Moment, order: impl FnOnce() -> (Vec<u8>, Option<Instant>)) {
        let Some(helper) = &mut self.helper else { return };
        let comes_first = |open: Purpose| open == purpose || matches!(purpose, Purpose::Beside(_));
        if self.open.is_some_and(|(_, open)| comes_first(open)) {
            return;
        }
        self.asked += 1;
        self.open = Some((self.asked, purpose));
        let (recording, from) = order();
        let order = PlayOrder { number: self.asked, recording, from, to };
        helper.ask(postcard::to_allocvec(&order).expect("an order has no kind that postcard lacks"));
    }

    /// Stops that have come, if the open order is for this purpose. A helper that is of no use is let go.
    pub(super) fn stops(&mut self, purpose: Purpose) -> Vec<Stop> {
        if self.open.is_some_and(|(_, open)| open != purpose) {
            return Vec::new();
        }
        let Some(answers) = self.helper.as_mut().map(|helper| helper.answers()) else { return Vec::new() };
        let Some(answers) = answers else {
            (self.helper, self.open) = (None, None);
            return Vec::new();
        };
        let open = self.open.map(|(number, _)| number);
        let read = answers.iter().filter_map(|bytes| postcard::from_bytes::<Stop>(bytes).ok());
        let stops: Vec<Stop> = read.filter(|stop| Some(stop.number) == open).collect();
        if stops.iter().any(|stop| stop.is_last) {
            self.open = None;
        }
        stops
    }

    /// The open order is not needed any more.
    pub fn forget(&mut self) {
        self.open = None;
    }
}
