//! The session with a device: its random number, and the sequence numbers of both sides.

use ring::rand::{SecureRandom, SystemRandom};

use crate::strings::wire::Frame;

/// The system provided no random numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the system provided no random numbers for a session")]
pub struct NoRandom;

/// A session; strangers who cannot read the link cannot guess its number.
#[derive(Debug)]
pub struct Session {
    random: SystemRandom,
    number: u32,
    /// Sequence number of the last frame sent; it continues from session to session.
    sent: u32,
    /// Sequence number of the last frame accepted in this session.
    received: Option<u32>,
}

impl Session {
    /// Creates the state before the first session.
    pub fn new() -> Self {
        Self { random: SystemRandom::new(), number: 0, sent: 0, received: None }
    }

    /// Begins a session with a new random number.
    pub fn begin(&mut self) -> Result<(), NoRandom> {
        let mut number = [0; 4];
        self.random.fill(&mut number).map_err(|_| NoRandom)?;
        (self.number, self.received) = (u32::from_le_bytes(number), None);
        Ok(())
    }

    /// Returns the session's number.
    pub fn number(&self) -> u32 {
        self.number
    }

    /// Returns the sequence number of the next frame to send.
    pub fn next_sequence(&mut self) -> u32 {
        self.sent = self.sent.wrapping_add(1);
        self.sent
    }

    /// Accepts a frame of this session that is newer than all before it; returns false for any other.
    pub fn accept(&mut self, frame: &Frame) -> bool {
        let newer = self.received.is_none_or(|last| (frame.sequence.wrapping_sub(last) as i32) > 0);
        let accepted = frame.session == self.number && newer;
        if accepted {
            self.received = Some(frame.sequence);
        }
        accepted
    }
}
