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
    /// Number of the session; 0 before the first one.
    number: u32,
    is_begun: bool,
    /// Sequence number of the last frame sent; it continues from session to session.
    sent: u32,
    /// Sequence number of the last frame accepted in this session.
    received: Option<u32>,
}

impl Session {
    /// Creates the state before the first session.
    pub fn new() -> Self {
        Self { random: SystemRandom::new(), number: 0, is_begun: false, sent: 0, received: None }
    }

    /// Begins a session with a new random number, which is never 0.
    pub fn begin(&mut self) -> Result<(), NoRandom> {
        let mut number = [0; 4];
        while number == [0; 4] {
            self.random.fill(&mut number).map_err(|_| NoRandom)?;
        }
        (self.number, self.is_begun, self.received) = (u32::from_le_bytes(number), true, None);
        Ok(())
    }

    /// Ends the session: only its stops are still sent. Returns false if none had begun.
    pub fn end(&mut self) -> bool {
        std::mem::take(&mut self.is_begun)
    }

    /// Returns the session's number.
    pub fn number(&self) -> u32 {
        self.number
    }

    /// Returns the sequence number of the next frame to send; after the largest one comes 1.
    pub fn next_sequence(&mut self) -> u32 {
        self.sent = self.sent.wrapping_add(1).max(1);
        self.sent
    }

    /// Accepts a frame of this session that is newer than all before it; returns false for any other.
    pub fn accept(&mut self, frame: &Frame) -> bool {
        let newer = self.received.is_none_or(|last| (frame.sequence.wrapping_sub(last) as i32) > 0);
        let own = frame.session == self.number && self.number != 0;
        let accepted = own && newer;
        if accepted {
            self.received = Some(frame.sequence);
        }
        accepted
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::strings::wire::Message;

    #[test]
    fn numbers_wrap_around_zero() {
        let mut session = Session { sent: u32::MAX - 1, ..Session::new() };
        assert_eq!([session.next_sequence(), session.next_sequence(), session.next_sequence()], [u32::MAX, 1, 2]);
    }

    #[test]
    fn nothing_is_accepted_in_session_zero_but_a_frame_with_number_zero_is() {
        let mut session = Session::new();
        assert!(!session.accept(&Frame { sequence: 5, session: 0, message: Message::Arm }));
        session.begin().expect("random numbers");
        assert!(session.accept(&Frame { sequence: 0, session: session.number(), message: Message::Arm }));
    }
}
