//! A double pulse for devices with vibration motors: something is to be done now.

use crate::control::rumble::Rumble;

/// Length of each pulse, and of the pause between them [s] (chosen: two knocks that are distinguishable, over within half a second).
const PULSE_S: f64 = 0.14;
/// Strengths of both motors [-] (chosen: distinguishable from boiling, which the weak motor renders, and from a landing steak).
const KNOCK: Rumble = Rumble { strong: 0.6, weak: 1.0 };

/// A short double pulse of both motors [-].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DoublePulse {
    /// Time since it began [s]; none while it is not played.
    since_s: Option<f64>,
}

impl DoublePulse {
    /// Begins it, from its start.
    pub fn begin(&mut self) {
        self.since_s = Some(0.0);
    }

    /// Returns true from its beginning to its end.
    pub fn is_on(&self) -> bool {
        self.since_s.is_some()
    }

    /// Returns what it adds to the rumble of a step of `dt` [s] [-]. A long step leaves out no pulse and no pause.
    pub fn step(&mut self, dt: f64) -> Rumble {
        let Some(since_s) = self.since_s else { return Rumble::default() };
        // Whole numbers of pulses, within what rounding adds.
        let part = ((since_s / PULSE_S) + 1e-9).floor();
        let next_s = since_s + dt.clamp(0.0, PULSE_S);
        self.since_s = (next_s < 3.0 * PULSE_S - 1e-9).then_some(next_s);
        if part == 1.0 { Rumble::default() } else { KNOCK }
    }
}
