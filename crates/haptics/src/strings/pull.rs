//! The tensions that are commanded: preload, wrench, and every limit between the requested wrench and the motors.

use crate::strings::geometry::Geometry;
use crate::strings::tension::{TensionSolver, Tensions};
use crate::strings::{Lines, STRINGS};
use crate::wrench::Wrench;

/// Time in which the preload builds up [s] (chosen: a gentle pull).
const PRELOAD_UP_S: f64 = 0.5;
/// Time in which the preload is released [s] (chosen: quick, but without a jerk).
const PRELOAD_DOWN_S: f64 = 0.2;
/// Number of commands in which all tensions are released after a fault (chosen: the last one is sent 2 ms after the first).
const RELEASE_COMMANDS: f64 = 3.0;

/// Commanded tensions, and the wrench that they make.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pulled {
    /// Tension of each string [mN].
    pub tension_mn: [u16; STRINGS],
    /// Wrench beyond the empty device, after every limit [N, N·m].
    pub achieved: Wrench,
}

/// Turns wrenches into tensions.
#[derive(Clone, Copy, Debug)]
pub struct Pull {
    solver: TensionSolver,
    preload: Wrench,
    force_n: f64,
    /// Largest change of a tension per second [N/s], and per command [N].
    slew: [f64; 2],
    /// Share of the preload, 0 to 1 [-].
    engaged: f64,
    /// Last commanded tensions, and those before them [mN].
    sent: [u16; STRINGS],
    before: [u16; STRINGS],
}

impl Pull {
    /// Creates the tensions of a device that pulls with its least tensions.
    pub fn new(geometry: &Geometry) -> Self {
        let solver = TensionSolver::new(geometry.tension_rule());
        let slew = [geometry.limits.slew_n_s, geometry.limits.slew_n_s / geometry.drive.rate_hz];
        let least = [in_mn(solver.rule().min); STRINGS];
        let (preload, force_n) = (geometry.preload(), geometry.limits.force_n);
        Self { solver, preload, force_n, slew, engaged: 0.0, sent: least, before: least }
    }

    /// Restarts from the least tensions, which a device keeps when it is armed.
    pub fn rest(&mut self) {
        let least = [in_mn(self.solver.rule().min); STRINGS];
        (self.engaged, self.sent, self.before) = (0.0, least, least);
    }

    /// Returns the tensions for a wrench, or for none; the preload builds up and decays gradually. `most_mn` is the largest
    /// tension of the device [mN], `dt` the time since the last command [s].
    pub fn tensions(&mut self, lines: &Lines, wanted: Option<Wrench>, most_mn: u16, dt: f64) -> Pulled {
        let change = if wanted.is_some() { dt / PRELOAD_UP_S } else { -dt / PRELOAD_DOWN_S };
        self.engaged = (self.engaged + change).clamp(0.0, 1.0);
        let least = [self.solver.rule().min; STRINGS];
        // The empty device itself moves from minimum tensions to its preload: that is not work of the rendered wrench.
        let rest = lines.wrench(&least) * (1.0 - self.engaged) + self.preload * self.engaged;
        let wrench = wanted.unwrap_or(Wrench::ZERO) + rest;
        let solved = if self.engaged > 0.0 { self.within_force(lines, &wrench) } else { least };
        self.before = self.sent;
        self.sent = self.within_slew(&solved, most_mn, dt);
        Pulled { tension_mn: self.sent, achieved: lines.wrench(&in_n(&self.sent)) - rest }
    }

    /// Returns the next tensions of a release: all are least at the third call at the latest, and change no faster than that needs.
    pub fn release(&mut self) -> [u16; STRINGS] {
        let rule = self.solver.rule();
        let least = in_mn(rule.min);
        let step = libm::ceil(1e3 * self.slew[1].max((rule.max - rule.min) / RELEASE_COMMANDS)) as u16;
        for i in 0..STRINGS {
            // The first release replaces the command of the same millisecond, so it counts from the command before that.
            self.sent[i] = self.sent[i].min(self.before[i].saturating_sub(step)).max(least);
        }
        self.before = self.sent;
        self.sent
    }

    /// Returns true if all tensions are least.
    pub fn is_released(&self) -> bool {
        self.sent.iter().all(|t| *t <= in_mn(self.solver.rule().min))
    }

    /// Returns optimal tensions whose total force stays within the limit [N].
    fn within_force(&mut self, lines: &Lines, wanted: &Wrench) -> [f64; STRINGS] {
        let Tensions { tension, achieved, .. } = self.solver.solve(lines, wanted);
        let least = self.solver.rule().min;
        let base = lines.wrench(&[least; STRINGS]).force;
        let share = share_within(base, achieved.force - base, self.force_n);
        tension.map(|t| least + share * (t - least))
    }

    /// Returns tensions on the way to the requested ones that no string passes faster than the slew rate allows [mN].
    ///
    /// All strings go the same share of their way: between two allowed sets of tensions all are allowed.
    fn within_slew(&self, wanted: &[f64; STRINGS], most_mn: u16, dt: f64) -> [u16; STRINGS] {
        let step_mn = 1e3 * (self.slew[0] * dt.max(0.0)).min(self.slew[1]);
        let way: [f64; STRINGS] = std::array::from_fn(|i| wanted[i] * 1e3 - f64::from(self.sent[i]));
        let longest = way.iter().fold(0.0f64, |longest, w| longest.max(w.abs()));
        let share = if longest > step_mn { step_mn / longest } else { 1.0 };
        std::array::from_fn(|i| {
            let (from, most) = (f64::from(self.sent[i]), libm::floor(step_mn));
            let to = libm::round(from + share * way[i]).clamp(from - most, from + most);
            (to as u16).min(most_mn)
        })
    }
}

fn in_mn(tension_n: f64) -> u16 {
    libm::round(tension_n * 1e3) as u16
}

fn in_n(tension_mn: &[u16; STRINGS]) -> [f64; STRINGS] {
    tension_mn.map(|t| f64::from(t) * 1e-3)
}

/// Returns the largest share s ≤ 1 for which |a + s b| ≤ limit [-].
fn share_within(a: glam::DVec3, b: glam::DVec3, limit: f64) -> f64 {
    if (a + b).length() <= limit || b.length_squared() == 0.0 {
        return 1.0;
    }
    let (p, q) = (a.dot(b) / b.length_squared(), (a.length_squared() - limit * limit) / b.length_squared());
    (libm::sqrt((p * p - q).max(0.0)) - p).clamp(0.0, 1.0)
}
