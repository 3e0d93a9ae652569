//! How a locked speed is held: the machine computes as much simulated time as wall time requires, or falls behind.

use saute_kitchen::heat::sorted::Sorted;

use super::measures::Measures;
use super::protocol::{Simulate, Task};
use super::state::{Stage, Study};

/// Share of a locked speed that counts as held [-] (chosen: less than a person judges a minute to).
const HELD: f64 = 0.97;
/// Wall time of one sample of the speed [s] (chosen: several frames of a slow machine).
const SAMPLE_S: f64 = 1.0;

/// How a locked speed was held.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pace {
    /// The speed that was set: simulated time over wall time [-].
    pub set: f64,
    /// The median of what was held, over seconds of wall time [-].
    pub held_median: f64,
    /// Simulated time that is missing at the end [s].
    pub behind_s: f64,
}

impl Pace {
    /// True if the speed was held: in half of the seconds and in all of them together.
    pub fn holds(&self, wall_s: f64) -> bool {
        self.held_median >= HELD * self.set && self.behind_s <= (1.0 - HELD) * self.set * wall_s
    }

    /// The same to two decimal places.
    #[must_use]
    pub fn to_two_places(self) -> Self {
        let r = Measures::rounded;
        Self { set: r(self.set), held_median: r(self.held_median), behind_s: r(self.behind_s) }
    }
}

/// Measures a pace. It has no clock: who drives it states how much time has passed.
#[derive(Clone, Debug, Default)]
pub struct PaceMeter {
    set: f64,
    samples: Vec<f64>,
    /// Wall time and simulated time of the sample that runs [s].
    sample: [f64; 2],
    /// Wall time and simulated time of all [s].
    whole: [f64; 2],
}

impl PaceMeter {
    /// Begins at a speed [-].
    pub fn at(set: f64) -> Self {
        Self { set, ..Self::default() }
    }

    /// So much wall time and simulated time has passed [s].
    pub fn pass(&mut self, wall_s: f64, simulated_s: f64) {
        for time in [&mut self.sample, &mut self.whole] {
            time[0] += wall_s;
            time[1] += simulated_s;
        }
        if self.sample[0] >= SAMPLE_S {
            self.samples.push(self.sample[1] / self.sample[0]);
            self.sample = [0.0; 2];
        }
    }

    /// Wall time so far [s].
    pub fn wall_s(&self) -> f64 {
        self.whole[0]
    }

    /// The pace so far; none before any time has passed.
    pub fn pace(&self) -> Option<Pace> {
        let [wall_s, simulated_s] = self.whole;
        let of_all = (wall_s > 0.0).then(|| simulated_s / wall_s);
        let held_median = Sorted::new(self.samples.clone()).median().or(of_all)?;
        Some(Pace { set: self.set, held_median, behind_s: (self.set * wall_s - simulated_s).max(0.0) })
    }
}

impl Study {
    /// The fastest trials that are still to come, those of the present phase among them.
    pub fn fastest_to_come(&self) -> Option<&Simulate> {
        let from = match self.stage() {
            Stage::Over => usize::MAX,
            _ => self.phase_place().unwrap_or(0),
        };
        let trials = self.protocol().phases.iter().skip(from).filter_map(|phase| match &phase.task {
            Task::Simulate(simulate) => Some(simulate),
            _ => None,
        });
        trials.max_by(|a, b| a.speed.total_cmp(&b.speed))
    }
}
