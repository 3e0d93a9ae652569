//! Pose estimation: the body's pose from its string lengths.

use glam::DVec3;
use saute_kitchen::dynamics::Pose;
use saute_kitchen::dynamics::pose::about;

use crate::strings::linear::solve_symmetric;
use crate::strings::{Lines, STRINGS, StringRig};
use crate::wrench::Twist;

/// Maximum number of Gauss–Newton steps (chosen: three suffice from the last pose; a jump needs more).
const STEPS: usize = 12;
/// Step length that ends the iteration [m] (chosen: far below an encoder's pitch).
const CONVERGED_M: f64 = 1e-8;
/// Damping over the mean of the diagonal [-] (chosen: regularises singular poses and slows no other).
const DAMPING: f64 = 1e-5;
/// Longest translation step [m] (chosen: within it the linearisation is valid).
const LONGEST_STEP: f64 = 0.05;
/// Largest rotation step [rad] (chosen: within it the linearisation is valid).
const LARGEST_TURN: f64 = 0.2;
/// Share of the residual that the drift estimate absorbs per update [-] (chosen: a time constant of 100 s at 1 kHz; hands move
/// faster, strings creep more slowly).
const DRIFT_SHARE: f64 = 1e-5;
/// Bandwidth of the velocity filter [Hz] (chosen: above a wrist's 10 Hz, below the encoders' quantisation noise).
const VELOCITY_HZ: f64 = 40.0;
/// Longest gap between two updates that still gives a velocity [s] (chosen: fifty samples; a hand may have turned round by then).
const GAP_S: f64 = 0.05;

/// Estimates poses from lengths by damped Gauss–Newton, each from the last one.
///
/// It minimises Σ (|mᵢ − p − R gᵢ| − Lᵢ − dᵢ)² over p and R. Eight lengths overdetermine six unknowns; the residual gives the
/// slow drift dᵢ of encoders and strings. Valid where the strings are taut and their directions span all motions
/// ([`crate::strings::workspace`]).
///
/// ```
/// use saute_haptics::{PoseEstimator, library};
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let devices = library::devices()?;
/// let geometry = &devices["spidar-pan-crossed"];
/// let mut pose = geometry.home();
/// pose.position.x += 0.05;
/// let lengths = geometry.rig().lengths(&pose);
/// let found = PoseEstimator::new(geometry.rig(), geometry.home()).update(&lengths, 1e-3);
/// assert!((found.position - pose.position).length() < 1e-6, "{} m", found.position);
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Copy, Debug)]
pub struct PoseEstimator {
    rig: StringRig,
    pose: Pose,
    twist: Twist,
    drift: [f64; STRINGS],
    residual: f64,
}

impl PoseEstimator {
    /// Creates an estimator that starts at a pose.
    pub fn new(rig: StringRig, start: Pose) -> Self {
        Self { rig, pose: start, twist: Twist::default(), drift: [0.0; STRINGS], residual: 0.0 }
    }

    /// Returns the pose for string lengths [m]; `dt` is the time since the last update [s]. Lengths that are not finite are ignored.
    pub fn update(&mut self, lengths: &[f64; STRINGS], dt: f64) -> Pose {
        if lengths.iter().all(|l| l.is_finite()) {
            let before = self.pose;
            self.solve(lengths);
            self.update_drift(lengths);
            self.update_twist(&before, dt);
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

    /// Returns one damped step: (AᵀA + σ) x = Aᵀ e with the rows [direction, lever] and e = predicted − measured length.
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

    fn update_drift(&mut self, lengths: &[f64; STRINGS]) {
        let predicted = self.rig.lengths(&self.pose);
        let mut squares = 0.0;
        for i in 0..STRINGS {
            let left = predicted[i] - lengths[i] - self.drift[i];
            self.drift[i] += DRIFT_SHARE * left;
            squares += left * left;
        }
        self.residual = libm::sqrt(squares / STRINGS as f64);
    }

    fn update_twist(&mut self, before: &Pose, dt: f64) {
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

    /// Returns the last pose.
    pub fn pose(&self) -> Pose {
        self.pose
    }

    /// Returns the low-pass filtered twist [m/s, rad/s].
    pub fn twist(&self) -> Twist {
        self.twist
    }

    /// Returns the root mean square residual of the eight lengths [m].
    pub fn residual(&self) -> f64 {
        self.residual
    }

    /// Returns the estimated drift of each string [m].
    pub fn drift(&self) -> &[f64; STRINGS] {
        &self.drift
    }
}
