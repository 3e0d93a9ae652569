//! The session with a host: to whom the device listens, for how long, and which frames it has seen.

use std::net::SocketAddr;
use std::time::{Duration, Instant};

/// Time after the last frame of its host at which a session ends (chosen: a host that restarts is back sooner).
pub const LASTS: Duration = Duration::from_secs(1);
/// Number of ended sessions that are remembered (chosen: a delayed hello is not older than the last few).
const REMEMBERED: usize = 8;

/// A session.
#[derive(Clone, Copy, Debug)]
pub struct Session {
    /// Address of the host that sent the hello.
    pub host: SocketAddr,
    /// Number that the host drew.
    pub number: u32,
    /// Sequence number of the last accepted frame.
    sequence: u32,
    /// Time of the last accepted frame.
    heard: Instant,
}

/// Numbers of the last sessions, so that a delayed hello begins none of them again.
#[derive(Clone, Copy, Debug, Default)]
pub struct Past {
    numbers: [Option<u32>; REMEMBERED],
    next: usize,
}

impl Session {
    /// Begins a session with an accepted hello.
    pub fn begin(host: SocketAddr, number: u32, sequence: u32, now: Instant) -> Self {
        Self { host, number, sequence, heard: now }
    }

    /// Returns true if a frame comes from this session's host and names this session.
    pub fn owns(&self, from: SocketAddr, number: u32) -> bool {
        self.host == from && self.number == number
    }

    /// Accepts a frame that is newer than all before it; returns false for a repeated or overtaken one.
    pub fn accept(&mut self, sequence: u32, now: Instant) -> bool {
        let newer = (sequence.wrapping_sub(self.sequence) as i32) > 0;
        if newer {
            (self.sequence, self.heard) = (sequence, now);
        }
        newer
    }

    /// Returns the time until the session ends if its host stays silent; zero if it has ended.
    pub fn left(&self, now: Instant) -> Duration {
        (self.heard + LASTS).saturating_duration_since(now)
    }
}

impl Past {
    /// Remembers a session that has begun.
    pub fn note(&mut self, number: u32) {
        self.numbers[self.next] = Some(number);
        self.next = (self.next + 1) % REMEMBERED;
    }

    /// Returns true if a session was among the last ones.
    pub fn knows(&self, number: u32) -> bool {
        self.numbers.contains(&Some(number))
    }
}
