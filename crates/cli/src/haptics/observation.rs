//! What was seen of a device during its measurement: whether it worked all the time, and whether its pan moved.

use std::time::{Duration, Instant};

use saute_haptics::control::control_loop::LoopState;
use saute_haptics::{Health, Pose};

use super::trouble::trouble;

/// Distance from where the pan was that counts as motion [m] (chosen: above the resolution of all devices, below what a hand holds for
/// seconds).
const MOVED_M: f64 = 1e-3;
/// Angle that counts as motion (chosen: as the distance, at the rim of a pan) [rad].
const TURNED_RAD: f64 = 0.01;

/// An observation in progress.
#[derive(Debug)]
pub struct Observation {
    stood: Pose,
    since: Instant,
    longest: Duration,
    moved: bool,
    unwell: Option<Health>,
}

/// The result of an observation.
#[derive(Clone, Copy, Debug)]
pub struct Seen {
    /// Longest time for which the pan was still [s].
    pub still_s: f64,
    /// True if the pan moved.
    pub moved: bool,
    /// First state in which the device did not work, of those that say more than silence if there are any; none if it
    /// worked all the time.
    pub unwell: Option<Health>,
}

impl Observation {
    /// Begins with a state of the loop.
    pub fn begin(state: &LoopState, now: Instant) -> Self {
        Self { stood: state.sample.pose, since: now, longest: Duration::ZERO, moved: false, unwell: None }
    }

    /// Takes the next state of the loop; returns true if the device has been stopped, so that nothing more will be seen.
    pub fn note(&mut self, state: &LoopState, now: Instant) -> bool {
        let (pose, health) = (&state.sample.pose, state.sample.health);
        if health != Health::Running && self.unwell.is_none_or(|seen| seen == Health::Lost) {
            self.unwell = Some(health);
        }
        self.longest = self.longest.max(now.saturating_duration_since(self.since));
        // A pan that returns home without its device does not show that the device measures.
        if health == Health::Running && is_apart(&self.stood, pose) {
            (self.stood, self.since, self.moved) = (*pose, now, true);
        }
        health.is_stopped()
    }

    /// Ends the observation.
    pub fn end(self) -> Seen {
        Seen { still_s: self.longest.as_secs_f64(), moved: self.moved, unwell: self.unwell }
    }
}

fn is_apart(a: &Pose, b: &Pose) -> bool {
    (a.position - b.position).length() > MOVED_M || a.rotation.angle_between(b.rotation) > TURNED_RAD
}

impl Seen {
    /// Returns the faults of the device, in words; the pan may be still for `most_s` [s].
    pub fn misses(&self, most_s: f64) -> Vec<String> {
        let unwell = self.unwell.map(|health| {
            let (message, remedy) = trouble(health);
            format!("a device that works: it {message}; {remedy}")
        });
        let still = (self.still_s > most_s).then(|| {
            format!(
                "a pan that moves: it stood still for {:.1} s, {most_s} s are allowed; move it, or give --still-s",
                self.still_s
            )
        });
        unwell.into_iter().chain(still).collect()
    }
}

#[cfg(test)]
mod tests {
    use saute_haptics::HapticSample;

    use super::*;

    fn state(x: f64, health: Health) -> LoopState {
        let sample = HapticSample { pose: Pose::at(x, 0.0, 0.0), health, ..HapticSample::default() };
        LoopState { sample, ..LoopState::default() }
    }

    /// Observes for some seconds, in steps of 10 ms.
    fn seen(seconds: u64, at: impl Fn(f64) -> LoopState) -> Seen {
        let begun = Instant::now();
        let mut observation = Observation::begin(&at(0.0), begun);
        for ms in (0..=1000 * seconds).step_by(10) {
            observation.note(&at(ms as f64 * 1e-3), begun + Duration::from_millis(ms));
        }
        observation.end()
    }

    #[test]
    fn a_pan_that_trembles_within_a_millimetre_stands_still() {
        let still = seen(12, |t| state(4e-4 * (30.0 * t).sin(), Health::Running));
        assert!((still.still_s - 12.0).abs() < 1e-9 && !still.moved);
        assert!(still.misses(10.0)[0].contains("stood still for 12.0 s, 10 s are allowed"), "{:?}", still.misses(10.0));
        assert!(still.misses(12.0).is_empty());
        let moving = seen(12, |t| state(0.05 * t.sin(), Health::Running));
        assert!(moving.still_s < 0.5 && moving.moved && moving.misses(10.0).is_empty(), "{moving:?}");
    }

    #[test]
    fn one_moment_of_silence_or_fault_is_not_forgotten() {
        for (health, word) in [(Health::Lost, "silent"), (Health::Fault, "fault"), (Health::Stopped, "stopped")] {
            let ill = |t: f64| if (1.0..1.005).contains(&t) { health } else { Health::Running };
            let seen = seen(2, |t| state(0.05 * t.sin(), ill(t)));
            assert_eq!(seen.unwell, Some(health));
            assert!(seen.misses(10.0)[0].contains(word), "{:?}", seen.misses(10.0));
        }
    }

    #[test]
    fn a_fault_says_more_than_the_silence_before_it() {
        let ill = |t: f64| [Health::Lost, Health::Fault, Health::Lost][(t as usize).min(2)];
        assert_eq!(seen(3, |t| state(0.05 * t.sin(), ill(t))).unwell, Some(Health::Fault));
    }

    #[test]
    fn a_pan_that_returns_home_without_its_device_has_not_moved() {
        let seen = seen(3, |t| state(0.05 * t, Health::Lost));
        assert!(!seen.moved && (seen.still_s - 3.0).abs() < 1e-9);
    }
}
