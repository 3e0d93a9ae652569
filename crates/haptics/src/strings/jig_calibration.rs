//! Calibration on a jig: the real end points of the strings and the zeros of the encoders.

use glam::DVec3;
use saute_kitchen::dynamics::Pose;

use crate::strings::linear::solve_symmetric;
use crate::strings::{STRINGS, StringRig};

/// Encoder readings at a known pose of the jig.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JigReading {
    /// The known pose.
    pub pose: Pose,
    /// Length by count from an unknown zero, corrected for stretch [m].
    pub length: [f64; STRINGS],
}

/// A-priori accuracy of the drawing and of the readings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Accuracy {
    /// Standard deviation of end points from the drawing [m].
    pub places: f64,
    /// Standard deviation of a length at a jig pose [m].
    pub lengths: f64,
}

impl Default for Accuracy {
    /// Returns half a millimetre for end points and 30 µm for lengths (chosen: workshop tolerance; two encoder counts of 20 µm and the
    /// jig's play).
    fn default() -> Self {
        Self { places: 0.5e-3, lengths: 30e-6 }
    }
}

/// The calibration of a device.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Calibration {
    /// Real end points of the strings.
    pub rig: StringRig,
    /// Offset that is added to a length by count [m].
    pub offset: [f64; STRINGS],
    /// Root mean square residual at the jig's poses [m].
    pub residual: f64,
}

/// Why a calibration failed.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum CalibrationError {
    /// Too few jig poses were measured.
    #[error("{0} poses of the jig were measured, 8 are needed: leave the pan in each place until its lamp goes out")]
    TooFew(usize),
    /// The readings fit no device near the drawing.
    #[error(
        "string {string} does not fit the drawing: {residual_mm:.2} mm remain; check how the string runs, and the geometry file"
    )]
    DoesNotFit {
        /// Which string, from 1.
        string: usize,
        /// Root mean square [mm].
        residual_mm: f64,
    },
    /// The readings fit only a device far from the drawing.
    #[error(
        "string {string} was found {off_mm:.1} mm from where it is drawn; check that this is the device's geometry file"
    )]
    NotAsDrawn {
        /// Which string, from 1.
        string: usize,
        /// How far one of its ends is off [mm].
        off_mm: f64,
    },
}

/// Minimum number of readings (chosen: each string has seven unknowns, and one more reading checks the fit).
const FEWEST: usize = 8;
/// Distance from the drawing above which the geometry belongs to another device [m] (chosen: ten times the workshop tolerance).
pub(crate) const FARTHEST: f64 = 5e-3;
/// Number of Gauss–Newton steps (chosen: three suffice from a drawing that is half a millimetre off).
const STEPS: usize = 8;
/// Largest accepted residual [m] (chosen: ten times the accuracy of encoders and jig).
pub(crate) const WORST: f64 = 0.3e-3;

impl Calibration {
    /// Creates the calibration of a device exactly as drawn, whose encoders read `length` by count [m] at a pose.
    pub fn as_drawn(rig: StringRig, at: &Pose, length: &[f64; STRINGS]) -> Self {
        let true_length = rig.lengths(at);
        Self { rig, offset: std::array::from_fn(|i| true_length[i] - length[i]), residual: 0.0 }
    }

    /// Fits a calibration to readings: maximum a posteriori least squares with the drawing as prior.
    ///
    /// For each string: min over m, g, o of Σₖ (|m − pₖ − Rₖ g| − lₖ − o)²/σ_l² + |m − m₀|²/σ_p² + |g − g₀|²/σ_p².
    pub fn fit(drawn: &StringRig, readings: &[JigReading], accuracy: Accuracy) -> Result<Self, CalibrationError> {
        if readings.len() < FEWEST {
            return Err(CalibrationError::TooFew(readings.len()));
        }
        let mut found = Self { rig: *drawn, offset: [0.0; STRINGS], residual: 0.0 };
        let mut squares = 0.0;
        for i in 0..STRINGS {
            let mut fit = StringFit::new(drawn, i, readings);
            (0..STEPS).for_each(|_| fit.step(readings, accuracy));
            let rms = fit.rms(readings);
            if rms > WORST || !rms.is_finite() {
                return Err(CalibrationError::DoesNotFit { string: i + 1, residual_mm: rms * 1e3 });
            }
            let off = (fit.motor - fit.drawn.0).length().max((fit.attachment - fit.drawn.1).length());
            if off > FARTHEST {
                return Err(CalibrationError::NotAsDrawn { string: i + 1, off_mm: off * 1e3 });
            }
            (found.rig.motor[i], found.rig.attachment[i], found.offset[i]) = (fit.motor, fit.attachment, fit.offset);
            squares += rms * rms;
        }
        found.residual = libm::sqrt(squares / STRINGS as f64);
        Ok(found)
    }

    /// Returns lengths from lengths by count [m].
    pub fn lengths(&self, by_count: &[f64; STRINGS]) -> [f64; STRINGS] {
        std::array::from_fn(|i| by_count[i] + self.offset[i])
    }
}

/// The seven unknowns of one string.
struct StringFit {
    string: usize,
    drawn: (DVec3, DVec3),
    motor: DVec3,
    attachment: DVec3,
    offset: f64,
}

impl StringFit {
    fn new(drawn: &StringRig, string: usize, readings: &[JigReading]) -> Self {
        let (motor, attachment) = (drawn.motor[string], drawn.attachment[string]);
        let mut fit = Self { string, drawn: (motor, attachment), motor, attachment, offset: 0.0 };
        let sum: f64 = readings.iter().map(|r| fit.error(r).0).sum();
        fit.offset = sum / readings.len() as f64;
        fit
    }

    /// Returns predicted minus measured length [m], and the string's unit direction towards the motor [-].
    fn error(&self, reading: &JigReading) -> (f64, DVec3) {
        let way = self.motor - reading.pose.to_world(self.attachment);
        let length = way.length();
        (length - reading.length[self.string] - self.offset, way / length.max(1e-9))
    }

    fn step(&mut self, readings: &[JigReading], accuracy: Accuracy) {
        let (mut a, mut b) = ([[0.0; 7]; 7], [0.0; 7]);
        for reading in readings {
            let (error, d) = self.error(reading);
            let g = -(reading.pose.rotation.conjugate() * d);
            let row = [d.x, d.y, d.z, g.x, g.y, g.z, -1.0];
            for r in 0..7 {
                b[r] -= row[r] * error;
                (0..7).for_each(|c| a[r][c] += row[r] * row[c]);
            }
        }
        let prior = (accuracy.lengths / accuracy.places).powi(2);
        let off = [self.motor - self.drawn.0, self.attachment - self.drawn.1];
        for r in 0..6 {
            a[r][r] += prior;
            b[r] -= prior * off[r / 3].to_array()[r % 3];
        }
        if solve_symmetric(&mut a, &mut b, 7) {
            self.motor += DVec3::new(b[0], b[1], b[2]);
            self.attachment += DVec3::new(b[3], b[4], b[5]);
            self.offset += b[6];
        }
    }

    fn rms(&self, readings: &[JigReading]) -> f64 {
        let squares: f64 = readings.iter().map(|r| self.error(r).0.powi(2)).sum();
        libm::sqrt(squares / readings.len() as f64)
    }
}
