//! Gestures: scripted motions of the pan for shaking and tossing.

use core::f64::consts::TAU;

use glam::{DQuat, DVec3};
use serde::{Deserialize, Serialize};

use super::pan_motion::PanTarget;
use super::pose::{Pose, turn};

/// A scripted motion of the pan about the pose at which it is held.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub enum Gesture {
    /// Oscillation left and right.
    Shake {
        /// Amplitude to either side [m].
        amplitude: f64,
        /// Frequency [1/s].
        hz: f64,
        /// Duration [s].
        for_s: f64,
    },
    /// A jerk that throws the food up, turns it over and catches it.
    Toss {
        /// Height of the food's flight [m].
        height: f64,
    },
}

/// Key frame of a toss: time [s], displacement of the pan's centre forwards and upwards [m], and tilt, far edge up
/// [rad].
type Moment = [f64; 4];

impl Gesture {
    /// Duration [s].
    pub fn duration_s(&self) -> f64 {
        match *self {
            Self::Shake { for_s, .. } => for_s,
            Self::Toss { height } => toss(height).last().map_or(0.0, |m| m[0]),
        }
    }

    /// Target of the pan at a time since the start [s]; `home` is the pose at which the pan is held.
    pub fn target(&self, home: &Pose, t: f64) -> PanTarget {
        match *self {
            Self::Shake { amplitude, hz, for_s } => shake(home, amplitude, hz, for_s, t),
            Self::Toss { height } => along(home, &toss(height), t),
        }
    }
}

/// Sine with smooth ramps of half a period at start and end.
fn shake(home: &Pose, amplitude: f64, hz: f64, for_s: f64, t: f64) -> PanTarget {
    let ramp = (0.5 / hz.max(0.1)).min(0.5 * for_s).max(1e-6);
    let edge = (t.min(for_s - t) / ramp).clamp(0.0, 1.0);
    let (envelope, slope) = (edge * edge * (3.0 - 2.0 * edge), 6.0 * edge * (1.0 - edge) / ramp);
    let slope = if t < 0.5 * for_s { slope } else { -slope };
    let (sin, cos) = libm::sincos(TAU * hz * t);
    let x = amplitude * envelope * sin;
    let v = amplitude * (slope * sin + envelope * TAU * hz * cos);
    let a = -amplitude * envelope * (TAU * hz) * (TAU * hz) * sin;
    PanTarget {
        pose: Pose { position: home.position + DVec3::X * x, ..*home },
        velocity: DVec3::X * v,
        acceleration: DVec3::X * a,
        turning: DVec3::ZERO,
    }
}

/// Height of the flight of an unscaled [`toss`] [m] (measured on coins, shrimps and a steak: 0.20 to 0.39 m).
const TOSSED: f64 = 0.25;

/// Key frames of a toss: the pan moves back with its far edge up, then forwards, jerks up and tilts back, and returns
/// under the falling food (found by a random search for the trajectory that turns over most of eleven coins, twelve
/// shrimps and a steak and loses none: 100 %, 83 % and 100 % at that height).
fn toss(height: f64) -> Vec<Moment> {
    let lift = libm::sqrt(height / TOSSED).clamp(0.4, 1.5);
    vec![
        [0.000, 0.000, 0.000, 0.00],
        [0.241, -0.023, 0.019, 0.17],
        [0.409, 0.065, 0.000, 0.05],
        [0.523, 0.027, 0.166 * lift, 0.69 * lift],
        [0.721, -0.106, 0.080, 0.41],
        [0.971, 0.000, 0.004, 0.00],
        [1.221, 0.000, 0.000, 0.00],
    ]
}

/// Catmull–Rom spline through the key frames, in the vertical plane that points away from the cook.
fn along(home: &Pose, moments: &[Moment], t: f64) -> PanTarget {
    let last = moments.len() - 1;
    let i = moments.iter().rposition(|m| m[0] <= t).unwrap_or(0).min(last - 1);
    let slope = |k: usize, axis: usize| {
        if k == 0 || k == last {
            return 0.0;
        }
        (moments[k + 1][axis] - moments[k - 1][axis]) / (moments[k + 1][0] - moments[k - 1][0])
    };
    let span = moments[i + 1][0] - moments[i][0];
    let s = ((t - moments[i][0]) / span).clamp(0.0, 1.0);
    let value = |axis: usize| {
        let (p, q) = (moments[i][axis], moments[i + 1][axis]);
        let (m, n) = (slope(i, axis) * span, slope(i + 1, axis) * span);
        let (s2, s3) = (s * s, s * s * s);
        let at = p * (2.0 * s3 - 3.0 * s2 + 1.0) + m * (s3 - 2.0 * s2 + s) + q * (3.0 * s2 - 2.0 * s3) + n * (s3 - s2);
        let speed = p * (6.0 * s2 - 6.0 * s)
            + m * (3.0 * s2 - 4.0 * s + 1.0)
            + q * (6.0 * s - 6.0 * s2)
            + n * (3.0 * s2 - 2.0 * s);
        let bend = p * (12.0 * s - 6.0) + m * (6.0 * s - 4.0) + q * (6.0 - 12.0 * s) + n * (6.0 * s - 2.0);
        [at, speed / span, bend / (span * span)]
    };
    let (y, z, tilt) = (value(1), value(2), value(3));
    PanTarget {
        pose: Pose {
            position: home.position + DVec3::new(0.0, y[0], z[0].max(0.0)),
            rotation: (turn(DVec3::X, tilt[0]) * home.rotation).normalize(),
        },
        velocity: DVec3::new(0.0, y[1], z[1]),
        acceleration: DVec3::new(0.0, y[2], z[2]),
        turning: DVec3::X * tilt[1],
    }
}

/// Orientation of a pan tilted by an angle towards an azimuth, from +x towards +y [rad].
pub fn tilt(angle: f64, towards: f64) -> DQuat {
    let (sin, cos) = libm::sincos(towards);
    // The axis is horizontal and at right angles to the direction.
    turn(DVec3::new(-sin, cos, 0.0), angle)
}

#[cfg(test)]
mod tests {
    use core::f64::consts::PI;

    use super::*;
    use crate::dynamics::PanShape;

    #[test]
    fn a_shake_starts_and_ends_at_home_and_reaches_its_amplitude() {
        let home = Pose::at(0.0, 0.0, 0.002);
        let shake = Gesture::Shake { amplitude: 0.02, hz: 3.0, for_s: 4.0 };
        let x = |t: f64| shake.target(&home, t).pose.position.x;
        assert!(x(0.0).abs() < 1e-12 && x(4.0).abs() < 1e-12);
        let most = (0..4000).map(|i| x(f64::from(i) * 1e-3)).fold(0.0, f64::max);
        assert!((most - 0.02).abs() < 1e-4, "{most}");
        for i in 1..4000 {
            let t = f64::from(i) * 1e-3;
            let v = (x(t + 1e-5) - x(t - 1e-5)) / 2e-5;
            assert!((shake.target(&home, t).velocity.x - v).abs() < 2e-3, "{t}");
        }
    }

    #[test]
    fn a_tilted_pan_is_lower_on_the_side_it_is_tilted_to() {
        let shape = PanShape { floor: 0.1, rim: 0.13, height: 0.04, thickness: 0.0 };
        let pan = shape.standing([0.0; 2], 0.0, tilt(0.3, 0.5 * PI));
        let far = pan.to_world(DVec3::new(0.0, 0.1, 0.0));
        let near = pan.to_world(DVec3::new(0.0, -0.1, 0.0));
        assert!(far.z.abs() < 1e-12 && near.z > 0.05, "{far} {near}");
    }
}
