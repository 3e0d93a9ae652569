//! The device's firmware: states, watchdog and answers.

use std::collections::hash_map::RandomState;
use std::hash::{BuildHasher, Hasher};
use std::net::SocketAddr;
use std::path::Path;
use std::time::{Duration, Instant};

use crate::codec::{self, Identity, Parsed, Reading, Refusal, Request};
use crate::faults::Faults;
use crate::pairing::{CodeCheck, Pairing};
use crate::rig_file::{RigFile, RigFileError};
use crate::scene::{Making, Scene};
use crate::session::{Past, Session};
use crate::truth_log::TruthLog;

/// Watchdog: time without a command after which the device falls back to the minimum tension [ms] (chosen: a hundred commands).
const WATCHDOG_MS: u16 = 100;
/// Shortest time between two answers to hosts of another version (chosen: a person cannot read more, and a flood gets no echo).
const VERSION_ANSWER: Duration = Duration::from_millis(100);

/// Codes of faults in a sample.
const FAULTS: std::ops::RangeInclusive<u8> = 1..=4;

#[derive(Clone, Copy, Debug, PartialEq)]
enum State {
    Idle,
    Greeted,
    Armed,
    Running,
    Fault,
}

/// A fault that the device has found.
#[derive(Clone, Copy, Debug)]
struct Fault {
    /// Its code in a sample.
    code: u8,
    /// True until the device is repaired.
    persists: bool,
}

/// Returns a boot number that no earlier process had, as a device without permanent memory draws one.
fn random_boot() -> u32 {
    // The standard library's only random numbers; the codes of `getrandom` may fail, and this must not.
    RandomState::new().build_hasher().finish() as u32
}

/// The device with its host.
pub struct Device {
    scene: Scene,
    identity: Identity,
    pairing: Pairing,
    state: State,
    fault: Option<Fault>,
    buttons: u8,
    /// Encoder counts that every sample repeats, while the encoders are stuck.
    stuck: Option<[i32; 8]>,
    session: Option<Session>,
    past: Past,
    /// Sequence number of the last frame sent.
    sequence: u32,
    obeyed: u32,
    commanded: Instant,
    version_answered: Option<Instant>,
    started: Instant,
    advanced: Instant,
    faults: Faults,
    truth: TruthLog,
}

impl Device {
    /// Switches a device on, by name or geometry file; it serves hosts with a pairing code, or all for 0.
    pub fn named(device: &str, making: &Making, pairing: u32, now: Instant) -> Result<Self, RigFileError> {
        Ok(Self::new(&crate::rig_file::load(device)?, making, pairing, now))
    }

    pub(crate) fn new(file: &RigFile, making: &Making, pairing: u32, now: Instant) -> Self {
        let drive = &file.drive;
        let identity = Identity {
            tension_unit: 1,
            pitch_nm: (drive.encoder_pitch_um * 1e3) as u32,
            min_mn: (drive.min_tension_n * 1e3) as u16,
            max_mn: (drive.max_tension_n * 1e3) as u16,
            rate_hz: drive.rate_hz as u16,
            watchdog_ms: WATCHDOG_MS,
            boot: random_boot(),
            name: "simulated".into(),
        };
        Self {
            scene: Scene::new(file, making),
            identity,
            pairing: Pairing::new(pairing),
            state: State::Idle,
            fault: None,
            buttons: 0,
            stuck: None,
            session: None,
            past: Past::default(),
            sequence: 0,
            obeyed: 0,
            commanded: now,
            version_answered: None,
            started: now,
            advanced: now,
            faults: Faults::new(making.seed),
            truth: TruthLog::default(),
        }
    }

    /// Writes the true state at every sample to a file from now on.
    pub(crate) fn log_truth(&mut self, path: Option<&Path>) -> std::io::Result<()> {
        self.truth = TruthLog::create(path)?;
        Ok(())
    }

    pub(crate) fn flush(&mut self) {
        self.truth.flush();
    }

    /// Advances the scene to a time; a silent host loses first its tensions, then its session.
    pub fn advance(&mut self, now: Instant) {
        let silent = now - self.commanded > Duration::from_millis(u64::from(WATCHDOG_MS));
        if self.state == State::Running && silent {
            self.state = State::Armed;
            self.scene.drives.iter_mut().for_each(|d| d.idle());
        }
        self.expire(now);
        self.scene.advance((now - self.advanced).as_secs_f64());
        self.advanced = now;
    }

