//! Why messages are rejected: reported once on the screen, and again and again, but seldom, to the sender.

use std::net::SocketAddr;
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::time::{Duration, Instant};

use super::message::BadOsc;

/// Shortest time between two answers with the same reason (chosen: a person reads no faster, and a flood gets no echo).
const AGAIN: Duration = Duration::from_secs(1);
/// Number of reasons that wait to be shown (chosen: all that there are, twice).
const MOST_WAITING: usize = 64;

/// Why a message is rejected.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Rejection {
    /// It is invalid.
    #[error(transparent)]
    Bad(#[from] BadOsc),
    /// Its sender is not paired.
    #[error("the sender is not paired: send /saute/pair with the code on the screen first, from the same port")]
    NotPaired,
    /// The code is wrong, or came too soon after a wrong one.
    #[error("the code is wrong or came too soon after a wrong one: send the code on the screen after {0:.0} s")]
    WrongCode(f64),
    /// Too many codes were wrong.
    #[error("too many codes were wrong: restart saute")]
    Closed,
    /// There were too many messages.
    #[error("there are too many messages: send at most {0:.0} per second")]
    TooFast(f64),
}

impl Rejection {
    /// Returns what distinguishes this reason from others, without what varies from message to message.
    fn kind(&self) -> (u8, &'static str) {
        match self {
            Self::Bad(BadOsc::Format) => (0, ""),
            Self::Bad(BadOsc::Long) => (1, ""),
            Self::Bad(BadOsc::Many) => (2, ""),
            Self::Bad(BadOsc::Address(_)) => (3, ""),
            Self::Bad(BadOsc::Arguments(address, _)) => (4, address),
            Self::Bad(BadOsc::NotFinite(address)) => (5, address),
            Self::Bad(BadOsc::Range(address, _)) => (6, address),
            Self::NotPaired => (7, ""),
            Self::WrongCode(_) => (8, ""),
            Self::Closed => (9, ""),
            Self::TooFast(_) => (10, ""),
        }
    }
}

/// The reasons so far.
#[derive(Debug)]
pub struct Rejections {
    /// Kinds of reasons, and when each was reported last.
    told: Vec<((u8, &'static str), Instant)>,
    screen: SyncSender<String>,
}

impl Rejections {
    /// Creates an empty list, and the receiver of the lines for the screen.
    pub fn new() -> (Self, Receiver<String>) {
        let (screen, lines) = sync_channel(MOST_WAITING);
        (Self { told: Vec::new(), screen }, lines)
    }

    /// Reports a reason that is new on the screen; returns true if it should be reported to the sender, too.
    pub fn tell(&mut self, why: &Rejection, from: SocketAddr, now: Instant) -> bool {
        let kind = why.kind();
        if let Some((_, at)) = self.told.iter_mut().find(|(told, _)| *told == kind) {
            let due = now.saturating_duration_since(*at) >= AGAIN;
            *at = if due { now } else { *at };
            return due;
        }
        self.told.push((kind, now));
        // Where nobody reads the lines, the answer to the sender remains.
        let _ = self.screen.try_send(format!("rejected a message from {from}: {why}"));
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_reason_is_shown_once_and_answered_once_per_second() {
        let (mut rejections, lines) = Rejections::new();
        let (from, now) = (SocketAddr::from(([127, 0, 0, 1], 9)), Instant::now());
        let mut answers = 0;
        for ms in 0..5000 {
            let why = BadOsc::Address(format!("/{ms}")).into();
            answers += u32::from(rejections.tell(&why, from, now + Duration::from_millis(ms)));
        }
        assert_eq!(answers, 5);
        assert!(rejections.tell(&BadOsc::NotFinite("/saute/button").into(), from, now));
        assert!(rejections.tell(&BadOsc::NotFinite("/saute/pair").into(), from, now), "another address");
        let lines: Vec<String> = lines.try_iter().collect();
        assert!(lines.len() == 3 && lines[0].contains("127.0.0.1:9: /0 is no address"), "{lines:?}");
    }
}
