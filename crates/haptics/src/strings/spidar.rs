//! The SPIDAR driver: handshake, calibration, pose and tension commands over any link.

use saute_kitchen::dynamics::Pose;

use crate::device::{Capabilities, HapticCommand, HapticDevice, HapticSample, Health};
use crate::strings::geometry::Geometry;
use crate::strings::jig_calibration::{Calibration, FARTHEST};
use crate::strings::jig_log::JigLog;
use crate::strings::kept_calibration::{CalibrationMemory, KeptCalibration};
use crate::strings::pose_from_lengths::PoseEstimator;
use crate::strings::tension::{TensionSolver, Tensions};
use crate::strings::wire::{
    Caps, Command, DeviceState, Frame, FrameError, Hello, Link, Message, Refusal, Sample, Units,
};
use crate::strings::{Lines, STRINGS, StringRig};
use crate::wrench::Wrench;

/// Silence after which the device counts as lost [s] (chosen: a hundred samples).
const SILENCE_S: f64 = 0.1;
/// Interval between two hellos [s] (chosen: a device answers within milliseconds, and a new one is found without a noticeable delay).
const HELLO_S: f64 = 0.1;
/// Interval between two hellos after a refusal [s] (chosen: the cause needs a person to change it).
const RETRY_S: f64 = 1.0;
/// Time in which the preload builds up [s] (chosen: a gentle pull).
const PRELOAD_UP_S: f64 = 0.5;
/// Time in which the preload is released [s] (chosen: quick, but without a jerk).
const PRELOAD_DOWN_S: f64 = 0.2;
/// Residual of the pose above which a stored calibration is discarded [m] (chosen: ten times the residual of strings and jig).
const FITS: f64 = 0.5e-3;
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
}

/// A SPIDAR at the other end of a link.
#[derive(Debug)]
pub struct Spidar<L> {
    link: L,
    geometry: Geometry,
    capabilities: Capabilities,
    pairing: u32,
    estimator: PoseEstimator,
    solver: TensionSolver,
    calibration: Option<Calibration>,
    memory: Option<CalibrationMemory>,
    /// True if the calibration is a stored one that is not verified yet.
    unverified: bool,
    jig: JigLog,
    misfit: bool,
    phase: Phase,
    health: Health,
    caps: Option<Caps>,
    session: u32,
    sequence: u32,
    clock: f64,
    received_at: f64,
    device_us: u64,
    hello_at: f64,
    engaged: f64,
    last: Option<Sample>,
    output: HapticSample,
}

impl<L: Link> Spidar<L> {
    /// Creates the driver of a device with a geometry; the pairing code is 0 if the device needs none.
    pub fn new(link: L, geometry: Geometry, pairing: u32) -> Self {
        let home = geometry.home();
        Self {
            link,
            capabilities: geometry.capabilities(),
            pairing,
            estimator: PoseEstimator::new(geometry.rig(), home),
            solver: TensionSolver::new(geometry.tension_rule()),
            calibration: None,
            memory: None,
            unverified: false,
            jig: JigLog::new(&geometry.jig()),
            misfit: false,
            phase: Phase::Seeking,
            health: Health::Connecting,
            caps: None,
            session: 0,
            sequence: 0,
            clock: 0.0,
            received_at: 0.0,
            device_us: 0,
            hello_at: f64::NEG_INFINITY,
            engaged: 0.0,
            last: None,
            output: HapticSample { pose: home, ..HapticSample::default() },
            geometry,
        }
    }

    /// Returns the calibration, once there is one.
    pub fn calibration(&self) -> Option<&Calibration> {
        self.calibration.as_ref()
    }

    /// Sets a calibration; it is valid until the encoders lose their count.
    pub fn calibrate(&mut self, calibration: Calibration) {
        self.estimator = PoseEstimator::new(calibration.rig, self.geometry.home());
        self.calibration = Some(calibration);
    }

    fn send(&mut self, message: Message) {
        self.sequence = self.sequence.wrapping_add(1);
        // A frame that cannot be sent is a lost frame: the silence that follows is detected.
        let _ = self.link.send(&Frame { sequence: self.sequence, session: self.session, message });
    }

    /// Reads the received frames; returns true if there was a new sample.
    fn receive_frames(&mut self) -> bool {
        let mut fresh = false;
        for _ in 0..MOST_FRAMES {
            match self.link.receive() {
                None => break,
                Some(Ok(frame)) if frame.session == self.session => fresh |= self.receive(&frame.message),
                Some(Err(FrameError::Version(_))) => self.refuse(Health::WrongUnits),
                Some(_) => self.output.rejected += 1,
            }
        }
        fresh
    }