    /// Ends the session of a host that has been silent for too long.
    fn expire(&mut self, now: Instant) {
        if self.session.is_some_and(|s| s.left(now).is_zero()) {
            self.end_session();
        }
    }

    /// Takes what a socket has received.
    pub fn receive(&mut self, bytes: &[u8], from: SocketAddr, now: Instant) {
        if self.faults.loses(now) {
            return;
        }
        self.expire(now);
        match codec::parse(bytes) {
            None => {}
            // No session has this number: it means none.
            Some(Parsed::Request { session: 0, .. }) => {}
            Some(Parsed::HelloOfAnotherVersion { session }) => self.answer_version(session, from, now),
            Some(Parsed::Request { sequence, session, request: Request::Hello { pairing } }) => {
                self.greet(pairing, session, sequence, from, now);
            }
            Some(Parsed::Request { sequence, session, request }) => self.obey(request, session, sequence, from, now),
        }
    }

    /// Returns an answer whose delay has passed, with its recipient.
    pub fn arrived(&mut self, now: Instant) -> Option<(SocketAddr, Vec<u8>)> {
        self.faults.arrived(now)
    }

    /// Returns the tension of each string at the pan [N].
    pub fn tensions(&self) -> [f64; 8] {
        std::array::from_fn(|i| self.scene.drives[i].tension())
    }

    /// Returns true if no motor has current.
    pub fn is_idle(&self) -> bool {
        matches!(self.state, State::Idle | State::Greeted | State::Fault)
    }

    /// Executes an order of stdin, given as its words; returns false if it is none.
    pub fn order(&mut self, words: &[&str], now: Instant) -> bool {
        match words {
            ["units", "wrong"] => self.restate_units(2),
            ["units", "right"] => self.restate_units(1),
            ["power-cycle"] => self.power_cycle(now),
            ["fault", code] => return code.parse().is_ok_and(|code| self.fail(code)),
            ["repair"] => self.fault.iter_mut().for_each(|fault| fault.persists = false),
            ["encoders", "stuck"] => self.stuck = Some(self.scene.counts()),
            ["encoders", "free"] => self.stuck = None,
            ["buttons", bits] => return bits.parse().map(|bits| self.buttons = bits).is_ok(),
            _ => return self.faults.order(words, now),
        }
        true
    }

    /// A frame of the session: obeyed if it is newer than all before it. A stop is obeyed in any case.
    fn obey(&mut self, request: Request, number: u32, sequence: u32, from: SocketAddr, now: Instant) {
        let Some(session) = self.session.as_mut().filter(|s| s.owns(from, number)) else { return };
        let newer = session.accept(sequence, now);
        match (request, self.state) {
            (Request::Stop, _) => self.end_session(),
            _ if !newer => {}
            (Request::Arm | Request::Command { .. }, State::Fault) => self.send_sample(from, now),
            (Request::Arm, _) => {
                self.state = State::Armed;
                self.scene.drives.iter_mut().for_each(|d| d.idle());
                self.scene.armed();
                self.send_sample(from, now);
            }
            (Request::Command { tension_mn }, State::Armed | State::Running) => {
                self.state = State::Running;
                (self.commanded, self.obeyed) = (now, sequence);
                for (drive, t) in self.scene.drives.iter_mut().zip(tension_mn) {
                    drive.command(f64::from(t) * 1e-3);
                }
                self.send_sample(from, now);
            }
            (Request::Hello { .. } | Request::Command { .. }, _) => {
                self.refuse(Refusal::OutOfOrder, Duration::ZERO, number, from, now);
            }
        }
    }

    fn greet(&mut self, pairing: u32, number: u32, sequence: u32, from: SocketAddr, now: Instant) {
        match self.session {
            Some(session) if session.owns(from, number) => return self.greet_again(sequence, from, now),
            Some(session) if session.host != from => {
                return self.refuse(Refusal::Busy, session.left(now), number, from, now);
            }
            _ => {}
        }
        if self.past.knows(number) {
            return;
        }
        match self.pairing.check(pairing, now) {
            CodeCheck::Paired => self.begin_session(Session::begin(from, number, sequence, now), now),
            CodeCheck::Wrong => self.refuse(Refusal::WrongCode, self.pairing.wait(now), number, from, now),
            CodeCheck::TooSoon => self.refuse(Refusal::TooManyTries, self.pairing.wait(now), number, from, now),
        }
    }

