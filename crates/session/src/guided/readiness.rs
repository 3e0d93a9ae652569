//! Whether this machine keeps the speed of a study with its food: it is tried before anybody agrees to anything.

use saute_study::{Pace, PaceMeter};

/// Wall time of a trial run that is not measured [s] (chosen: shaders are compiled, and the quality of the picture settles).
const WARM_UP_S: f64 = 2.0;
/// Wall time that is measured [s] (chosen: so many samples that one slow moment does not decide).
const MEASURED_S: f64 = 5.0;

/// What is known of the machine.
#[derive(Clone, Debug)]
pub enum Readiness {
    /// Nothing yet.
    Untried,
    /// The food is cooked at the speed of the study, and what is held is measured.
    Tried(TrialRun),
    /// It keeps the speed.
    Holds(Pace),
    /// No trial is to come, or somebody has tried the machine.
    NotNeeded,
    /// It does not hold the speed.
    TooSlow(Pace),
}

/// A trial run of the machine.
#[derive(Clone, Debug)]
pub struct TrialRun {
    speed: f64,
    warm_s: f64,
    meter: PaceMeter,
}

impl TrialRun {
    /// Begins at a speed [-].
    pub fn at(speed: f64) -> Self {
        Self { speed, warm_s: 0.0, meter: PaceMeter::at(speed) }
    }

    /// The speed that is tried [-].
    pub fn speed(&self) -> f64 {
        self.speed
    }

    /// So much wall time and simulated time has passed [s]; returns what was found, once it has lasted long enough.
    pub fn pass(&mut self, wall_s: f64, simulated_s: f64) -> Option<Readiness> {
        if self.warm_s < WARM_UP_S {
            self.warm_s += wall_s;
            return None;
        }
        self.meter.pass(wall_s, simulated_s);
        let wall_s = self.meter.wall_s();
        if wall_s < MEASURED_S {
            return None;
        }
        self.meter.pace().map(|pace| Readiness::of(pace, wall_s))
    }
}

impl Readiness {
    fn of(pace: Pace, wall_s: f64) -> Self {
        if pace.holds(wall_s) { Self::Holds(pace) } else { Self::TooSlow(pace) }
    }

    /// By what was measured elsewhere.
    pub(super) fn known(pace: Pace) -> Self {
        Self::of(pace, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A trial run whose frames take some wall time, on a machine that computes so much of five times real time [-].
    fn found(frame_s: f64, share: f64) -> (usize, Readiness) {
        let mut run = TrialRun::at(5.0);
        let frames = (1..1000).map(|frame| (frame, run.pass(frame_s, 5.0 * share * frame_s)));
        let found = frames.filter_map(|(frame, found)| Some((frame, found?))).next();
        found.expect("it comes to an end")
    }

    #[test]
    fn a_machine_that_holds_the_speed_passes_after_seven_seconds_however_slowly_it_draws() {
        for frame_s in [0.05, 0.25] {
            let (frames, found) = found(frame_s, 1.0);
            assert!(matches!(found, Readiness::Holds(_)), "{found:?}");
            assert!((frames as f64 * frame_s - WARM_UP_S - MEASURED_S).abs() < 2.0 * frame_s);
        }
    }

    #[test]
    fn a_machine_that_does_not_hold_it_is_refused_with_what_it_held() {
        let (_, Readiness::TooSlow(pace)) = found(0.1, 0.6) else { panic!("it holds three of five") };
        assert!((pace.held_median - 3.0).abs() < 0.01 && pace.behind_s > 5.0);
    }
}
