//! How many messages a sender may send: a bucket that fills evenly and is emptied by each.

use std::time::Instant;

/// A bucket.
#[derive(Clone, Copy, Debug)]
pub struct Allowance {
    rate_hz: f64,
    burst: f64,
    left: f64,
    counted: Instant,
}

impl Allowance {
    /// So many messages a second, and so many at once.
    pub fn new(rate_hz: f64, burst: f64, now: Instant) -> Self {
        Self { rate_hz, burst, left: burst, counted: now }
    }

    /// Whether one more may come now.
    pub fn takes(&mut self, now: Instant) -> bool {
        let passed = now.saturating_duration_since(self.counted).as_secs_f64();
        self.left = (self.left + passed * self.rate_hz).min(self.burst);
        self.counted = now;
        let takes = self.left >= 1.0;
        self.left -= if takes { 1.0 } else { 0.0 };
        takes
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    #[test]
    fn a_burst_passes_then_only_what_the_rate_allows() {
        let now = Instant::now();
        let mut bucket = Allowance::new(100.0, 10.0, now);
        assert_eq!((0..50).filter(|_| bucket.takes(now)).count(), 10);
        let later = now + Duration::from_millis(50);
        assert_eq!((0..50).filter(|_| bucket.takes(later)).count(), 5);
    }
}
