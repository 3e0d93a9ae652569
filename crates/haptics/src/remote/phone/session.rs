//! A session with one phone: first its pairing code, then its motion; back go the pan's pose and rumble.

use std::io::ErrorKind;
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

use glam::DQuat;
use tungstenite::protocol::{Role, WebSocketConfig};
use tungstenite::{Error, Message, WebSocket};

use super::message::{FromPhone, LONGEST, Measured, ToPhone};
use super::orientation::{Level, acceleration, from_angles};
use super::server::{Shared, TlsStream, WRITE_TIMEOUT};
use super::slots::Slot;
use crate::remote::allowance::Allowance;
use crate::remote::pairing::Admission;
use crate::remote::remote_pose::SILENCE_S;
use crate::remote::timeout::is_timeout;

/// Timeout of pairing (chosen: the page connects after the code was typed; a longer wait would only occupy a slot).
const PAIRING: Duration = Duration::from_secs(5);
/// Timeout of one message (chosen: three reports; endless empty fragments would otherwise block the thread).
const MESSAGE_TIMEOUT: Duration = Duration::from_millis(100);
/// Interval between two reports to the phone (chosen: thirty per second look smooth).
const REPORT_INTERVAL: Duration = Duration::from_millis(33);
/// Maximum message rate; further messages are rejected [Hz] (chosen: three times the page's rate).
const FASTEST_HZ: f64 = 180.0;
/// Maximum burst of messages (chosen: a second's messages, delayed by the radio).
const BURST: f64 = 60.0;
/// Number of consecutive rejected messages that ends the session (chosen: the page never reaches it).
const MOST_BAD: u32 = 500;

/// A session.
struct Session<'a> {
    socket: WebSocket<TlsStream>,
    shared: &'a Shared,
    slot: &'a Slot,
    number: Option<u64>,
    level: Level,
    phone: DQuat,
    allowance: Allowance,
    bad: u32,
    pressed: bool,
    received: Instant,
    reported: Instant,
}

/// Runs the session until one side ends it.
pub fn run(stream: TlsStream, shared: &Shared, slot: &Slot) {
    let config = WebSocketConfig::default()
        .max_message_size(Some(LONGEST))
        .max_frame_size(Some(LONGEST))
        .max_write_buffer_size(1 << 20);
    let now = Instant::now();
    let mut session = Session {
        socket: WebSocket::from_raw_socket(stream, Role::Server, Some(config)),
        shared,
        slot,
        number: None,
        level: Level::default(),
        phone: DQuat::IDENTITY,
        allowance: Allowance::new(FASTEST_HZ, BURST, now),
        bad: 0,
        pressed: false,
        received: now,
        reported: now,
    };
    while session.step(now) {}
    session.leave();
}

