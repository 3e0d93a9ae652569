//! A person's arm: a mechanical impedance that follows a target motion.

use glam::{DQuat, DVec3};

use crate::pan_body::PanBody;
use crate::random::Random;
use crate::rig::Pose;
use crate::rig_file::Workspace;

/// Stiffness of an arm that holds an object [N/m] (chosen: published values are 200–600 N/m).
const STIFFNESS: f64 = 350.0;
/// Damping of that arm [N·s/m] (chosen: published values are 5–40 N·s/m).
const DAMPING: f64 = 20.0;
/// Rotational stiffness [N·m/rad] (chosen: the stiffness over a lever of 15 cm, a forearm's grip).
const TURN_STIFFNESS: f64 = 8.0;
/// Rotational damping [N·m·s/rad] (chosen: three quarters of critical for the shipped pan).
const TURN_DAMPING: f64 = 0.35;
/// Rate at which a person compensates a constant load [1/s] (chosen: within half a second, as people lift unknown weights).
const ADAPTATION: f64 = 2.0;
/// Number of sine waves in the motion (chosen: enough to look irregular).
const WAVES: usize = 4;
/// Lowest frequency of the motion [Hz] (chosen: moving the pan about).
const SLOWEST: f64 = 0.15;
/// Highest frequency of the motion [Hz] (chosen: shaking the pan).
const FASTEST: f64 = 1.6;
/// Time in which the motion fades in [s] (chosen: without a jerk when the pan leaves the jig).
const BEGINNING_S: f64 = 1.0;

#[derive(Clone, Copy, Debug)]
struct Wave {
    linear: DVec3,
    turn: DVec3,
    rate: f64,
    phase: f64,
}

/// An arm with a seeded target motion.
#[derive(Clone, Debug)]
pub struct Arm {
    home: DVec3,
    waves: [Wave; WAVES],
    since: f64,
    load: DVec3,
}

impl Arm {
    /// Creates an arm that moves through a share of the workspace.
    pub fn new(workspace: &Workspace, liveliness: f64, random: &mut Random) -> Self {
        let half = DVec3::from_array(workspace.half_mm) * 1e-3;
        let tilt = workspace.tilt_deg.to_radians();
        let mut vector = || DVec3::new(random.signed(), random.signed(), random.signed());
        let waves = std::array::from_fn(|i| {
            let share = i as f64 / (WAVES - 1) as f64;
            let rate = SLOWEST * libm::pow(FASTEST / SLOWEST, share) * std::f64::consts::TAU;
            // Slow waves have large amplitudes and fast ones small, like hand motion.
            let size = liveliness * 0.45 / (1.0 + 3.0 * share);
            let (linear, turn) = (vector() * half * size, vector() * DVec3::new(1.0, 1.0, 0.5) * tilt * size);
            Wave { linear, turn, rate, phase: std::f64::consts::PI * vector().x }
        });
        Self { home: DVec3::from_array(workspace.home_mm) * 1e-3, waves, since: 0.0, load: DVec3::ZERO }
    }

    /// Returns the target position [m] and rotation vector [rad].
    fn target(&self) -> (DVec3, DVec3) {
        let begun = (self.since / BEGINNING_S).min(1.0);
        let (mut linear, mut turn) = (DVec3::ZERO, DVec3::ZERO);
        for wave in &self.waves {
            let s = begun * libm::sin(wave.rate * self.since + wave.phase);
            linear += wave.linear * s;
            turn += wave.turn * s;
        }
        (self.home + linear, turn)
    }

    /// Returns force and torque on the pan; its weight is already compensated [N, N·m].
    pub fn pull(&mut self, pan: &PanBody, dt: f64) -> (DVec3, DVec3) {
        let (place, turn) = self.target();
        self.since += dt;
        let off = place - pan.pose.position;
        self.load = (self.load + off * (STIFFNESS * ADAPTATION * dt)).clamp_length_max(40.0);
        let twist = (DQuat::from_scaled_axis(turn) * pan.pose.rotation.conjugate()).to_scaled_axis();
        let twist = if twist.length() > std::f64::consts::PI { DVec3::ZERO } else { twist };
        (off * STIFFNESS - pan.velocity * DAMPING + self.load, twist * TURN_STIFFNESS - pan.turning * TURN_DAMPING)
    }

    /// Restarts the motion.
    pub fn begin(&mut self) {
        self.since = 0.0;
        self.load = DVec3::ZERO;
    }

    /// Returns the pose at the start.
    pub fn home(&self) -> Pose {
        Pose { position: self.home, rotation: DQuat::IDENTITY }
    }
}
