//! Toss detection: acceleration integrated twice, with a leak back to home.

use glam::DVec3;

/// Time constant of the sensor's offset [s] (chosen: longer than a toss, shorter than the sensor's warm-up).
const OFFSET_S: f64 = 3.0;
/// Rate of the leak [rad/s] (chosen: three quarters of a toss of 0.25 s pass, and 4 s later the pan is home).
const LEAK: f64 = 1.0;

/// Displacement of the pan by x″ = a_h − 2ω x′ − ω² x with ω = 1 rad/s; a_h is the acceleration minus its mean over 3 s [m].
///
/// The filter integrates twice above ω/2π = 0.16 Hz and returns home below it; a constant sensor offset has no effect. The
/// displacement stops at the workspace's bounds.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Toss {
    /// Displacement from home [m].
    pub place: DVec3,
    /// Velocity [m/s].
    pub velocity: DVec3,
    offset: DVec3,
}

impl Toss {
    /// Advances by `dt` [s] under an acceleration [m/s²]; `None` if it is unknown. `half` is the workspace's half width [m].
    pub fn step(&mut self, push: Option<DVec3>, half: DVec3, dt: f64) {
        let push = push.filter(|p| p.is_finite());
        let free = push.map_or(DVec3::ZERO, |p| p - self.offset);
        if let Some(push) = push {
            self.offset += (push - self.offset) * (1.0 - libm::exp(-dt / OFFSET_S));
        }
        self.velocity += (free - self.velocity * (2.0 * LEAK) - self.place * (LEAK * LEAK)) * dt;
        self.place += self.velocity * dt;
        for axis in 0..3 {
            if self.place[axis].abs() > half[axis] {
                self.place[axis] = self.place[axis].clamp(-half[axis], half[axis]);
                self.velocity[axis] = 0.0;
            }
        }
    }
}