impl Session<'_> {
    /// Handles one message or one timeout; returns false at the end of the session.
    fn step(&mut self, begun: Instant) -> bool {
        self.socket.get_mut().sock.allow(MESSAGE_TIMEOUT);
        let on = match self.socket.read() {
            Ok(Message::Text(text)) => self.receive(&text),
            Ok(Message::Binary(_)) => self.reject(),
            Ok(Message::Close(_)) => false,
            Ok(_) => self.allowance.allows(Instant::now()) || self.reject(),
            Err(Error::Io(e)) => is_timeout(&e),
            Err(Error::Capacity(_) | Error::Protocol(_) | Error::Utf8(_)) => {
                self.reject();
                false
            }
            Err(_) => false,
        };
        self.release_after_silence();
        let paired_in_time = self.number.is_some() || begun.elapsed() < PAIRING;
        on && paired_in_time && self.bad < MOST_BAD && self.is_current() && self.report()
    }

    /// Returns true if the device is open and no other phone has taken over.
    fn is_current(&mut self) -> bool {
        if self.shared.end.load(Ordering::Acquire) {
            return false;
        }
        let replaced = self.number.is_some_and(|n| n != self.shared.holder.load(Ordering::Acquire));
        if replaced {
            self.send(&ToPhone::Replaced);
        }
        !replaced
    }

    fn receive(&mut self, text: &str) -> bool {
        let now = Instant::now();
        if !self.allowance.allows(now) {
            return self.reject();
        }
        // Before the message ends the silence: else a phone that returns quickly would press again.
        self.release_after_silence();
        match (FromPhone::parse(text), self.number) {
            (Ok(FromPhone::Hello { code }), None) => return self.pair(&code, now),
            (Ok(FromPhone::Motion(measured)), Some(_)) => self.move_pan(&measured),
            (Ok(FromPhone::Flat {}), Some(_)) => {
                let taken = self.level.set(self.phone);
                return self.send(&ToPhone::Flat { taken });
            }
            (Ok(FromPhone::Button { down }), Some(_)) => self.press(down),
            _ => return self.reject(),
        }
        (self.bad, self.received) = (0, now);
        true
    }

    fn pair(&mut self, code: &str, now: Instant) -> bool {
        let verdict = self.shared.pairing.lock().map_or(Admission::Closed, |mut p| p.try_code(code, now));
        match verdict {
            Admission::Paired => {
                self.slot.pair();
                self.number = Some(1 + self.shared.holder.fetch_add(1, Ordering::AcqRel));
                // The previous phone may have left with its finger down.
                self.press(false);
                self.send(&ToPhone::Welcome)
            }
            Admission::Wait(wait) => {
                self.reject();
                self.send(&ToPhone::Refused { wait_s: wait.as_secs_f64(), closed: false })
            }
            Admission::Closed => {
                self.reject();
                self.send(&ToPhone::Refused { wait_s: 0.0, closed: true });
                false
            }
        }
    }

    fn move_pan(&mut self, measured: &Measured) {
        self.phone = from_angles(measured.turn);
        let rotation = self.level.pan(self.phone);
        let push = acceleration(measured, self.phone).map(|a| self.level.direction(self.phone, a));
        self.publish(|incoming| {
            incoming.number += 1;
            incoming.rotation = rotation;
            incoming.connected = true;
            if let Some(push) = push {
                incoming.push = push;
                incoming.pushes += 1;
            }
        });
    }

    fn press(&mut self, down: bool) {
        self.pressed = down;
        self.publish(|incoming| incoming.button = down);
    }

    /// Releases the button of a silent phone; it stays released when the phone returns.
    fn release_after_silence(&mut self) {
        if self.pressed && self.received.elapsed().as_secs_f64() > SILENCE_S {
            self.press(false);
        }
    }

    /// Publishes a change to the device, unless another phone has taken over.
    fn publish(&self, change: impl FnOnce(&mut super::Incoming)) {
        if let Ok(mut out) = self.shared.incoming.lock() {
            if self.number.is_some_and(|n| n != self.shared.holder.load(Ordering::Acquire)) {
                return;
            }
            let (input, incoming) = &mut *out;
            change(incoming);
            input.write(*incoming);
        }
    }

    /// Counts a rejected message.
    fn reject(&mut self) -> bool {
        self.bad += 1;
        self.publish(|incoming| incoming.rejected = incoming.rejected.wrapping_add(1));
        true
    }

    /// Sends the pan's pose and rumble when the interval has passed; returns false if the phone is gone.
    fn report(&mut self) -> bool {
        if self.number.is_none() || self.reported.elapsed() < REPORT_INTERVAL {
            return true;
        }
        self.reported = Instant::now();
        let outgoing = self.shared.outgoing.lock().map(|mut outgoing| *outgoing.read()).unwrap_or_default();
        self.send(&ToPhone::pan(&outgoing.pose, &outgoing.rumble))
    }

    /// Sends a message; returns false if the phone is gone.
    fn send(&mut self, message: &ToPhone) -> bool {
        self.socket.get_mut().sock.allow(WRITE_TIMEOUT);
        match self.socket.send(Message::text(message.json())) {
            Ok(()) => true,
            Err(Error::Io(e)) => e.kind() == ErrorKind::Interrupted,
            Err(_) => false,
        }
    }

    /// Closes the socket and publishes that the phone is gone, unless another one has taken over.
    fn leave(&mut self) {
        self.socket.get_mut().sock.allow(WRITE_TIMEOUT);
        let _ = self.socket.close(None);
        let _ = self.socket.flush();
        if self.number.is_some() {
            self.publish(|incoming| (incoming.connected, incoming.button) = (false, false));
        }
    }
}
