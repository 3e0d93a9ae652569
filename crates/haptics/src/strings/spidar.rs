//! The SPIDAR driver: handshake, samples, tension commands and stops over any link.

use std::time::Duration;

use saute_kitchen::dynamics::Pose;

use crate::device::{Capabilities, HapticCommand, HapticDevice, HapticSample, Health};
use crate::strings::caps_verdict::judge;
use crate::strings::device_clock::DeviceClock;
use crate::strings::geometry::Geometry;
use crate::strings::jig_calibration::Calibration;
use crate::strings::kept_calibration::CalibrationMemory;
use crate::strings::locator::Locator;
use crate::strings::pull::Pull;
use crate::strings::session::Session;
use crate::strings::stops::{self, Stops};
use crate::strings::wire::{
    Caps, Command, DeviceState, Frame, FrameError, Hello, Link, Message, Refusal, Refused, Sample, VERSION,
};
use crate::strings::{STRINGS, StringRig};
use crate::wrench::Wrench;

/// Silence after which the device counts as lost [s] (chosen: a hundred samples).
const SILENCE_S: f64 = 0.1;
/// Interval between two hellos [s] (chosen: a device answers within milliseconds, and a new one is found without a noticeable delay).
const HELLO_S: f64 = 0.1;
/// Interval between two hellos after a refusal [s] (chosen: the cause needs a person to change it).
const RETRY_S: f64 = 1.0;
/// Longest wait that a device may request [s] (chosen: a person would look for a fault by then).
const LONGEST_WAIT_S: f64 = 5.0;
/// Every so many hellos one is of version 1, which an older device answers (chosen: found within half a second).
const OLDER_EVERY: u32 = 5;
/// Maximum number of frames read per exchange (chosen: more of them mean that the host was late; the newest sample counts).
const MOST_FRAMES: usize = 16;

/// Phase of the handshake.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Phase {
    /// Hellos are sent until the device answers.
    Seeking,
    /// The device's capabilities are accepted; arm is sent.
    Arming,
    /// Samples arrive.
    Linked,
    /// A safety rule has fired: tensions go to the least ones.
    Releasing,
    /// Stops are sent, then nothing.
    Stopped(Stops),
}

/// A SPIDAR at the other end of a link.
#[derive(Debug)]
pub struct Spidar<L: Link> {
    link: L,
    geometry: Geometry,
    capabilities: Capabilities,
    pairing: u32,
    locator: Locator,
    pull: Pull,
    phase: Phase,
    health: Health,
    caps: Option<Caps>,
    session: Session,
    clock: f64,
    received_at: f64,
    device_clock: DeviceClock,
    /// Time of the next hello [s], and number of hellos without an answer.
    hello_due: f64,
    unanswered: u32,
    output: HapticSample,
}

impl<L: Link> Spidar<L> {
    /// Creates the driver of a device with a geometry; the pairing code is 0 if the device needs none.
    pub fn new(link: L, geometry: Geometry, pairing: u32) -> Self {
        Self {
            link,
            capabilities: geometry.capabilities(),
            pairing,
            locator: Locator::new(&geometry),
            pull: Pull::new(&geometry),
            phase: Phase::Seeking,
            health: Health::Connecting,
            caps: None,
            session: Session::new(),
            clock: 0.0,
            received_at: 0.0,
            device_clock: DeviceClock::default(),
            hello_due: f64::NEG_INFINITY,
            unanswered: 0,
            output: HapticSample { pose: geometry.home(), ..HapticSample::default() },
            geometry,
        }
    }

    /// Returns the calibration, once there is one.
    pub fn calibration(&self) -> Option<&Calibration> {
        self.locator.calibration()
    }

    /// Sets a calibration; it is valid until the encoders lose their count.
    pub fn calibrate(&mut self, calibration: Calibration) {
        self.locator.calibrate(calibration);
    }

    /// Returns the last pose of the pan.
    pub fn pose(&self) -> Pose {
        self.output.pose
    }

    fn send(&mut self, message: Message) {
        let frame = Frame { sequence: self.session.next_sequence(), session: self.session.number(), message };
        // A frame that cannot be sent is a lost frame: the silence that follows is detected.
        let _ = self.link.send(&frame);
    }

    /// Reads the received frames; returns true if there was a new sample.
    fn receive_frames(&mut self) -> bool {
        let mut fresh = false;
        for _ in 0..MOST_FRAMES {
            match self.link.receive() {
                None => break,
                Some(Ok(frame)) if self.session.accept(&frame) => fresh |= self.receive(&frame.message),
                // A running link is not broken by a frame of another version: it is not the device's.
                Some(Err(FrameError::Version(version))) if self.phase == Phase::Seeking => self.meet_version(version),
                Some(_) => self.output.rejected += 1,
            }
        }
        fresh
    }

