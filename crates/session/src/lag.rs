//! A clock that lags behind its speed, the speed that the machine holds, and when a higher one is tried again.

use crate::SPEEDS;

/// How long the clock may lag before a lower speed is chosen [wall s] (chosen: one slow moment is no slow machine).
const PATIENCE_S: f64 = 2.0;

/// How long a speed must be held until the next higher one is tried, at first and at most [wall s] (chosen: what else kept the
/// machine busy may be over; a machine that is slow by itself stumbles once in some minutes).
const RETRY_S: [f64; 2] = [10.0, 160.0];

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

/// When a speed that the machine gave up is tried again.
#[derive(Clone, Copy, Debug)]
pub struct Retry {
    /// How long the lower one has been held, and for how long it must be [wall s].
    held_s: f64,
    wait_s: f64,
}

impl Default for Retry {
    fn default() -> Self {
        Self { held_s: 0.0, wait_s: RETRY_S[0] }
    }
}

impl Retry {
    /// The machine gave a speed up: the next try comes after twice the time.
    pub fn gave_up(&mut self) {
        (self.held_s, self.wait_s) = (0.0, (2.0 * self.wait_s).min(RETRY_S[1]));
    }

    /// A speed was held for another `wall` seconds; returns the next higher one up to `wished`, if it is to be tried [-].
    pub fn held(&mut self, now: f64, wished: f64, wall: f64) -> Option<f64> {
        self.held_s += wall;
        if self.held_s < self.wait_s {
            return None;
        }
        self.held_s = 0.0;
        SPEEDS.into_iter().find(|s| *s > now && *s <= wished)
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

    #[test]
    fn a_speed_is_tried_again_one_step_at_a_time_and_later_after_each_failure() {
        let mut retry = Retry::default();
        assert_eq!((retry.held(1.0, 5.0, 9.0), retry.held(1.0, 5.0, 1.0)), (None, Some(2.0)));
        retry.gave_up();
        assert_eq!((retry.held(1.0, 5.0, 19.0), retry.held(1.0, 5.0, 1.0)), (None, Some(2.0)));
        assert_eq!(retry.held(5.0, 5.0, 20.0), None, "it is as fast as was wished");
        (0..9).for_each(|_| retry.gave_up());
        assert_eq!(retry.held(2.0, 20.0, 160.0), Some(3.0));
    }
}
