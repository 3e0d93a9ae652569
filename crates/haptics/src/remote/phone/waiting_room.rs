//! Connections that have sent nothing yet: they take no slot from a phone, and no thread.
//!
//! Browsers open connections that they may need later, and port scanners open many; none of them may cost a phone its place.

use std::collections::VecDeque;
use std::io;
use std::net::TcpStream;
use std::time::{Duration, Instant};

use crate::remote::timeout::is_timeout;

/// Maximum number of silent connections (chosen: eight times the slots; each costs a file handle only).
const MOST: usize = 64;
/// Longest silence of a new connection (chosen: as long as a request may take).
const PATIENCE: Duration = Duration::from_secs(5);

/// A connection that the room can wait for.
pub trait Visitor {
    /// Returns `true` if there is something to read, `false` if not, and an error if the connection is closed.
    fn has_spoken(&self) -> io::Result<bool>;
}

impl Visitor for TcpStream {
    fn has_spoken(&self) -> io::Result<bool> {
        match self.peek(&mut [0]) {
            Ok(0) => Err(io::ErrorKind::UnexpectedEof.into()),
            Ok(_) => Ok(true),
            Err(e) if is_timeout(&e) => Ok(false),
            Err(e) => Err(e),
        }
    }
}

/// Silent connections, the longest waiting first.
#[derive(Debug)]
pub struct WaitingRoom<V>(VecDeque<(V, Instant)>);

impl<V: Visitor> WaitingRoom<V> {
    /// Creates an empty room.
    pub fn new() -> Self {
        Self(VecDeque::new())
    }

    /// Lets a connection wait; if the room is full, the longest waiting one is closed. A phone sends as soon as it is connected, so it
    /// is never that one.
    pub fn admit(&mut self, visitor: V, now: Instant) {
        if self.0.len() >= MOST {
            self.0.pop_front();
        }
        self.0.push_back((visitor, now));
    }

    /// Returns the connections that have spoken; those that are closed or were silent for too long are dropped.
    pub fn spoken(&mut self, now: Instant) -> Vec<V> {
        let mut spoken = Vec::new();
        for (visitor, since) in std::mem::take(&mut self.0) {
            match visitor.has_spoken() {
                Ok(true) => spoken.push(visitor),
                Ok(false) if now.saturating_duration_since(since) < PATIENCE => self.0.push_back((visitor, since)),
                Ok(false) | Err(_) => {}
            }
        }
        spoken
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;
    use std::rc::Rc;

    use super::*;

    /// A visitor that sends when the test requires it; its count falls when it is closed.
    struct Guest {
        number: usize,
        speaker: Rc<Cell<Option<usize>>>,
        _open: Rc<()>,
    }

    /// Speaker, count of open connections, and the beginning.
    type Hall = (Rc<Cell<Option<usize>>>, Rc<()>, Instant);

    fn hall() -> Hall {
        (Rc::default(), Rc::new(()), Instant::now())
    }

    fn guests(room: &mut WaitingRoom<Guest>, count: usize, (speaker, open, now): &Hall) {
        for number in 0..count {
            room.admit(Guest { number, speaker: Rc::clone(speaker), _open: Rc::clone(open) }, *now);
        }
    }

    impl Visitor for Guest {
        fn has_spoken(&self) -> io::Result<bool> {
            Ok(self.speaker.get() == Some(self.number))
        }
    }

    #[test]
    fn the_room_is_bounded_and_the_newest_visitors_stay() {
        let (hall, mut room) = (hall(), WaitingRoom::new());
        guests(&mut room, 1000, &hall);
        assert_eq!((room.0.len(), Rc::strong_count(&hall.1)), (MOST, MOST + 1), "the others are closed");
        hall.0.set(Some(999));
        assert!(room.spoken(hall.2).iter().map(|guest| guest.number).eq([999]));
    }

    #[test]
    fn a_silent_visitor_is_closed_after_five_seconds_and_one_that_speaks_in_time_is_served() {
        let (hall, mut room) = (hall(), WaitingRoom::new());
        guests(&mut room, 2, &hall);
        assert!(room.spoken(hall.2 + Duration::from_millis(4900)).is_empty());
        hall.0.set(Some(1));
        assert_eq!(room.spoken(hall.2 + Duration::from_millis(5000)).len(), 1);
        assert_eq!((room.0.len(), Rc::strong_count(&hall.1)), (0, 1));
    }
}