    fn begin_session(&mut self, session: Session, now: Instant) {
        self.end_session();
        // A hello takes leave of a fault whose cause is gone.
        self.fault = self.fault.filter(|fault| fault.persists);
        self.state = if self.fault.is_some() { State::Fault } else { State::Greeted };
        (self.session, self.obeyed) = (Some(session), 0);
        self.past.note(session.number);
        self.send_caps(session.host, session.number, now);
    }

    /// Repeats the answer to the hello of the present session: it was lost. Once armed, its host has had it.
    fn greet_again(&mut self, sequence: u32, from: SocketAddr, now: Instant) {
        let Some(session) = self.session.as_mut().filter(|_| matches!(self.state, State::Greeted | State::Fault))
        else {
            return;
        };
        if session.accept(sequence, now) {
            let number = session.number;
            self.send_caps(from, number, now);
        }
    }

    /// Sends a host of another version the version of this device; a running session is not touched.
    fn answer_version(&mut self, number: u32, from: SocketAddr, now: Instant) {
        if self.version_answered.is_none_or(|at| now - at >= VERSION_ANSWER) {
            self.version_answered = Some(now);
            self.refuse(Refusal::OtherVersion, Duration::ZERO, number, from, now);
        }
    }

    /// Ends the session: no current in any motor. A fault stays.
    fn end_session(&mut self) {
        self.session = None;
        self.state = if self.fault.is_some() { State::Fault } else { State::Idle };
        self.scene.drives.iter_mut().for_each(|d| d.release());
    }

    fn next_sequence(&mut self) -> u32 {
        self.sequence = self.sequence.wrapping_add(1).max(1);
        self.sequence
    }

    fn refuse(&mut self, why: Refusal, wait: Duration, session: u32, to: SocketAddr, now: Instant) {
        let frame = codec::refused(why, wait, self.next_sequence(), session);
        self.faults.send(to, frame, now);
    }

    fn send_caps(&mut self, to: SocketAddr, session: u32, now: Instant) {
        let sequence = self.next_sequence();
        self.faults.send(to, codec::caps(&self.identity, sequence, session), now);
    }

    fn send_sample(&mut self, to: SocketAddr, now: Instant) {
        let Some(session) = self.session.map(|s| s.number) else { return };
        let time_us = (now - self.started).as_micros() as u32;
        let reading = Reading {
            state: self.state as u8,
            fault: self.fault.map_or(0, |fault| fault.code),
            buttons: self.buttons,
            jig: self.scene.jig_contact(),
            time_us,
            obeyed: self.obeyed,
            count: self.stuck.unwrap_or_else(|| self.scene.counts()),
            tension_mn: std::array::from_fn(|i| (self.scene.drives[i].by_current() * 1e3) as u16),
        };
        self.truth.note(time_us, &self.scene);
        let sequence = self.next_sequence();
        self.faults.send(to, codec::sample(&reading, sequence, session), now);
    }

    fn restate_units(&mut self, tension_unit: u8) {
        self.identity.tension_unit = tension_unit;
        self.end_session();
    }

    /// Finds a fault by its code: no current in any motor; the session goes on. Returns false if there is no such fault.
    fn fail(&mut self, code: u8) -> bool {
        let known = FAULTS.contains(&code);
        if known {
            (self.fault, self.state) = (Some(Fault { code, persists: true }), State::Fault);
            self.scene.drives.iter_mut().for_each(|d| d.release());
        }
        known
    }

    /// Loses the supply: count, clock, session and all session numbers are forgotten.
    fn power_cycle(&mut self, now: Instant) {
        self.identity.boot = self.identity.boot.wrapping_add(1);
        self.fault = self.fault.filter(|fault| fault.persists);
        self.end_session();
        (self.past, self.sequence, self.started) = (Past::default(), 0, now);
        self.scene.power_cycle();
    }

    pub(crate) fn view(&self, now: Instant) -> String {
        let p = self.scene.pan.pose.position * 1e3;
        let tensions: Vec<String> = self.tensions().iter().map(|t| format!("{t:4.1}")).collect();
        let place = match self.scene.jig_contact() {
            _ if self.scene.is_free() => "in the hand".to_owned(),
            0 => "between places of the jig".to_owned(),
            place => format!("jig, place {place}"),
        };
        let silent = if self.faults.is_silent(now) { ", unplugged" } else { "" };
        let state = format!("{:?}{silent}", self.state).to_lowercase();
        format!("{state:8}  {place}  pan {:6.1} {:6.1} {:6.1} mm  strings {} N", p.x, p.y, p.z, tensions.join(" "))
    }
}
