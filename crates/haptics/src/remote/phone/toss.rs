//! How far a phone has been pushed: acceleration integrated twice, leaking back to home.

use glam::DVec3;

/// Slower changes than this count as the sensor's offset [s] (chosen: longer than a toss, shorter than a warm-up).
const OFFSET_S: f64 = 3.0;
/// Rate with which the place leaks home [rad/s] (chosen: a toss of a quarter of a second passes by three quarters, and 4 s later the
/// pan is home).
const LEAK: f64 = 1.0;

/// Where the pan has been pushed, by x″ = a_h − 2ω x′ − ω² x with ω = 1 rad/s, where a_h is the acceleration less its mean over 3 s.
///
/// That is a double integration above ω/2π = 0.16 Hz and a way home below it; a sensor's steady offset moves nothing. At
/// the workspace's bounds the place stops.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Toss {
    /// From home [m].
    pub place: DVec3,
    /// Its velocity [m/s].
    pub velocity: DVec3,
    offset: DVec3,
}

impl Toss {
    /// One step of `dt` [s] under an acceleration [m/s²]; none where it is not known.
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
