//! The OSC listener: a thread that receives datagrams of paired senders.

use std::net::{SocketAddr, UdpSocket};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::Receiver;
use std::time::{Duration, Instant};

use super::Incoming;
use super::message::{BadOsc, Event, LONGEST, REJECTED, read};
use super::rejections::{Rejection, Rejections};
use rosc::{OscMessage, OscPacket, OscType};

use crate::open::{Access, OpenError, Reach};
use crate::remote::allowance::Allowance;
use crate::remote::network_thread::NetworkThread;
use crate::remote::pairing::{Admission, Pairing};
use crate::remote::reachable::reachable;
use crate::remote::remote_pose::SILENCE_S;
use crate::remote::timeout::is_timeout;

/// Read timeout, after which the thread checks for its end (chosen: imperceptible).
const READ_TIMEOUT: Duration = Duration::from_millis(20);
/// Maximum number of paired senders; a new one replaces the oldest (chosen: pan, turner, and a spare).
const MOST_SENDERS: usize = 3;
/// Maximum message rate of all paired senders together [Hz] (chosen: twice three trackers at 120 Hz).
const FASTEST_HZ: f64 = 720.0;
/// Maximum burst of all paired senders (chosen: a third of a second's messages, delayed by the network).
const BURST: f64 = 240.0;
/// Maximum message rate of all unpaired senders together [Hz] (chosen: several pairing attempts; a flood cannot use up the allowance of
/// paired senders).
const STRANGERS_HZ: f64 = 20.0;
/// Maximum burst of all unpaired senders (chosen: a second's messages).
const STRANGERS_BURST: f64 = 20.0;

/// A paired sender.
struct Sender {
    address: SocketAddr,
    received: Instant,
    buttons: u32,
}

/// Receives messages of paired senders.
struct Listener {
    socket: UdpSocket,
    input: triple_buffer::Input<Incoming>,
    incoming: Incoming,
    pairing: Pairing,
    paired: Vec<Sender>,
    allowance: Allowance,
    strangers: Allowance,
    rejections: Rejections,
}

/// A running listener.
pub struct Started {
    /// How a person reaches it.
    pub access: Access,
    /// Its thread.
    pub thread: NetworkThread,
    /// Why messages were rejected, a line for each reason.
    pub notices: Receiver<String>,
}

/// Starts the listener at an address.
pub fn start(address: SocketAddr, input: triple_buffer::Input<Incoming>) -> Result<Started, OpenError> {
    let failed = |message: String| OpenError::place(address, message, "name another port: osc@HOST:PORT");
    let socket = UdpSocket::bind(address).map_err(|e| failed(format!("cannot be bound: {e}")))?;
    let bound = socket.local_addr().map_err(|e| failed(e.to_string()))?;
    socket.set_read_timeout(Some(READ_TIMEOUT)).map_err(|e| failed(e.to_string()))?;
    let pairing = Pairing::new().map_err(|e| failed(e.to_string()))?;
    let access = Access {
        place: SocketAddr::new(reachable(bound.ip()), bound.port()).to_string(),
        reach: Reach::of(bound),
        url: None,
        code: Some(pairing.code()),
        fingerprint: None,
    };
    let (rejections, notices) = Rejections::new();
    let listener = Listener::new(socket, input, pairing, rejections, Instant::now());
    let thread =
        NetworkThread::spawn("osc", move |end| listener.run(&end)).map_err(|e| failed(format!("no thread: {e}")))?;
    Ok(Started { access, thread, notices })
}

impl Listener {
    fn new(
        socket: UdpSocket,
        input: triple_buffer::Input<Incoming>,
        pairing: Pairing,
        rejections: Rejections,
        now: Instant,
    ) -> Self {
        Self {
            socket,
            input,
            incoming: Incoming::default(),
            pairing,
            paired: Vec::new(),
            allowance: Allowance::new(FASTEST_HZ, BURST, now),
            strangers: Allowance::new(STRANGERS_HZ, STRANGERS_BURST, now),
            rejections,
        }
    }

    fn run(mut self, end: &AtomicBool) {
        // One byte more than the longest datagram, so that longer ones are detected.
        let mut bytes = [0; LONGEST + 1];
        while !end.load(Ordering::Acquire) {
            match self.socket.recv_from(&mut bytes) {
                Ok((length, from)) => self.receive(&bytes[..length], from, Instant::now()),
                Err(e) if is_timeout(&e) => {}
                // The error may persist, such as after the loss of a network interface: retry slowly.
                Err(_) => std::thread::sleep(READ_TIMEOUT),
            }
            self.gather_buttons(Instant::now());
            self.input.write(self.incoming);
        }
    }

    fn receive(&mut self, datagram: &[u8], from: SocketAddr, now: Instant) {
        // Checked before parsing: a flood costs no more than its counting.
        if let Err(why) = self.allows(from, now) {
            return self.reject(&why, from, now);
        }
        let events = match read(datagram) {
            Ok(events) => events,
            Err(why) => return self.reject(&why.into(), from, now),
        };
        for (place, event) in events.into_iter().enumerate() {
            // The datagram's token pays for its first message.
            let allowed = if place > 0 { self.allows(from, now) } else { Ok(()) };
            let taken = allowed.and_then(|()| self.take(event?, from, now));
            if let Err(why) = taken {
                self.reject(&why, from, now);
            }
        }
    }

    fn is_paired(&self, from: SocketAddr) -> bool {
        self.paired.iter().any(|s| s.address == from)
    }

