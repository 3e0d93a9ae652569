//! The thread that listens for OSC, and to whom.

use std::net::{SocketAddr, UdpSocket};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use super::Heard;
use super::message::{LONGEST, Order, read};
use crate::allowance::Allowance;
use crate::open::{Access, OpenError, Reach};
use crate::pairing::{Pairing, Verdict};
use crate::reachable::reachable;

/// How long a read waits before the thread looks whether it shall end (chosen).
const TURN: Duration = Duration::from_millis(50);
/// Senders that are paired at once; the oldest makes room (chosen: pan, turner, and one to spare).
const MOST_SENDERS: usize = 3;
/// Messages a second of all senders, and at once (chosen: three trackers at 120 Hz, twice over).
const FASTEST_HZ: f64 = 720.0;
const BURST: f64 = 240.0;

/// Listens to paired senders.
struct Listener {
    socket: UdpSocket,
    input: triple_buffer::Input<Heard>,
    end: Arc<AtomicBool>,
    heard: Heard,
    pairing: Pairing,
    paired: Vec<SocketAddr>,
    allowance: Allowance,
}

/// Listens at an address; tells what a person must know.
pub fn start(
    address: SocketAddr,
    input: triple_buffer::Input<Heard>,
    end: Arc<AtomicBool>,
) -> Result<Access, OpenError> {
    let failed = |message: String| OpenError::place(address, message, "name another port: osc@HOST:PORT");
    let socket = UdpSocket::bind(address).map_err(|e| failed(format!("cannot be listened at: {e}")))?;
    let bound = socket.local_addr().map_err(|e| failed(e.to_string()))?;
    socket.set_read_timeout(Some(TURN)).map_err(|e| failed(e.to_string()))?;
    let pairing = Pairing::new().map_err(|e| failed(e.to_string()))?;
    let access = Access {
        place: SocketAddr::new(reachable(bound.ip()), bound.port()).to_string(),
        reach: Reach::of(bound),
        url: None,
        code: Some(pairing.code()),
        fingerprint: None,
    };
    let allowance = Allowance::new(FASTEST_HZ, BURST, Instant::now());
    let listener = Listener { socket, input, end, heard: Heard::default(), pairing, paired: Vec::new(), allowance };
    let spawned = std::thread::Builder::new().name("osc".into()).spawn(move || listener.run());
    spawned.map_err(|e| failed(format!("no thread: {e}")))?;
    Ok(access)
}

impl Listener {
    fn run(mut self) {
        // One byte more than a datagram may have, so that longer ones are seen to be too long.
        let mut bytes = [0; LONGEST + 1];
        while !self.end.load(Ordering::Acquire) {
            let Ok((length, from)) = self.socket.recv_from(&mut bytes) else { continue };
            self.hear(&bytes[..length], from);
            self.input.write(self.heard);
        }
    }

    fn hear(&mut self, datagram: &[u8], from: SocketAddr) {
        if !self.allowance.takes(Instant::now()) {
            return self.reject();
        }
        match read(datagram) {
            Ok(orders) => orders.into_iter().for_each(|order| match order {
                Ok(Order::Pair(code)) => self.pair(&code, from),
                Ok(order) if self.paired.contains(&from) => self.obey(order),
                _ => self.reject(),
            }),
            Err(_) => self.reject(),
        }
    }

    fn reject(&mut self) {
        self.heard.rejected = self.heard.rejected.wrapping_add(1);
    }

    fn pair(&mut self, code: &str, from: SocketAddr) {
        if self.pairing.try_code(code, Instant::now()) != Verdict::Paired {
            return self.reject();
        }
        if !self.paired.contains(&from) {
            if self.paired.len() >= MOST_SENDERS {
                self.paired.remove(0);
            }
            self.paired.push(from);
        }
    }

    fn obey(&mut self, order: Order) {
        let heard = &mut self.heard;
        match order {
            Order::Pan(pose) => {
                (heard.place, heard.rotation) = (Some(pose.position), pose.rotation);
                heard.pans += 1;
            }
            Order::Tilt(rotation) => {
                (heard.place, heard.rotation) = (None, rotation);
                heard.pans += 1;
            }
            Order::Turner(pose) => {
                heard.turner = pose;
                heard.turners += 1;
            }
            Order::Button(number, true) => heard.buttons |= 1 << number,
            Order::Button(number, false) => heard.buttons &= !(1 << number),
            Order::Pair(_) => {}
        }
    }
}
