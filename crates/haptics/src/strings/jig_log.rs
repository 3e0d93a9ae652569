//! Averages encoder readings while the pan is in the places of its jig.

use saute_kitchen::dynamics::Pose;

use crate::strings::jig_calibration::{Accuracy, Calibration, CalibrationError, JigReading};
use crate::strings::{STRINGS, StringRig};

/// Maximum number of jig places (chosen: eight times the minimum, and small enough for the stack).
pub(crate) const PLACES: usize = 64;
/// Longest time between two samples that leaves the pan in its place [s] (chosen: no hand lifts a pan and puts it back so quickly).
pub const LONGEST_GAP_S: f64 = 0.02;
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
    /// Place of the last sample, 0 for none, and number of samples there in a row.
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

    /// Forgets where the pan was: samples are missing, and it may have been moved meanwhile.
    pub fn lose_sight(&mut self) {
        self.leave();
        self.at = 0;
    }

    /// Discards the readings of a place that the pan has left too early.
    fn leave(&mut self) {
        self.since = 0;
        if let Some(index) = self.index(self.at).filter(|i| self.count[*i] < SAMPLES) {
            (self.sum[index], self.count[index]) = ([0.0; STRINGS], 0);
        }
    }

    fn index(&self, place: u8) -> Option<usize> {
        usize::from(place).checked_sub(1).filter(|i| *i < self.places)
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
        if place == self.at {
            self.since = self.since.saturating_add(1);
        } else {
            self.leave();
            self.at = place;
        }
        let index = self.index(place)?;
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

#[cfg(test)]
mod tests {
    use super::*;

    const DRAWN: StringRig = StringRig { motor: [glam::DVec3::ZERO; STRINGS], attachment: [glam::DVec3::X; STRINGS] };

    fn note(log: &mut JigLog, place: u8, samples: u32, length: f64) {
        for _ in 0..samples {
            assert!(log.note(place, &[length; STRINGS], &DRAWN).is_none(), "not whole");
        }
    }

    fn log() -> JigLog {
        JigLog::new(&[Pose::default(); 2])
    }

    #[test]
    fn a_place_is_the_mean_of_fifty_samples_after_fifty_in_a_row() {
        let mut log = log();
        note(&mut log, 1, SETTLING, 9.0);
        note(&mut log, 1, SAMPLES, 1.0);
        note(&mut log, 1, 100, 7.0);
        assert_eq!((log.count[0], log.sum[0][0] / f64::from(SAMPLES)), (SAMPLES, 1.0));
    }

    #[test]
    fn a_contact_that_opens_too_early_is_measured_again() {
        let mut log = log();
        note(&mut log, 1, SETTLING + 20, 9.0);
        note(&mut log, 0, 1, 9.0);
        assert_eq!((log.count[0], log.sum[0]), (0, [0.0; STRINGS]), "the readings of a pan that left are discarded");
        note(&mut log, 1, SETTLING, 5.0);
        assert_eq!(log.count[0], 0, "a contact that closes again settles again");
        note(&mut log, 1, SAMPLES, 1.0);
        note(&mut log, 0, 10, 9.0);
        assert_eq!((log.count[0], log.sum[0][0]), (SAMPLES, f64::from(SAMPLES)), "a measured place stays measured");
    }

    #[test]
    fn missing_samples_begin_a_place_again() {
        let mut log = log();
        note(&mut log, 2, SETTLING + 20, 9.0);
        log.lose_sight();
        note(&mut log, 2, SETTLING, 9.0);
        assert_eq!(log.count[1], 0);
    }

    #[test]
    fn places_that_the_jig_does_not_have_are_none() {
        let mut log = log();
        for place in [0, 3, 64, 65, 255] {
            note(&mut log, place, 200, 1.0);
        }
        assert_eq!(log.count, [0; PLACES]);
    }
}
