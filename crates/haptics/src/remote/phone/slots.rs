//! Slots for connections: strangers cannot keep out a phone that was paired before.

use std::collections::VecDeque;
use std::net::{IpAddr, Shutdown, TcpStream};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Maximum number of connections (chosen: a page, a socket, and some stalled ones).
const MOST_CONNECTIONS: usize = 8;
/// Time in which a phone that has opened its socket sends its code (chosen: the page sends it at once; the slowest radio delays it less).
const PAIRING: Duration = Duration::from_secs(1);
/// Number of addresses of paired phones that are remembered (chosen: the phones of a class).
const MOST_KNOWN: usize = 32;

/// Occupied slots and the addresses of phones that were paired.
#[derive(Debug, Default)]
struct Occupied {
    connections: Vec<Connection>,
    known: VecDeque<IpAddr>,
    /// Number of the next connection.
    next: u64,
}

/// One connection, in the order of its beginning.
#[derive(Debug)]
struct Connection {
    number: u64,
    address: IpAddr,
    stream: TcpStream,
    /// When it has opened the socket of a phone; none before.
    asked: Option<Instant>,
    paired: bool,
}

impl Connection {
    /// Returns true if it may be closed for a phone that was paired before: it is not paired, and not just about to be.
    fn is_spare(&self, now: Instant) -> bool {
        !self.paired && self.asked.is_none_or(|at| now.saturating_duration_since(at) >= PAIRING)
    }
}

/// The slots of a server.
#[derive(Clone, Debug, Default)]
pub struct Slots(Arc<Mutex<Occupied>>);

/// One slot, released on drop.
#[derive(Debug)]
pub struct Slot {
    slots: Slots,
    number: u64,
    address: IpAddr,
}

impl Occupied {
    /// Makes room for a phone whose address was paired before: the longest waiting spare connection is closed, one of a
    /// stranger's address first.
    fn make_room(&mut self, address: IpAddr, now: Instant) {
        if self.connections.len() < MOST_CONNECTIONS || !self.known.contains(&address) {
            return;
        }
        let strange = |c: &Connection| c.is_spare(now) && !self.known.contains(&c.address);
        let found = self.connections.iter().position(strange);
        if let Some(victim) = found.or_else(|| self.connections.iter().position(|c| c.is_spare(now))) {
            // Its thread finds the stream closed and ends.
            let _ = self.connections.remove(victim).stream.shutdown(Shutdown::Both);
        }
    }
}

impl Slots {
    /// Takes a slot for a connection, if one is free or can be freed.
    pub fn take(&self, stream: &TcpStream) -> Option<Slot> {
        let (address, stream) = (stream.peer_addr().ok()?.ip(), stream.try_clone().ok()?);
        let mut occupied = self.lock();
        occupied.make_room(address, Instant::now());
        if occupied.connections.len() >= MOST_CONNECTIONS {
            return None;
        }
        let number = occupied.next;
        occupied.next += 1;
        occupied.connections.push(Connection { number, address, stream, asked: None, paired: false });
        Some(Slot { slots: self.clone(), number, address })
    }

    fn lock(&self) -> MutexGuard<'_, Occupied> {
        // A list is whole even after a panic of another connection.
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Slot {
    /// Records that the connection has opened a phone's socket.
    pub fn ask(&self) {
        self.change(|own| own.asked = Some(Instant::now()));
    }

    fn change(&self, change: impl FnOnce(&mut Connection)) {
        let mut occupied = self.slots.lock();
        if let Some(own) = occupied.connections.iter_mut().find(|c| c.number == self.number) {
            change(own);
        }
    }

    /// Records that the connection's phone has given the code; its address is remembered.
    pub fn pair(&self) {
        self.change(|own| own.paired = true);
        let mut occupied = self.slots.lock();
        occupied.known.retain(|known| *known != self.address);
        occupied.known.push_back(self.address);
        if occupied.known.len() > MOST_KNOWN {
            occupied.known.pop_front();
        }
    }
}

impl Drop for Slot {
    fn drop(&mut self) {
        self.slots.lock().connections.retain(|c| c.number != self.number);
    }
}

#[cfg(test)]
mod tests {
    use std::io::Read;
    use std::net::TcpListener;

    use super::*;

    /// Both ends of a connection, and its slot.
    fn connection(listener: &TcpListener, slots: &Slots) -> (TcpStream, TcpStream, Option<Slot>) {
        let far = TcpStream::connect(listener.local_addr().expect("an address")).expect("a connection");
        far.set_read_timeout(Some(Duration::from_secs(60))).expect("a timeout");
        let (near, _) = listener.accept().expect("the other end");
        let slot = slots.take(&near);
        (far, near, slot)
    }

    #[test]
    fn a_phone_that_is_about_to_send_its_code_and_a_paired_one_are_not_closed_for_another() {
        let (listener, slots) = (TcpListener::bind("127.0.0.1:0").expect("a port"), Slots::default());
        let all: Vec<_> = (0..MOST_CONNECTIONS).map(|_| connection(&listener, &slots)).collect();
        let slot = |k: usize| all[k].2.as_ref().expect("a free slot");
        slot(0).pair();
        slot(1).ask();
        let (.., more) = connection(&listener, &slots);
        assert!(more.is_some(), "its address is known");
        let mut closed = &all[2].0;
        assert_eq!(closed.read(&mut [0]).expect("the end"), 0, "the one that waits longest has made room");
        let kept: Vec<u64> = slots.lock().connections.iter().map(|c| c.number).collect();
        assert_eq!(kept, [0, 1, 3, 4, 5, 6, 7, 8]);
    }

    #[test]
    fn a_socket_without_a_code_is_spare_after_a_second() {
        let (listener, slots) = (TcpListener::bind("127.0.0.1:0").expect("a port"), Slots::default());
        let (_far, _near, slot) = connection(&listener, &slots);
        slot.as_ref().expect("a slot").ask();
        let occupied = slots.lock();
        let (own, now) = (&occupied.connections[0], Instant::now());
        assert_eq!((own.is_spare(now), own.is_spare(now + PAIRING)), (false, true));
        drop(occupied);
    }
}
