//! The thread that listens for OSC, and to whom.

use std::net::{SocketAddr, UdpSocket};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use super::Heard;
use super::message::{LONGEST, Order, read};
use crate::open::{Access, OpenError, Reach};
use crate::remote::allowance::Allowance;
use crate::remote::network_thread::NetworkThread;
use crate::remote::pairing::{Pairing, Verdict};
use crate::remote::reachable::reachable;
use crate::remote::remote_pose::SILENCE_S;
use crate::remote::timeout::is_timeout;

/// How long a read waits before the thread looks whether it shall end (chosen: nobody notices).
const TURN: Duration = Duration::from_millis(20);
/// Senders that are paired at once; the oldest makes room (chosen: pan, turner, and one to spare).
const MOST_SENDERS: usize = 3;
/// Orders a second of all paired senders, and at once (chosen: three trackers at 120 Hz, twice over).
const FASTEST_HZ: f64 = 720.0;
const BURST: f64 = 240.0;
/// Orders a second of all others, and at once (chosen: the code, some times over, with what a sender tells before it is taken; a flood
/// of it leaves the paired ones' allowance alone).
const STRANGERS_HZ: f64 = 20.0;
const STRANGERS_BURST: f64 = 20.0;

/// A paired sender.
struct Sender {
    address: SocketAddr,
    heard: Instant,
    buttons: u32,
}

/// Listens to paired senders.
struct Listener {
    socket: UdpSocket,
    input: triple_buffer::Input<Heard>,
    heard: Heard,
    pairing: Pairing,
    paired: Vec<Sender>,
    allowance: Allowance,
    strangers: Allowance,
}

/// Listens at an address; tells what a person must know.
pub fn start(address: SocketAddr, input: triple_buffer::Input<Heard>) -> Result<(Access, NetworkThread), OpenError> {
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
    let listener = Listener::new(socket, input, pairing, Instant::now());
    let thread =
        NetworkThread::spawn("osc", move |end| listener.run(&end)).map_err(|e| failed(format!("no thread: {e}")))?;
    Ok((access, thread))
}

impl Listener {
    fn new(socket: UdpSocket, input: triple_buffer::Input<Heard>, pairing: Pairing, now: Instant) -> Self {
        Self {
            socket,
            input,
            heard: Heard::default(),
            pairing,
            paired: Vec::new(),
            allowance: Allowance::new(FASTEST_HZ, BURST, now),
            strangers: Allowance::new(STRANGERS_HZ, STRANGERS_BURST, now),
        }
    }

    fn run(mut self, end: &AtomicBool) {
        // One byte more than a datagram may have, so that longer ones are seen to be too long.
        let mut bytes = [0; LONGEST + 1];
        while !end.load(Ordering::Acquire) {
            match self.socket.recv_from(&mut bytes) {
                Ok((length, from)) => self.hear(&bytes[..length], from, Instant::now()),
                Err(e) if is_timeout(&e) => {}
                // It may stay so, as when the network's device is gone: asking again at once would only heat the machine.
                Err(_) => std::thread::sleep(TURN),
            }
            self.gather_buttons(Instant::now());
            self.input.write(self.heard);
        }
    }

    fn hear(&mut self, datagram: &[u8], from: SocketAddr, now: Instant) {
        // Before anything is read: a flood costs no more than its counting.
        if !self.takes(from, now) {
            return self.reject();
        }
        let Ok(orders) = read(datagram) else { return self.reject() };
        for (place, order) in orders.into_iter().enumerate() {
            match order {
                // The datagram has paid for its first order.
                _ if place > 0 && !self.takes(from, now) => self.reject(),
                Ok(Order::Pair(code)) => self.pair(&code, from, now),
                Ok(order) => self.obey(order, from, now),
                Err(_) => self.reject(),
            }
        }
    }

    /// Whether one more order may come from there now.
    fn takes(&mut self, from: SocketAddr, now: Instant) -> bool {
        let paired = self.paired.iter().any(|s| s.address == from);
        if paired { self.allowance.takes(now) } else { self.strangers.takes(now) }
    }

