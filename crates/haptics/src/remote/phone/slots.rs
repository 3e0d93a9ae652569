//! Slots for connections: strangers cannot keep out a phone that was paired before.

use std::collections::VecDeque;
use std::net::{IpAddr, Shutdown, TcpStream};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Maximum number of connections (chosen: a page, a socket, and some stalled ones).
const MOST_CONNECTIONS: usize = 8;
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
    paired: bool,
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
    /// Makes room for a phone whose address was paired before: the longest waiting unpaired connection is closed, one of a
    /// stranger's address first.
    fn make_room(&mut self, address: IpAddr) {
        if self.connections.len() < MOST_CONNECTIONS || !self.known.contains(&address) {
            return;
        }
        let strange = |c: &Connection| !c.paired && !self.known.contains(&c.address);
        let found = self.connections.iter().position(strange);
        if let Some(victim) = found.or_else(|| self.connections.iter().position(|c| !c.paired)) {
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
        occupied.make_room(address);
        if occupied.connections.len() >= MOST_CONNECTIONS {
            return None;
        }
        let number = occupied.next;
        occupied.next += 1;
        occupied.connections.push(Connection { number, address, stream, paired: false });
        Some(Slot { slots: self.clone(), number, address })
    }

    fn lock(&self) -> MutexGuard<'_, Occupied> {
        // A list is whole even after a panic of another connection.
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Slot {
    /// Records that the connection's phone has given the code; its address is remembered.
    pub fn pair(&self) {
        let mut occupied = self.slots.lock();
        if let Some(own) = occupied.connections.iter_mut().find(|c| c.number == self.number) {
            own.paired = true;
        }
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