    fn receive(&mut self, message: &Message) -> bool {
        match message {
            Message::Caps(caps) if self.phase == Phase::Seeking => self.accept_capabilities(caps),
            Message::Refused(Refusal::WrongCode) => self.refuse(Health::WrongCode),
            Message::Refused(_) => self.refuse(Health::Connecting),
            Message::Sample(sample) if self.phase != Phase::Seeking => return self.accept_sample(sample),
            _ => self.output.rejected += 1,
        }
        false
    }

    fn refuse(&mut self, health: Health) {
        self.phase = Phase::Seeking;
        self.health = health;
        // The next hello waits for the interval of a refusal.
        self.hello_at = self.clock;
    }

    fn accept_capabilities(&mut self, caps: &Caps) {
        let strings = caps.strings as usize == STRINGS;
        if caps.units != Units::SPOKEN || !strings || caps.pitch_nm == 0 || caps.max_mn <= caps.min_mn {
            return self.refuse(Health::WrongUnits);
        }
        if self.caps.is_some_and(|before| before.boot != caps.boot) {
            self.calibration = None;
            self.misfit = false;
            self.jig = JigLog::new(&self.geometry.jig());
        }
        self.caps = Some(*caps);
        self.last = None;
        self.restore_calibration(caps);
        (self.phase, self.received_at) = (Phase::Arming, self.clock);
        self.send(Message::Arm);
    }

    /// Restores a calibration that was stored since this device was switched on.
    fn restore_calibration(&mut self, caps: &Caps) {
        let known = self.memory.as_ref().and_then(|m| m.known).filter(|_| self.calibration.is_none());
        let drawn = self.geometry.rig();
        let own = |k: &KeptCalibration| {
            (k.device, k.boot) == (caps.name, caps.boot) && k.calibration.rig.is_near(&drawn, FARTHEST)
        };
        if let Some(known) = known.filter(own) {
            self.calibrate(known.calibration);
            self.unverified = true;
        }
    }

    /// Discards a restored calibration that does not fit the first lengths.
    fn verify_restored(&mut self) {
        if std::mem::take(&mut self.unverified) && self.estimator.residual() > FITS {
            self.calibration = None;
            self.estimator = PoseEstimator::new(self.geometry.rig(), self.geometry.home());
        }
    }

    /// Stores a calibration for the next start.
    fn store(&mut self, calibration: Calibration) {
        if let (Some(memory), Some(caps)) = (&mut self.memory, &self.caps) {
            memory.keep(KeptCalibration { device: caps.name, boot: caps.boot, calibration });
        }
    }

    /// Accepts a sample that is newer than the last one; returns false if it is not.
    fn accept_sample(&mut self, sample: &Sample) -> bool {
        let passed = self.last.map(|last| sample.time_us.wrapping_sub(last.time_us) as i32);
        if passed.is_some_and(|us| us <= 0) {
            self.output.rejected += 1;
            return false;
        }
        match sample.state {
            DeviceState::Fault => self.refuse(Health::Fault),
            DeviceState::Idle | DeviceState::Greeted => self.phase = Phase::Seeking,
            DeviceState::Armed | DeviceState::Running => self.phase = Phase::Linked,
        }
        self.received_at = self.clock;
        self.last = Some(*sample);
        self.locate(sample, f64::from(passed.unwrap_or(0)) * 1e-6);
        true
    }

    /// Updates the pose, or continues the calibration.
    fn locate(&mut self, sample: &Sample, passed: f64) {
        let by_count = self.by_count(sample);
        if self.calibration.is_none() {
            let rig = self.geometry.rig();
            match self.jig.note(sample.jig, &by_count, &rig) {
                None => {}
                Some(Ok(calibration)) => {
                    self.calibrate(calibration);
                    self.store(calibration);
                }
                Some(Err(_)) => self.misfit = true,
            }
        }
        self.device_us = unwrapped(self.device_us, sample.time_us);
        self.output.time_s = self.device_us as f64 * 1e-6;
        self.output.buttons = u32::from(sample.buttons);
        if let Some(calibration) = &self.calibration {
            self.output.pose = self.estimator.update(&calibration.lengths(&by_count), passed);
            self.output.twist = self.estimator.twist();
            self.verify_restored();
        }
        let pulled = sample.tension_mn.map(|t| f64::from(t) * 1e-3);
        self.output.tension_n = Some(pulled);
        self.output.total_force_n = self.lines().wrench(&pulled).force.length();
    }

    /// Returns lengths by count, corrected for the stretch by the tensions [m].
    fn by_count(&self, sample: &Sample) -> [f64; STRINGS] {
        let pitch = self.caps.map_or(0.0, |c| f64::from(c.pitch_nm) * 1e-9);
        let length = self.lines().length;
        std::array::from_fn(|i| {
            let strain = f64::from(sample.tension_mn[i]) * 1e-3 / self.geometry.drive.axial_stiffness_n;
            f64::from(sample.count[i]) * pitch + strain * length[i]
        })
    }