    fn reject(&mut self) {
        self.heard.rejected = self.heard.rejected.wrapping_add(1);
    }

    fn pair(&mut self, code: &str, from: SocketAddr, now: Instant) {
        if self.pairing.try_code(code, now) != Verdict::Paired {
            return self.reject();
        }
        if !self.paired.iter().any(|s| s.address == from) {
            if self.paired.len() >= MOST_SENDERS {
                self.paired.remove(0);
            }
            self.paired.push(Sender { address: from, heard: now, buttons: 0 });
        }
    }

    fn obey(&mut self, order: Order, from: SocketAddr, now: Instant) {
        let Some(sender) = self.paired.iter_mut().find(|s| s.address == from) else { return self.reject() };
        sender.heard = now;
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
            Order::Button(number, true) => sender.buttons |= 1 << number,
            Order::Button(number, false) => sender.buttons &= !(1 << number),
            Order::Pair(_) => {}
        }
    }

    /// All buttons that are down; a sender that is lost presses none, also when it speaks again.
    fn gather_buttons(&mut self, now: Instant) {
        for sender in &mut self.paired {
            if now.saturating_duration_since(sender.heard).as_secs_f64() > SILENCE_S {
                sender.buttons = 0;
            }
        }
        self.heard.buttons = self.paired.iter().fold(0, |all, sender| all | sender.buttons);
    }
}

#[cfg(test)]
mod tests {
    use rosc::{OscBundle, OscMessage, OscPacket, OscTime, OscType};

    use super::*;

    fn listener(now: Instant) -> Listener {
        let (input, _) = triple_buffer::triple_buffer(&Heard::default());
        Listener::new(
            UdpSocket::bind("127.0.0.1:0").expect("a port"),
            input,
            Pairing::new().expect("random numbers"),
            now,
        )
    }

    fn packet(address: &str, args: Vec<OscType>) -> OscPacket {
        OscPacket::Message(OscMessage { addr: address.into(), args })
    }

    fn bytes(packet: &OscPacket) -> Vec<u8> {
        rosc::encoder::encode(packet).expect("OSC")
    }

    fn tilt() -> OscPacket {
        packet("/saute/pan/tilt", vec![OscType::Float(10.0), OscType::Float(0.0)])
    }

    #[test]
    fn a_flood_of_strangers_leaves_a_paired_sender_s_allowance_alone() {
        let now = Instant::now();
        let mut listener = listener(now);
        let (friend, stranger) = (SocketAddr::from(([127, 0, 0, 1], 1)), SocketAddr::from(([127, 0, 0, 1], 2)));
        let pair = bytes(&packet("/saute/pair", vec![OscType::String(listener.pairing.code())]));
        listener.hear(&pair, friend, now);
        (0..5000).for_each(|_| listener.hear(&bytes(&tilt()), stranger, now));
        (0..100).for_each(|_| listener.hear(&bytes(&tilt()), friend, now));
        assert_eq!((listener.heard.pans, listener.heard.rejected), (100, 5000));
    }

    #[test]
    fn each_order_of_a_bundle_counts() {
        let now = Instant::now();
        let mut listener = listener(now);
        let friend = SocketAddr::from(([127, 0, 0, 1], 1));
        listener.hear(&bytes(&packet("/saute/pair", vec![OscType::String(listener.pairing.code())])), friend, now);
        let content = vec![tilt(); 20];
        let bundle = bytes(&OscPacket::Bundle(OscBundle { timetag: OscTime { seconds: 0, fractional: 1 }, content }));
        (0..12).for_each(|_| listener.hear(&bundle, friend, now));
        assert_eq!((listener.heard.pans, listener.heard.rejected), (240, 0), "twelve of twenty orders are the burst");
        listener.hear(&bundle, friend, now);
        assert_eq!((listener.heard.pans, listener.heard.rejected), (240, 1));
    }
}
