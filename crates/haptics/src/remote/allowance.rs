//! Rate limit of messages: a token bucket.

use std::time::Instant;

/// A token bucket.
#[derive(Clone, Copy, Debug)]
pub struct Allowance {
    rate_hz: f64,
    burst: f64,
    tokens: f64,
    updated: Instant,
}

impl Allowance {
    /// Creates a full bucket with a refill rate [Hz] and a capacity.
    pub fn new(rate_hz: f64, burst: f64, now: Instant) -> Self {
        Self { rate_hz, burst, tokens: burst, updated: now }
    }

    /// Returns true if one more message is allowed, and takes its token.
    pub fn allows(&mut self, now: Instant) -> bool {
        let passed = now.saturating_duration_since(self.updated).as_secs_f64();
        self.tokens = (self.tokens + passed * self.rate_hz).min(self.burst);
        self.updated = now;
        let allowed = self.tokens >= 1.0;
        self.tokens -= if allowed { 1.0 } else { 0.0 };
        allowed
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
        assert_eq!((0..50).filter(|_| bucket.allows(now)).count(), 10);
        let later = now + Duration::from_millis(50);
        assert_eq!((0..50).filter(|_| bucket.allows(later)).count(), 5);
    }
}
