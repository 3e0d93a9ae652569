//! The stop message, repeated: one lost frame must not leave a force.

/// Number of stops that are sent (chosen: one frame in a hundred lost leaves one stop in a million).
const STOPS: u8 = 3;
/// Interval between two stops [s] (chosen: longer than most bursts of lost frames, short for a hand).
pub const INTERVAL_S: f64 = 0.002;
/// Rounding of summed times [s] (chosen: far below a step).
const ROUNDING_S: f64 = 1e-9;

/// What a stopped driver still has to send.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stops {
    left: u8,
    /// Time at which the next one is due [s].
    due: f64,
}

impl Stops {
    /// Starts at a time of the driver's clock [s]; the first stop is due at once.
    pub fn from(now: f64) -> Self {
        Self { left: STOPS, due: now }
    }

    /// Returns true if a stop is due, and counts it as sent.
    pub fn is_due(&mut self, now: f64) -> bool {
        let due = self.left > 0 && now >= self.due - ROUNDING_S;
        if due {
            self.left -= 1;
            self.due = now + INTERVAL_S;
        }
        due
    }

    /// Returns the number of stops that are not sent yet.
    pub fn left(&self) -> u8 {
        self.left
    }
}
