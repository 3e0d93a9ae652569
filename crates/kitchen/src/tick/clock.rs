//! Simulated time in ticks and frames.

use crate::tick::lapse::Lapse;
use crate::{FRAME_S, FRAMES_PER_TICK, TICK_S};
use serde::{Deserialize, Serialize};

/// Clock of a kitchen.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq, Serialize)]
pub(crate) struct Clock {
    /// Ticks since the start.
    tick: u64,
    /// Frames since the last tick.
    frame: u32,
}

impl Clock {
    /// Ticks since the start [-].
    pub(crate) fn tick(self) -> u64 {
        self.tick
    }

    /// Frames since the start [-].
    pub(crate) fn frames(self) -> u64 {
        self.tick * u64::from(FRAMES_PER_TICK) + u64::from(self.frame)
    }

    /// Time at the present frame [s].
    pub(crate) fn time_s(self) -> f64 {
        self.tick as f64 * TICK_S + f64::from(self.frame) * FRAME_S
    }

    /// Time at the start of the present tick [s].
    pub(crate) fn tick_start_s(self) -> f64 {
        self.tick as f64 * TICK_S
    }

    /// Time at the end of a lapse that begins with the present tick [s].
    pub(crate) fn end_s(self, lapse: Lapse) -> f64 {
        (self.tick + lapse.ticks) as f64 * TICK_S
    }

    /// Returns true if no frame has passed since the last tick.
    pub(crate) fn is_between_ticks(self) -> bool {
        self.frame == 0
    }

    /// Returns true if it can go on: a part of a tick, and ticks that still count exactly as a number of seconds.
    pub(crate) fn is_sound(self) -> bool {
        self.frame < FRAMES_PER_TICK && self.tick < 1 << 50
    }

    /// Counts a frame; returns true if it completes a tick, whose heat transfer is then due.
    pub(crate) fn count_frame(&mut self) -> bool {
        self.frame += 1;
        if self.frame < FRAMES_PER_TICK {
            return false;
        }
        self.frame = 0;
        true
    }

    /// Counts the ticks of a lapse.
    pub(crate) fn count(&mut self, lapse: Lapse) {
        self.tick += lapse.ticks;
    }
}
