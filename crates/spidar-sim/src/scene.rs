//! The physical scene: strings, pan and hand, first on the jig and then free.

use glam::{DQuat, DVec3};

use crate::arm::Arm;
use crate::pan_body::PanBody;
use crate::random::Random;
use crate::rig::{Pose, Rig};
use crate::rig_file::RigFile;
use crate::string_drive::StringDrive;

/// Time step [s] (chosen: a sixth of the motor currents' time constant).
const STEP_S: f64 = 2e-4;
/// Time that the pan is in each place of the jig [s] (chosen: the fifth of a second that the protocol requires).
const STANDING_S: f64 = 0.2;
/// Time between two places of the jig [s] (chosen: short, so that a test need not wait).
const MOVING_S: f64 = 0.05;
/// Position error of the jig's pins [m] (chosen: reamed holes).
const JIG_ERROR: f64 = 10e-6;
/// Maximum number of steps per call (chosen: one second; time lost in a longer sleep is skipped).
const MOST_STEPS: u32 = 5000;

/// Jitter of an encoder per unit of noise above 1 [counts] (chosen: half a count, as much as counting in whole numbers leaves out).
const JITTER: f64 = 0.5;

/// How a device was made, and what moves it.
#[derive(Clone, Copy, Debug)]
pub struct Making {
    /// Seed of manufacturing errors, encoder zeros and the hand's motion.
    pub seed: u64,
    /// Largest manufacturing error of each coordinate of motors and attachments [m].
    pub error_m: f64,
    /// Amplitude of the hand's motion: 0 is still, 1 shakes and tilts [-].
    pub hand: f64,
    /// Multiple of the usual noise: friction, errors of string stiffness and jig, and jitter of the encoders above 1 [-].
    pub noise: f64,
}

/// The physical side of the device.
#[derive(Clone, Debug)]
pub struct Scene {
    rig: Rig,
    pub drives: [StringDrive; 8],
    pub pan: PanBody,
    arm: Arm,
    jig: Vec<Pose>,
    /// Time on the jig; none once the pan has left it [s].
    jigging: Option<f64>,
    waiting: bool,
    random: Random,
    owed: f64,
    /// Jitter of an encoder [counts].
    jitter: f64,
}

impl Scene {
    /// Creates a device that is on the first place of its jig until it is armed.
    pub fn new(file: &RigFile, making: &Making) -> Self {
        let (mut random, noise) = (Random::seeded(making.seed), making.noise);
        let rig = Rig::built(file, making.error_m, &mut random);
        let arm = Arm::new(&file.workspace, making.hand, &mut random);
        let jig: Vec<Pose> = file.jig.pose.iter().map(|p| placed(p, noise * JIG_ERROR, &mut random)).collect();
        let start = jig.first().copied().unwrap_or(arm.home());
        let drives =
            std::array::from_fn(|i| StringDrive::new(&file.drive, rig.string(i, &start).length(), noise, &mut random));
        let jitter = JITTER * (noise - 1.0).max(0.0);
        let pan = PanBody::new(file.grip.real_mass_kg, start);
        Self { rig, drives, pan, arm, jig, jigging: Some(0.0), waiting: true, random, owed: 0.0, jitter }
    }

    /// Starts the calibration when the host arms the device.
    pub fn armed(&mut self) {
        self.waiting = false;
    }

    /// Simulates a power cycle: the encoders lose their count and the pan returns to the jig.
    pub fn power_cycle(&mut self) {
        self.drives.iter_mut().for_each(|d| d.lose_count(&mut self.random));
        self.jigging = Some(0.0);
        self.waiting = true;
    }

    /// Returns the jig place whose contact is closed, counted from 1; 0 for none.
    pub fn jig_contact(&self) -> u8 {
        let Some(time) = self.jigging else { return 0 };
        let (place, within) = ((time / (STANDING_S + MOVING_S)) as usize, time % (STANDING_S + MOVING_S));
        if within < STANDING_S && place < self.jig.len() { place as u8 + 1 } else { 0 }
    }

    /// Advances the scene [s].
    pub fn advance(&mut self, seconds: f64) {
        self.owed += seconds;
        let mut steps = 0;
        while self.owed >= STEP_S && steps < MOST_STEPS {
            self.owed -= STEP_S;
            steps += 1;
            self.step();
        }
        if steps == MOST_STEPS {
            self.owed = 0.0;
        }
    }

    fn step(&mut self) {
        match self.jigging {
            Some(time) => self.stand_on_jig(time),
            None => {
                let (mut force, mut torque) = self.arm.pull(&self.pan, STEP_S);
                let (strings, twist) = self.wrench();
                force += strings;
                torque += twist;
                self.pan.step(force, torque, STEP_S);
            }
        }
        for i in 0..8 {
            let length = self.rig.string(i, &self.pan.pose).length();
            self.drives[i].step(length, STEP_S);
        }
    }

    fn stand_on_jig(&mut self, time: f64) {
        let place = (time / (STANDING_S + MOVING_S)) as usize;
        if let Some(pose) = self.jig.get(place) {
            self.pan.pose = *pose;
            self.jigging = Some(if self.waiting { time } else { time + STEP_S });
        } else {
            self.pan.pose = self.arm.home();
            (self.pan.velocity, self.pan.turning) = (DVec3::ZERO, DVec3::ZERO);
            self.arm.begin();
            self.jigging = None;
        }
    }

    /// Returns the true force and torque of the strings about the pan's origin [N, N·m].
    pub fn wrench(&self) -> (DVec3, DVec3) {
        let pulls = (0..8).map(|i| self.rig.pull(i, &self.pan.pose, self.drives[i].tension()));
        pulls.fold((DVec3::ZERO, DVec3::ZERO), |(f, t), (force, torque)| (f + force, t + torque))
    }

    /// Returns the encoder counts.
    pub fn counts(&mut self) -> [i32; 8] {
        std::array::from_fn(|i| {
            let jitter = if self.jitter > 0.0 { self.jitter * self.random.signed() } else { 0.0 };
            self.drives[i].count(jitter)
        })
    }

    /// Returns true if the pan is in the hand.
    pub fn is_free(&self) -> bool {
        self.jigging.is_none()
    }
}

/// Returns a jig place with its manufacturing error [m].
fn placed(p: &[f64; 6], error: f64, random: &mut Random) -> Pose {
    let off = DVec3::new(random.signed(), random.signed(), random.signed()) * error;
    let turn = DVec3::new(p[3], p[4], p[5]) * (std::f64::consts::PI / 180.0);
    Pose { position: DVec3::new(p[0], p[1], p[2]) * 1e-3 + off, rotation: DQuat::from_scaled_axis(turn) }
}
