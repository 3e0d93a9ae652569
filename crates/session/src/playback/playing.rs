//! How orders are done: a recorded cook is played in slices.

use std::sync::Arc;

use saute_kitchen::Library;
use saute_kitchen::bytes::Models;
use saute_recipe::{Moment, Recording, Replay};
use web_time::{Duration, Instant as Clock};

use super::{Instant, PlayOrder, Stop};
use crate::Session;
use crate::work::worker::Worker;

/// Computing time between two stops (chosen: the picture of a cook that is played moves a few times a second).
const COMPUTED_PER_STOP: Duration = Duration::from_millis(300);

/// What plays a cook.
enum Player {
    /// From an instant on.
    Part(Box<(Replay, Recording)>),
    /// From the beginning, with curves and marks.
    Whole(Box<Session>),
}

/// The order that is under way.
struct Work {
    number: u64,
    to: Moment,
    player: Player,
    computed: Duration,
}

/// The playing of recorded cooks, with its own foods and pans.
pub struct Playing {
    library: Arc<Library>,
    models: Models,
    work: Option<Work>,
    computed_per_stop: Duration,
}

impl Playing {
    /// Without an order.
    pub fn new(library: Arc<Library>) -> Self {
        Self { library, models: Models::default(), work: None, computed_per_stop: COMPUTED_PER_STOP }
    }

    /// The same with another computing time between two stops.
    pub fn stopping_every(self, computed: Duration) -> Self {
        Self { computed_per_stop: computed, ..self }
    }

    fn begin(&mut self, order: PlayOrder) -> Option<Work> {
        let PlayOrder { number, recording, from, to } = order;
        let recording = Recording::from_file(&recording).ok()?.recording;
        let player = match from {
            Some(instant) => {
                let recipe = Arc::new(recording.beginning().recipe(&self.library).ok()?);
                let replay = instant.replay(&recipe, &self.library, &mut self.models)?;
                Player::Part(Box::new((replay, recording)))
            }
            None => {
                let mut session = Session::new(Arc::clone(&self.library), &Default::default()).ok()?;
                session.resume(recording).ok()?;
                Player::Whole(Box::new(session))
            }
        };
        Some(Work { number, to, player, computed: Duration::ZERO })
    }
}

impl Worker for Playing {
    fn take(&mut self, order: &[u8]) {
        self.work = postcard::from_bytes(order).ok().and_then(|order| self.begin(order));
    }

    fn is_busy(&self) -> bool {
        self.work.is_some()
    }

    fn go_on(&mut self, budget: Duration) -> Option<Vec<u8>> {
        let work = self.work.as_mut()?;
        let begun = Clock::now();
        let is_last = work.play(&self.library, budget);
        work.computed += begun.elapsed();
        if !is_last && work.computed < self.computed_per_stop {
            return None;
        }
        work.computed = Duration::ZERO;
        let stop = work.stop(is_last);
        if is_last {
            self.work = None;
        }
        postcard::to_allocvec(&stop).ok()
    }
}

impl Work {
    /// Plays on; returns true at the end.
    fn play(&mut self, library: &Library, budget: Duration) -> bool {
        match &mut self.player {
            Player::Part(part) => {
                let (replay, recording) = &mut **part;
                let begun = Clock::now();
                while replay.moment().frame < self.to.frame {
                    replay.advance_frame(recording, library);
                    // A keyframe is kept between ticks.
                    if begun.elapsed() >= budget && replay.kitchen.is_between_ticks() {
                        return false;
                    }
                }
                replay.settle(recording, library, self.to);
                true
            }
            Player::Whole(session) => {
                session.travel_on(budget);
                !session.is_travelling()
            }
        }
    }

    fn stop(&self, is_last: bool) -> Stop {
        let (at, traced) = match &self.player {
            Player::Part(part) => (Instant::of(&part.0), None),
            Player::Whole(session) => (session.instant(), Some(session.traced())),
        };
        Stop { number: self.number, at, traced, is_last }
    }
}
