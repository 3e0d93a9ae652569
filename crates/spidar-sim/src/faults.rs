//! Simulated faults of the network: loss, delay, damage and silence.

use std::collections::VecDeque;
use std::net::SocketAddr;
use std::time::{Duration, Instant};

use crate::random::Random;

/// Active faults, and frames in transit.
#[derive(Debug)]
pub struct Faults {
    loss: f64,
    malformed: f64,
    delay: Duration,
    silent_until: Option<Instant>,
    random: Random,
    waiting: VecDeque<(Instant, SocketAddr, Vec<u8>)>,
}

impl Faults {
    /// Creates a network without faults.
    pub fn new(seed: u64) -> Self {
        Self {
            loss: 0.0,
            malformed: 0.0,
            delay: Duration::ZERO,
            silent_until: None,
            random: Random::seeded(seed ^ 0xfa17),
            waiting: VecDeque::new(),
        }
    }

    /// Switches a fault; returns false if the words name none.
    pub fn order(&mut self, words: &[&str], now: Instant) -> bool {
        let number = words.get(1).and_then(|w| w.parse::<f64>().ok()).filter(|v| (0.0..=3600e3).contains(v));
        match (words.first().copied(), number) {
            (Some("loss"), Some(share)) => self.loss = share,
            (Some("malformed"), Some(share)) => self.malformed = share,
            (Some("delay"), Some(ms)) => self.delay = Duration::from_secs_f64(ms * 1e-3),
            (Some("silence"), Some(s)) => self.silent_until = Some(now + Duration::from_secs_f64(s)),
            (Some("clear"), _) => (self.loss, self.malformed, self.delay) = (0.0, 0.0, Duration::ZERO),
            _ => return false,
        }
        true
    }

    /// Returns true while the cable is unplugged.
    pub fn is_silent(&self, now: Instant) -> bool {
        self.silent_until.is_some_and(|until| now < until)
    }

    /// Returns true if the next frame is lost.
    pub fn loses(&mut self, now: Instant) -> bool {
        self.is_silent(now) || self.random.happens(self.loss)
    }

    /// Sends an answer with the active faults.
    pub fn send(&mut self, to: SocketAddr, mut bytes: Vec<u8>, now: Instant) {
        if self.loses(now) {
            return;
        }
        if self.random.happens(self.malformed) {
            self.damage(&mut bytes);
        }
        self.waiting.push_back((now + self.delay, to, bytes));
    }

    /// Truncates, lengthens or corrupts a frame.
    fn damage(&mut self, bytes: &mut Vec<u8>) {
        let random = self.random.bits();
        let at = (random >> 8) as usize % bytes.len();
        match random % 3 {
            0 => bytes.truncate(at),
            1 => bytes.extend_from_within(..at),
            _ => bytes[at] ^= (random >> 40) as u8 | 1,
        }
    }

    /// Returns an answer whose delay has passed, with its recipient.
    pub fn arrived(&mut self, now: Instant) -> Option<(SocketAddr, Vec<u8>)> {
        let due = self.waiting.front().is_some_and(|(at, ..)| *at <= now);
        if due { self.waiting.pop_front().map(|(_, to, bytes)| (to, bytes)) } else { None }
    }
}
