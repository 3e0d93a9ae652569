//! Averages encoder readings while the pan stands in the places of its jig.

use saute_kitchen::dynamics::Pose;

use crate::strings::jig_calibration::{Accuracy, Calibration, CalibrationError, JigReading};
use crate::strings::{STRINGS, StringRig};

/// Maximum number of jig places (chosen: eight times the minimum, and small enough for the stack).
const PLACES: usize = 64;
/// Number of averaged samples per place (chosen: a twentieth of a second at 1 kHz).
const SAMPLES: u32 = 50;
/// Number of skipped samples after a contact closes (chosen: the pan comes to rest within 50 ms).
const SETTLING: u32 = 50;

/// Sums of lengths at each jig place.
#[derive(Clone, Copy, Debug)]
pub struct JigLog {
    poses: [Pose; PLACES],
    places: usize,
    sum: [[f64; STRINGS]; PLACES],
    count: [u32; PLACES],
    at: u8,
    since: u32,
}

impl JigLog {
    /// Creates an empty log.
    pub fn new(jig: &[Pose]) -> Self {
        let poses = std::array::from_fn(|i| jig.get(i).copied().unwrap_or_default());
        let places = jig.len().min(PLACES);
        Self { poses, places, sum: [[0.0; STRINGS]; PLACES], count: [0; PLACES], at: 0, since: 0 }
    }

    /// Records lengths by count [m] at a jig place, counted from 1.
    ///
    /// Returns the fitted calibration once all places are measured. After a failed fit all places are measured again.
    pub fn note(
        &mut self,
        place: u8,
        by_count: &[f64; STRINGS],
        drawn: &StringRig,
    ) -> Option<Result<Calibration, CalibrationError>> {
        self.since = if place == self.at { self.since.saturating_add(1) } else { 0 };
        self.at = place;
        let index = (place as usize).checked_sub(1).filter(|i| *i < self.places)?;
        if self.since < SETTLING || self.count[index] >= SAMPLES {
            return None;
        }
        (0..STRINGS).for_each(|i| self.sum[index][i] += by_count[i]);
        self.count[index] += 1;
        let whole = self.count[..self.places].iter().all(|c| *c >= SAMPLES);
        whole.then(|| self.fit(drawn))
    }

    fn fit(&mut self, drawn: &StringRig) -> Result<Calibration, CalibrationError> {
        let empty = JigReading { pose: Pose::default(), length: [0.0; STRINGS] };
        let mut readings = [empty; PLACES];
        for (i, reading) in readings[..self.places].iter_mut().enumerate() {
            let mean = |s: f64| s / f64::from(self.count[i]);
            *reading = JigReading { pose: self.poses[i], length: self.sum[i].map(mean) };
        }
        let fitted = Calibration::fit(drawn, &readings[..self.places], Accuracy::default());
        if fitted.is_err() {
            self.count = [0; PLACES];
            self.sum = [[0.0; STRINGS]; PLACES];
        }
        fitted
    }
}