    fn receive(&mut self, message: &Message) -> bool {
        match (message, self.phase) {
            // Messages of a stopped device change nothing.
            (_, Phase::Stopped(_)) => {}
            (Message::Caps(caps), Phase::Seeking) => self.accept_capabilities(caps),
            (Message::Refused(refused), _) => self.take_refusal(refused),
            (Message::Sample(sample), Phase::Arming | Phase::Linked | Phase::Releasing) => {
                return self.accept_sample(sample);
            }
            _ => self.output.rejected += 1,
        }
        false
    }

    fn meet_version(&mut self, version: u8) {
        self.refuse(if version < VERSION { Health::DeviceOutdated } else { Health::ProgramOutdated });
    }

    fn take_refusal(&mut self, refused: &Refused) {
        match refused.reason {
            Refusal::WrongCode => self.refuse(Health::WrongCode),
            // The code that was wrong before was not looked at.
            Refusal::TooManyTries if self.health == Health::WrongCode => self.refuse(Health::WrongCode),
            Refusal::Busy => self.refuse(Health::Busy),
            Refusal::TooManyTries | Refusal::OutOfOrder => self.refuse(Health::Connecting),
            // The answer to a hello of version 1.
            Refusal::OtherVersion => {}
        }
        let wait_s = f64::from(refused.wait_ms) * 1e-3;
        self.hello_due = self.hello_due.max(self.clock + wait_s.min(LONGEST_WAIT_S));
    }

    fn refuse(&mut self, health: Health) {
        if matches!(self.phase, Phase::Releasing | Phase::Stopped(_)) {
            return;
        }
        (self.phase, self.health) = (Phase::Seeking, health);
        // Nobody presses the buttons of a device that is not heard.
        self.output.buttons = 0;
        self.hello_due = self.clock + if is_refusal(health) { RETRY_S } else { HELLO_S };
    }

    fn accept_capabilities(&mut self, caps: &Caps) {
        if let Err(health) = judge(caps, &self.geometry) {
            return self.refuse(health);
        }
        self.unanswered = 0;
        self.locator.meet(caps);
        self.caps = Some(*caps);
        self.device_clock.begin_session();
        self.pull.rest();
        (self.phase, self.received_at) = (Phase::Arming, self.clock);
        self.send(Message::Arm);
    }

    /// Accepts a sample that is newer than the last one; returns false if it is not.
    fn accept_sample(&mut self, sample: &Sample) -> bool {
        let Some(passed) = self.device_clock.advance(sample.time_us, self.clock) else {
            self.output.rejected += 1;
            return false;
        };
        self.received_at = self.clock;
        // Without current the strings may be slack: their lengths then give no information about the pan.
        if matches!(sample.state, DeviceState::Armed | DeviceState::Running) {
            self.locator.locate(sample, passed);
        }
        self.report(sample);
        match (sample.state, self.phase) {
            (_, Phase::Releasing) => {}
            (DeviceState::Fault, _) => self.refuse(Health::Fault),
            (DeviceState::Idle | DeviceState::Greeted, _) => self.refuse(Health::Lost),
            (DeviceState::Armed | DeviceState::Running, _) => self.phase = Phase::Linked,
        }
        true
    }

    /// Puts the values of a sample into the output.
    fn report(&mut self, sample: &Sample) {
        let pulled = sample.tension_mn.map(|t| f64::from(t) * 1e-3);
        self.output = HapticSample {
            time_s: self.device_clock.time_s(),
            pose: self.locator.pose(),
            twist: self.locator.twist(),
            length_misfit: self.locator.length_misfit(),
            total_force_n: self.locator.lines().wrench(&pulled).force.length(),
            tension_n: Some(pulled),
            buttons: u32::from(sample.buttons),
            ..self.output
        };
    }

    /// Sends a hello of a new session when it is due.
    fn send_hello(&mut self) {
        // Without random numbers there is no session; the system has them later.
        if self.clock < self.hello_due || self.session.begin().is_err() {
            return;
        }
        self.hello_due = self.clock + if is_refusal(self.health) { RETRY_S } else { HELLO_S };
        self.unanswered += 1;
        let hello = Hello { pairing: self.pairing, rate_hz: self.geometry.drive.rate_hz as u16 };
        let older = self.unanswered.is_multiple_of(OLDER_EVERY);
        self.send(if older { Message::HelloOfVersion1(hello) } else { Message::Hello(hello) });
    }

