//! Safety rules: what no sound device does. A rule that fires stops the device until a hand resumes.

use crate::control::passivity::Passivity;
use crate::device::{HapticSample, Health, Limits};

/// Time for which lengths or force must be wrong [s] (chosen: three samples; one or two may be damaged on their way).
const PATIENCE_S: f64 = 0.003;
/// Share of the time of sound samples by which wrong time is forgotten [-] (chosen: three wrong samples within 0.3 s still fire,
/// as one in twenty at random does).
const FORGETTING: f64 = 0.01;
/// Longest time that one step counts [s] (chosen: one step at 1 kHz; a late host is no fault of the device).
const LONGEST_STEP_S: f64 = 0.001;
/// Reported force over the limit that counts as wrong [-] (chosen: a tenth, more than rounding and the lag of motors).
const FORCE_MARGIN: f64 = 1.1;
/// Rounding of summed times [s] (chosen: far below a step).
const ROUNDING_S: f64 = 1e-9;

/// Judges each step of the control loop.
#[derive(Clone, Copy, Debug)]
pub struct SafetyWatch {
    force_n: f64,
    lengths: WrongTime,
    force: WrongTime,
}

/// Time for which a condition was wrong, which is slowly forgotten [s].
#[derive(Clone, Copy, Debug, Default)]
struct WrongTime(f64);

impl WrongTime {
    /// Counts a step; returns true if the condition was wrong for too long.
    fn count(&mut self, wrong: bool, dt: f64) -> bool {
        let change = if wrong { dt } else { -FORGETTING * dt };
        self.0 = (self.0 + change).max(0.0);
        self.0 >= PATIENCE_S - ROUNDING_S
    }
}

/// Returns true for a value above its limit, and for one that is no number.
fn is_above(value: f64, limit: f64) -> bool {
    value > limit || value.is_nan()
}

impl SafetyWatch {
    /// Creates a watch over a device with limits.
    pub fn new(limits: &Limits) -> Self {
        Self { force_n: limits.force_n, lengths: WrongTime::default(), force: WrongTime::default() }
    }

    /// Judges a sample and the energy account after a step of `dt` [s]; returns the fault of the first rule that fires.
    pub fn judge(&mut self, sample: &HapticSample, passivity: &Passivity, dt: f64) -> Option<Health> {
        let dt = dt.clamp(0.0, LONGEST_STEP_S);
        let lengths = self.lengths.count(is_above(sample.length_misfit, 1.0), dt);
        let force = self.force.count(is_above(sample.total_force_n, FORCE_MARGIN * self.force_n), dt);
        let fired = [
            (lengths, Health::ImpossibleLengths),
            (force, Health::ForceAboveLimit),
            (passivity.is_overdrawn(), Health::EnergyOverdrawn),
        ];
        fired.into_iter().find(|(fired, _)| *fired).map(|(_, fault)| fault)
    }
}
