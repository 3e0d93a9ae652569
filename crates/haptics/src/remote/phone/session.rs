//! The talk with one phone: first its code, then its motion, and back how the pan is and how hard to shake.

use std::io::ErrorKind;
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

use glam::DQuat;
use tungstenite::protocol::{Role, WebSocketConfig};
use tungstenite::{Error, Message, WebSocket};

use super::message::{FromPhone, LONGEST, Measured, ToPhone};
use super::orientation::{Level, acceleration, from_angles};
use super::server::{Line, Shared, WRITE};
use crate::remote::allowance::Allowance;
use crate::remote::pairing::Verdict;
use crate::remote::remote_pose::SILENCE_S;
use crate::remote::timeout::is_timeout;

/// How long a phone may take to be paired (chosen: the page connects when the code has been typed; whoever waits longer only takes up room).
const PAIRING: Duration = Duration::from_secs(5);
/// How long one message may be listened for (chosen: three reports; empty pieces without end would keep the thread for ever else).
const LISTEN: Duration = Duration::from_millis(100);
/// Time between two reports to the phone (chosen: thirty a second).
const REPORT: Duration = Duration::from_millis(33);
/// Messages a second that are heard; faster ones are thrown away (chosen: three times what the page sends).
const FASTEST_HZ: f64 = 180.0;
/// Messages that may come at once (chosen: a second's, held up by the radio).
const BURST: f64 = 60.0;
/// Thrown-away messages in a row after which the talk is ended (chosen: no page does that).
const MOST_BAD: u32 = 500;

/// A talk.
struct Talk<'a> {
    socket: WebSocket<Line>,
    shared: &'a Shared,
    number: Option<u64>,
    level: Level,
    phone: DQuat,
    allowance: Allowance,
    bad: u32,
    pressed: bool,
    spoke: Instant,
    reported: Instant,
}

/// Talks until one of both sides ends it.
pub fn run(stream: Line, shared: &Shared) {
    let config = WebSocketConfig::default()
        .max_message_size(Some(LONGEST))
        .max_frame_size(Some(LONGEST))
        .max_write_buffer_size(1 << 20);
    let now = Instant::now();
    let mut talk = Talk {
        socket: WebSocket::from_raw_socket(stream, Role::Server, Some(config)),
        shared,
        number: None,
        level: Level::default(),
        phone: DQuat::IDENTITY,
        allowance: Allowance::new(FASTEST_HZ, BURST, now),
        bad: 0,
        pressed: false,
        spoke: now,
        reported: now,
    };
    while talk.turn(now) {}
    talk.leave();
}