    fn send_tensions(&mut self, tension_mn: [u16; STRINGS]) {
        self.send(Message::Command(Command { time_us: (self.clock * 1e6) as u64 as u32, tension_mn }));
    }

    /// Sends the tensions for a command.
    fn send_pull(&mut self, command: &HapticCommand, dt: f64) {
        let ready = command.enabled && self.calibration().is_some() && command.wrench.is_finite();
        let most_mn = self.caps.map_or(0, |c| c.max_mn);
        let wanted = ready.then_some(command.wrench);
        let pulled = self.pull.tensions(&self.locator.lines(), wanted, most_mn, dt);
        self.output.achieved = pulled.achieved;
        self.send_tensions(pulled.tension_mn);
    }

    /// Sends the next tensions of a release, and then stops.
    fn send_release(&mut self) {
        let tension_mn = self.pull.release();
        self.send_tensions(tension_mn);
        if self.pull.is_released() {
            self.stop();
        }
    }

    fn send_due_stop(&mut self, mut stops: Stops) {
        if stops.is_due(self.clock) {
            self.send(Message::Stop);
        }
        self.phase = Phase::Stopped(stops);
    }

    fn linked_health(&self) -> Health {
        match (self.calibration(), self.locator.readings_misfit()) {
            (Some(_), _) => Health::Running,
            (None, true) => Health::Misfit,
            (None, false) => Health::Uncalibrated,
        }
    }
}

/// Returns true if a person has to change something before the device can run.
fn is_refusal(health: Health) -> bool {
    use Health::{Connecting, Lost, Misfit, Running, Uncalibrated};
    !matches!(health, Connecting | Lost | Misfit | Running | Uncalibrated)
}

impl<L: Link> HapticDevice for Spidar<L> {
    fn capabilities(&self) -> &Capabilities {
        &self.capabilities
    }

    fn exchange(&mut self, command: &HapticCommand, dt: f64) -> HapticSample {
        self.clock += dt;
        let fresh = self.receive_frames();
        if matches!(self.phase, Phase::Arming | Phase::Linked) && self.clock - self.received_at > SILENCE_S {
            self.refuse(Health::Lost);
        }
        self.output.achieved = Wrench::ZERO;
        match self.phase {
            Phase::Seeking => self.send_hello(),
            Phase::Arming => {}
            Phase::Linked => {
                self.health = self.linked_health();
                self.send_pull(command, dt);
            }
            Phase::Releasing => self.send_release(),
            Phase::Stopped(stops) => self.send_due_stop(stops),
        }
        self.output.health = self.health;
        self.output.fresh = fresh;
        self.output
    }

    /// Sends the stops of the session; a device that has been stopped, or never requested, is sent none.
    fn stop(&mut self) {
        self.health = Health::Stopped;
        self.output.buttons = 0;
        match self.phase {
            Phase::Stopped(_) => {}
            _ if self.session.end() => self.send_due_stop(Stops::from(self.clock)),
            _ => self.phase = Phase::Stopped(Stops::default()),
        }
    }

    fn trip(&mut self) {
        if self.phase != Phase::Linked {
            return self.stop();
        }
        (self.phase, self.health) = (Phase::Releasing, Health::Stopped);
        self.send_release();
    }

    fn resume(&mut self) {
        self.locator.doubt();
        (self.phase, self.health) = (Phase::Seeking, Health::Connecting);
        self.hello_due = f64::NEG_INFINITY;
        (self.output.length_misfit, self.output.total_force_n) = (0.0, 0.0);
    }

    fn strings(&self) -> Option<StringRig> {
        Some(self.geometry.rig())
    }

    fn remember(&mut self, memory: CalibrationMemory) {
        self.locator.remember(memory);
    }
}

impl<L: Link> Drop for Spidar<L> {
    /// Sends the stops that are still due, so that no force outlives the driver, even when its thread panics.
    fn drop(&mut self) {
        let left = match self.phase {
            Phase::Stopped(stops) => stops.left(),
            _ if self.session.end() => Stops::from(self.clock).left(),
            _ => 0,
        };
        for k in 0..left {
            if k > 0 || matches!(self.phase, Phase::Stopped(_)) {
                std::thread::sleep(Duration::from_secs_f64(stops::INTERVAL_S));
            }
            self.send(Message::Stop);
        }
    }
}
