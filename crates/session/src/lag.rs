//! A clock that lags behind its speed, and the speed that the machine holds.

use crate::SPEEDS;

/// How long the clock may lag before a lower speed is chosen [wall s] (chosen: one slow moment is no slow machine).
const PATIENCE_S: f64 = 2.0;

/// A lag of the clock: when it began, and for how long it has lasted.
#[derive(Clone, Copy, Debug)]
pub struct Lag {
    /// Simulated time at its beginning [s].
    from_s: f64,
    /// Wall time since [s].
    wall_s: f64,
}

impl Lag {
    /// A lag that begins now, at a simulated time [s].
    pub fn begun(time_s: f64) -> Self {
        Self { from_s: time_s, wall_s: 0.0 }
    }

    /// Goes on through `wall` seconds; returns the speed below the present one that the machine holds, once it has lagged for long [-].
    pub fn holdable(&mut self, now: f64, time_s: f64, wall: f64) -> Option<f64> {
        self.wall_s += wall;
        (self.wall_s >= PATIENCE_S).then(|| holdable(now, (time_s - self.from_s) / self.wall_s))
    }
}

/// The highest speed below the present one that the machine holds, or the lowest.
fn holdable(now: f64, held: f64) -> f64 {
    let lower = SPEEDS.into_iter().rev().find(|s| *s < now && *s <= held);
    lower.unwrap_or(SPEEDS[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_highest_speed_that_holds_is_chosen() {
        assert_eq!(holdable(20.0, 12.0), 5.0);
        assert_eq!(holdable(20.0, 3.0), 3.0);
        assert_eq!(holdable(5.0, 2.9), 2.0);
        assert_eq!(holdable(5.0, 0.4), 1.0);
    }
}
