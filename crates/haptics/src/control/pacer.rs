//! The pacer of the control loop: waits for each step and skips steps that are too late.

use std::time::{Duration, Instant};

/// Time of busy waiting before each step (chosen: the typical oversleep of a timer).
const AWAKE: Duration = Duration::from_micros(60);
/// Lateness above which a step is skipped (chosen: two steps at once would jerk the hand).
const TOO_LATE: Duration = Duration::from_millis(1);

/// Schedule of a periodic loop.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pacer {
    period: Duration,
    due: Instant,
    missed: u64,
}

impl Pacer {
    /// Creates a schedule whose first step is due one period after `started`.
    pub fn new(period: Duration, started: Instant) -> Self {
        Self { period, due: started + period, missed: 0 }
    }

    /// Waits until the next step is due; returns the time and the step's lateness [µs].
    pub fn wait(&self) -> (Instant, f64) {
        wait_until(self.due);
        let now = Instant::now();
        (now, (now - self.due).as_secs_f64() * 1e6)
    }

    /// Schedules the next step, and skips the steps that are already too late.
    pub fn schedule_next(&mut self) {
        self.due += self.period;
        let behind = Instant::now().saturating_duration_since(self.due);
        if behind > TOO_LATE {
            let skipped = (behind.as_nanos() / self.period.as_nanos()) as u32;
            self.missed += u64::from(skipped);
            self.due += self.period * skipped;
        }
    }

    /// Returns the number of skipped steps so far.
    pub fn missed(&self) -> u64 {
        self.missed
    }
}

fn wait_until(due: Instant) {
    let left = due.saturating_duration_since(Instant::now());
    if left > AWAKE {
        std::thread::sleep(left - AWAKE);
    }
    while Instant::now() < due {
        std::hint::spin_loop();
    }
}