    fn lines(&self) -> Lines {
        self.calibration.map_or_else(|| self.geometry.rig(), |c| c.rig).lines(&self.output.pose)
    }

    /// Sends a hello when its interval has passed.
    fn send_hello(&mut self) {
        let refused = matches!(self.health, Health::WrongCode | Health::WrongUnits | Health::Fault);
        if self.clock - self.hello_at < if refused { RETRY_S } else { HELLO_S } {
            return;
        }
        self.hello_at = self.clock;
        self.session = self.session.wrapping_add(1);
        self.last = None;
        let rate_hz = self.geometry.drive.rate_hz as u16;
        self.send(Message::Hello(Hello { pairing: self.pairing, rate_hz }));
    }

    /// Sends the tensions for a command; preload builds up and decays gradually.
    fn send_tensions(&mut self, command: &HapticCommand, dt: f64) {
        let ready = command.enabled && self.calibration.is_some() && command.wrench.is_finite();
        let change = if ready { dt / PRELOAD_UP_S } else { -dt / PRELOAD_DOWN_S };
        self.engaged = (self.engaged + change).clamp(0.0, 1.0);
        let lines = self.lines();
        let least = [self.solver.rule().min; STRINGS];
        // The empty device itself moves from minimum tensions to its preload: that is not work of the rendered wrench.
        let rest = lines.wrench(&least) * (1.0 - self.engaged) + self.geometry.preload() * self.engaged;
        let wanted = if ready { command.wrench } else { Wrench::ZERO } + rest;
        let solved = if self.engaged > 0.0 { self.within_limits(&lines, &wanted) } else { least };
        self.output.achieved = lines.wrench(&solved) - rest;
        let most = self.caps.map_or(0, |c| c.max_mn);
        let tension_mn = solved.map(|t| ((t * 1e3).round() as u16).min(most));
        self.send(Message::Command(Command { time_us: (self.clock * 1e6) as u64 as u32, tension_mn }));
    }

    /// Returns optimal tensions whose total force stays within the limit [N].
    fn within_limits(&mut self, lines: &Lines, wanted: &Wrench) -> [f64; STRINGS] {
        let Tensions { tension, achieved, .. } = self.solver.solve(lines, wanted);
        let least = self.solver.rule().min;
        let base = lines.wrench(&[least; STRINGS]).force;
        let share = share_within(base, achieved.force - base, self.capabilities.limits.force_n);
        tension.map(|t| least + share * (t - least))
    }
}

/// Returns a 32-bit time as a 64-bit time that continues after each wrap [µs].
fn unwrapped(last: u64, time_us: u32) -> u64 {
    let low = u64::from(u32::MAX);
    let time = (last & !low) | u64::from(time_us);
    if time + (1 << 31) < last { time + low + 1 } else { time }
}

/// Returns the largest share s ≤ 1 for which |a + s b| ≤ limit [-].
fn share_within(a: glam::DVec3, b: glam::DVec3, limit: f64) -> f64 {
    if (a + b).length() <= limit || b.length_squared() == 0.0 {
        return 1.0;
    }
    let (p, q) = (a.dot(b) / b.length_squared(), (a.length_squared() - limit * limit) / b.length_squared());
    (libm::sqrt((p * p - q).max(0.0)) - p).clamp(0.0, 1.0)
}

impl<L: Link> HapticDevice for Spidar<L> {
    fn capabilities(&self) -> &Capabilities {
        &self.capabilities
    }

    fn exchange(&mut self, command: &HapticCommand, dt: f64) -> HapticSample {
        self.clock += dt;
        let fresh = self.receive_frames();
        if self.health == Health::Stopped {
            return HapticSample { health: Health::Stopped, fresh: false, achieved: Wrench::ZERO, ..self.output };
        }
        if self.phase != Phase::Seeking && self.clock - self.received_at > SILENCE_S {
            self.refuse(Health::Lost);
        }
        match self.phase {
            Phase::Seeking => {
                self.engaged = 0.0;
                self.output.achieved = Wrench::ZERO;
                self.send_hello();
            }
            Phase::Arming => {}
            Phase::Linked => {
                self.health = match (&self.calibration, self.misfit) {
                    (Some(_), _) => Health::Running,
                    (None, true) => Health::Misfit,
                    (None, false) => Health::Uncalibrated,
                };
                self.send_tensions(command, dt);
            }
        }
        self.output.health = self.health;
        self.output.fresh = fresh;
        self.output
    }

    fn stop(&mut self) {
        self.send(Message::Stop);
        self.health = Health::Stopped;
    }

    fn strings(&self) -> Option<StringRig> {
        Some(self.geometry.rig())
    }

    fn remember(&mut self, memory: CalibrationMemory) {
        self.memory = Some(memory);
    }
}

impl<L> Spidar<L> {
    /// Returns the last pose of the pan.
    pub fn pose(&self) -> Pose {
        self.output.pose
    }
}
