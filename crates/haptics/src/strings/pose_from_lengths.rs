//! Where the body is, from the lengths of its strings.

use glam::DVec3;
use saute_kitchen::dynamics::Pose;
use saute_kitchen::dynamics::pose::about;

use crate::strings::linear::solve_symmetric;
use crate::strings::{Lines, STRINGS, StringRig};
use crate::wrench::Twist;

/// Steps at most in one estimate (chosen: from the last pose three suffice; after a jump more are needed).
const STEPS: usize = 12;
/// A step shorter than this ends the search [m] (chosen: far below an encoder's pitch).
const CONVERGED_M: f64 = 1e-8;
/// Damping over the mean of the diagonal [-] (chosen: tames singular poses, slows no other).
const DAMPING: f64 = 1e-5;
/// Longest step [m] and turn [rad] (chosen: the straight-line model holds so far).
const LONGEST_STEP: f64 = 0.05;
const LARGEST_TURN: f64 = 0.2;
/// Share of the residual that drift takes up in each estimate [-] (chosen: 100 s at 1 kHz; hands move faster, strings
/// creep more slowly).
const DRIFT_SHARE: f64 = 1e-5;
/// Bandwidth of the velocity [Hz] (chosen: above a wrist's 10 Hz, below a count's noise).
const VELOCITY_HZ: f64 = 40.0;
/// A longer gap than this makes a velocity meaningless [s] (chosen).
const GAP_S: f64 = 0.05;

/// Finds poses from lengths by damped Gauss–Newton, one after the other.
///
/// minimises Σ (|mᵢ − p − R gᵢ| − Lᵢ − dᵢ)² over p and R; with eight lengths for six unknowns, two are left over, from
/// which the slow drift dᵢ of encoders and strings is learned. Valid where the strings are taut and their directions
/// span all motions ([`crate::strings::workspace`]).
#[derive(Clone, Copy, Debug)]
pub struct PoseEstimator {
    rig: StringRig,
    pose: Pose,
    twist: Twist,
    drift: [f64; STRINGS],
    residual: f64,
}

impl PoseEstimator {
    /// Begins at a pose.
    pub fn new(rig: StringRig, start: Pose) -> Self {
        Self { rig, pose: start, twist: Twist::default(), drift: [0.0; STRINGS], residual: 0.0 }
    }

    /// The pose at which the strings have these lengths [m]; `dt` after the last one [s].
    pub fn update(&mut self, lengths: &[f64; STRINGS], dt: f64) -> Pose {
        if lengths.iter().all(|l| l.is_finite()) {
            let before = self.pose;
            self.solve(lengths);
            self.learn_drift(lengths);
            self.follow(&before, dt);
        }
        self.pose
    }

    fn solve(&mut self, lengths: &[f64; STRINGS]) {
        for _ in 0..STEPS {
            let lines = self.rig.lines(&self.pose);
            let Some((step, turn)) = self.step(&lines, lengths) else { return };
            self.pose.position += step.clamp_length_max(LONGEST_STEP);
            self.pose.rotation = (about(turn.clamp_length_max(LARGEST_TURN)) * self.pose.rotation).normalize();
            if step.length() < CONVERGED_M && turn.length() < CONVERGED_M {
                return;
            }
        }
    }

    /// One damped step: (AᵀA + σ) x = Aᵀ e, with the rows [direction, lever] and the errors predicted − measured.
    fn step(&self, lines: &Lines, lengths: &[f64; STRINGS]) -> Option<(DVec3, DVec3)> {
        let (mut a, mut b) = ([[0.0; 6]; 6], [0.0; 6]);
        for (i, measured) in lengths.iter().enumerate() {
            let (row, error) = (lines.column(i), lines.length[i] - measured - self.drift[i]);
            for r in 0..6 {
                b[r] += row[r] * error;
                (0..6).for_each(|c| a[r][c] += row[r] * row[c]);
            }
        }
        let (force, torque) = (a[0][0] + a[1][1] + a[2][2], a[3][3] + a[4][4] + a[5][5]);
        for (r, row) in a.iter_mut().enumerate() {
            row[r] += DAMPING / 3.0 * if r < 3 { force } else { torque };
        }
        solve_symmetric(&mut a, &mut b, 6).then(|| (DVec3::new(b[0], b[1], b[2]), DVec3::new(b[3], b[4], b[5])))
    }

    fn learn_drift(&mut self, lengths: &[f64; STRINGS]) {
        let predicted = self.rig.lengths(&self.pose);
        let mut squares = 0.0;
        for i in 0..STRINGS {
            let left = predicted[i] - lengths[i] - self.drift[i];
            self.drift[i] += DRIFT_SHARE * left;
            squares += left * left;
        }
        self.residual = libm::sqrt(squares / STRINGS as f64);
    }

    fn follow(&mut self, before: &Pose, dt: f64) {
        if dt <= 0.0 || dt > GAP_S {
            self.twist = Twist::default();
            return;
        }
        let turned = saute_kitchen::dynamics::pose::rotation_between(before.rotation, self.pose.rotation);
        let share = 1.0 - libm::exp(-dt * std::f64::consts::TAU * VELOCITY_HZ);
        let linear = (self.pose.position - before.position) / dt;
        self.twist.linear += (linear - self.twist.linear) * share;
        self.twist.angular += (turned / dt - self.twist.angular) * share;
    }

    /// The last pose.
    pub fn pose(&self) -> Pose {
        self.pose
    }

    /// Velocity, smoothed over some milliseconds [m/s, rad/s].
    pub fn twist(&self) -> Twist {
        self.twist
    }

    /// Root mean square of what eight lengths disagree about the pose [m].
    pub fn residual(&self) -> f64 {
        self.residual
    }

    /// Drift that was learned for each string [m].
    pub fn drift(&self) -> &[f64; STRINGS] {
        &self.drift
    }
}