impl Talk<'_> {
    /// One message, or a little while without one; tells whether to go on.
    fn turn(&mut self, begun: Instant) -> bool {
        self.socket.get_mut().sock.allow(LISTEN);
        let on = match self.socket.read() {
            Ok(Message::Text(text)) => self.hear(&text),
            Ok(Message::Binary(_)) => self.reject(),
            Ok(Message::Close(_)) => false,
            Ok(_) => self.allowance.takes(Instant::now()) || self.reject(),
            Err(Error::Io(e)) => is_timeout(&e),
            Err(Error::Capacity(_) | Error::Protocol(_) | Error::Utf8(_)) => {
                self.reject();
                false
            }
            Err(_) => false,
        };
        self.let_go_in_silence();
        let paired_in_time = self.number.is_some() || begun.elapsed() < PAIRING;
        on && paired_in_time && self.bad < MOST_BAD && self.still_wanted() && self.report()
    }

    /// Whether the device is still there and no other phone holds the pan.
    fn still_wanted(&mut self) -> bool {
        if self.shared.end.load(Ordering::Acquire) {
            return false;
        }
        let replaced = self.number.is_some_and(|n| n != self.shared.holder.load(Ordering::Acquire));
        if replaced {
            self.tell(&ToPhone::Replaced);
        }
        !replaced
    }

    fn hear(&mut self, text: &str) -> bool {
        let now = Instant::now();
        if !self.allowance.takes(now) {
            return self.reject();
        }
        match (FromPhone::parse(text), self.number) {
            (Ok(FromPhone::Hello { code }), None) => return self.pair(&code, now),
            (Ok(FromPhone::Motion(measured)), Some(_)) => self.move_pan(&measured),
            (Ok(FromPhone::Flat {}), Some(_)) => {
                let taken = self.level.set(self.phone);
                return self.tell(&ToPhone::Flat { taken });
            }
            (Ok(FromPhone::Button { down }), Some(_)) => self.press(down),
            _ => return self.reject(),
        }
        (self.bad, self.spoke) = (0, now);
        true
    }

    fn pair(&mut self, code: &str, now: Instant) -> bool {
        let verdict = self.shared.pairing.lock().map_or(Verdict::Closed, |mut p| p.try_code(code, now));
        match verdict {
            Verdict::Paired => {
                self.number = Some(1 + self.shared.holder.fetch_add(1, Ordering::AcqRel));
                // The one before may have left with its finger down.
                self.press(false);
                self.tell(&ToPhone::Welcome)
            }
            Verdict::Wait(wait) => {
                self.reject();
                self.tell(&ToPhone::Refused { wait_s: wait.as_secs_f64(), closed: false })
            }
            Verdict::Closed => {
                self.reject();
                self.tell(&ToPhone::Refused { wait_s: 0.0, closed: true });
                false
            }
        }
    }

    fn move_pan(&mut self, measured: &Measured) {
        self.phone = from_angles(measured.turn);
        let rotation = self.level.pan(self.phone);
        let push = acceleration(measured, self.phone).map(|a| self.level.direction(self.phone, a));
        self.publish(|heard| {
            heard.number += 1;
            heard.rotation = rotation;
            heard.connected = true;
            if let Some(push) = push {
                heard.push = push;
                heard.pushes += 1;
            }
        });
    }

    fn press(&mut self, down: bool) {
        self.pressed = down;
        self.publish(|heard| heard.button = down);
    }

    /// A phone that has fallen silent presses nothing, also when it speaks again.
    fn let_go_in_silence(&mut self) {
        if self.pressed && self.spoke.elapsed().as_secs_f64() > SILENCE_S {
            self.press(false);
        }
    }

    /// Tells the device, unless another phone holds the pan by now.
    fn publish(&self, change: impl FnOnce(&mut super::Heard)) {
        if let Ok(mut out) = self.shared.heard.lock() {
            if self.number.is_some_and(|n| n != self.shared.holder.load(Ordering::Acquire)) {
                return;
            }
            let (input, heard) = &mut *out;
            change(heard);
            input.write(*heard);
        }
    }

    /// Counts a message that is thrown away.
    fn reject(&mut self) -> bool {
        self.bad += 1;
        self.publish(|heard| heard.rejected = heard.rejected.wrapping_add(1));
        true
    }

    /// Tells the phone about the pan when it is time.
    fn report(&mut self) -> bool {
        if self.number.is_none() || self.reported.elapsed() < REPORT {
            return true;
        }
        self.reported = Instant::now();
        let told = self.shared.told.lock().map(|mut told| *told.read()).unwrap_or_default();
        self.tell(&ToPhone::pan(&told.pose, &told.rumble))
    }

    /// Sends a message; tells whether the phone still takes any.
    fn tell(&mut self, message: &ToPhone) -> bool {
        self.socket.get_mut().sock.allow(WRITE);
        match self.socket.send(Message::text(message.json())) {
            Ok(()) => true,
            Err(Error::Io(e)) => e.kind() == ErrorKind::Interrupted,
            Err(_) => false,
        }
    }

    /// The phone is gone, unless another one holds the pan already.
    fn leave(&mut self) {
        self.socket.get_mut().sock.allow(WRITE);
        let _ = self.socket.close(None);
        let _ = self.socket.flush();
        if self.number.is_some() {
            self.publish(|heard| (heard.connected, heard.button) = (false, false));
        }
    }
}