    /// Takes a token for one more message of a sender.
    fn allows(&mut self, from: SocketAddr, now: Instant) -> Result<(), Rejection> {
        let (bucket, most) = match self.is_paired(from) {
            true => (&mut self.allowance, FASTEST_HZ),
            false => (&mut self.strangers, STRANGERS_HZ),
        };
        if bucket.allows(now) { Ok(()) } else { Err(Rejection::TooFast(most)) }
    }

    fn take(&mut self, event: Event, from: SocketAddr, now: Instant) -> Result<(), Rejection> {
        match event {
            Event::Pair(code) => self.pair(&code, from, now),
            event => self.apply(event, from, now),
        }
    }

    /// Counts a rejected message and states why, seldom enough that no flood gets an echo.
    fn reject(&mut self, why: &Rejection, from: SocketAddr, now: Instant) {
        self.incoming.rejected = self.incoming.rejected.wrapping_add(1);
        let told = self.rejections.tell(why, from, now);
        // What is not OSC has no sender that reads OSC; a stranger's flood and the answer of another listener get none.
        let unanswered = match why {
            Rejection::Bad(BadOsc::Format) => true,
            Rejection::Bad(BadOsc::Address(address)) => address == REJECTED,
            Rejection::TooFast(_) => !self.is_paired(from),
            _ => false,
        };
        if told && !unanswered {
            self.answer(why, from);
        }
    }

    fn answer(&self, why: &Rejection, to: SocketAddr) {
        let args = vec![OscType::String(why.to_string())];
        let packet = OscPacket::Message(OscMessage { addr: REJECTED.into(), args });
        if let Ok(bytes) = rosc::encoder::encode(&packet) {
            // A sender that does not listen misses nothing that the screen does not show.
            let _ = self.socket.send_to(&bytes, to);
        }
    }

    fn pair(&mut self, code: &str, from: SocketAddr, now: Instant) -> Result<(), Rejection> {
        match self.pairing.try_code(code, now) {
            Admission::Paired => {}
            Admission::Wait(wait) => return Err(Rejection::WrongCode(wait.as_secs_f64().ceil())),
            Admission::Closed => return Err(Rejection::Closed),
        }
        if !self.is_paired(from) {
            if self.paired.len() >= MOST_SENDERS {
                self.paired.remove(0);
            }
            self.paired.push(Sender { address: from, received: now, buttons: 0 });
        }
        Ok(())
    }

    fn apply(&mut self, event: Event, from: SocketAddr, now: Instant) -> Result<(), Rejection> {
        let sender = self.paired.iter_mut().find(|s| s.address == from).ok_or(Rejection::NotPaired)?;
        sender.received = now;
        let incoming = &mut self.incoming;
        match event {
            Event::Pan(pose) => {
                (incoming.place, incoming.rotation) = (Some(pose.position), pose.rotation);
                incoming.pans += 1;
            }
            Event::Tilt(rotation) => {
                (incoming.place, incoming.rotation) = (None, rotation);
                incoming.pans += 1;
            }
            Event::Turner(pose) => {
                incoming.turner = pose;
                incoming.turners += 1;
            }
            Event::Button(number, true) => sender.buttons |= 1 << number,
            Event::Button(number, false) => sender.buttons &= !(1 << number),
            Event::Pair(_) => {}
        }
        Ok(())
    }

    /// Collects all pressed buttons; those of a lost sender are released and stay released when it returns.
    fn gather_buttons(&mut self, now: Instant) {
        for sender in &mut self.paired {
            if now.saturating_duration_since(sender.received).as_secs_f64() > SILENCE_S {
                sender.buttons = 0;
            }
        }
        self.incoming.buttons = self.paired.iter().fold(0, |all, sender| all | sender.buttons);
    }
}

#[cfg(test)]
mod tests {
    use rosc::{OscBundle, OscTime};

    use super::*;

    fn listener(now: Instant) -> Listener {
        let (input, _) = triple_buffer::triple_buffer(&Incoming::default());
        Listener::new(
            UdpSocket::bind("127.0.0.1:0").expect("a port"),
            input,
            Pairing::new().expect("random numbers"),
            Rejections::new().0,
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
        listener.receive(&pair, friend, now);
        (0..5000).for_each(|_| listener.receive(&bytes(&tilt()), stranger, now));
        (0..100).for_each(|_| listener.receive(&bytes(&tilt()), friend, now));
        assert_eq!((listener.incoming.pans, listener.incoming.rejected), (100, 5000));
    }

    #[test]
    fn each_message_of_a_bundle_counts() {
        let now = Instant::now();
        let mut listener = listener(now);
        let friend = SocketAddr::from(([127, 0, 0, 1], 1));
        listener.receive(&bytes(&packet("/saute/pair", vec![OscType::String(listener.pairing.code())])), friend, now);
        let content = vec![tilt(); 20];
        let bundle = bytes(&OscPacket::Bundle(OscBundle { timetag: OscTime { seconds: 0, fractional: 1 }, content }));
        (0..12).for_each(|_| listener.receive(&bundle, friend, now));
        assert_eq!(
            (listener.incoming.pans, listener.incoming.rejected),
            (240, 0),
            "twelve bundles of twenty messages are the burst"
        );
        listener.receive(&bundle, friend, now);
        assert_eq!((listener.incoming.pans, listener.incoming.rejected), (240, 1));
    }
}
