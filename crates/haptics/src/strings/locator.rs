//! From samples to poses: calibration, stretch, and whether a pose can have the measured lengths.

use crate::strings::geometry::Geometry;
use crate::strings::jig_calibration::{Calibration, FARTHEST};
use crate::strings::jig_log::{JigLog, LONGEST_GAP_S};
use crate::strings::kept_calibration::{CalibrationMemory, KeptCalibration};
use crate::strings::pose_from_lengths::PoseEstimator;
use crate::strings::wire::{Caps, Sample};
use crate::strings::{Lines, STRINGS, StringRig};
use crate::wrench::Twist;
use saute_kitchen::dynamics::Pose;

/// Residual of the pose above which a stored calibration is discarded [m] (chosen: ten times the residual of strings and jig).
const FITS: f64 = 0.5e-3;
/// Residual of a running device that is possible in addition to calibration and stretch [m] (chosen: ten counts of 20 µm).
const POSSIBLE: f64 = 0.2e-3;
/// Multiple of the calibration's own residual that is possible away from the jig [-] (chosen: three standard deviations).
const CALIBRATION_ERROR: f64 = 3.0;
/// Relative error of the strings' stiffness that is possible [-] (chosen: three times the tenth that is typical of braided line).
const STRETCH_ERROR: f64 = 0.3;

/// Finds the pose of the body from samples.
#[derive(Debug)]
pub struct Locator {
    drawn: StringRig,
    home: Pose,
    axial_stiffness_n: f64,
    jig_poses: Vec<Pose>,
    caps: Option<Caps>,
    estimator: PoseEstimator,
    calibration: Option<Calibration>,
    memory: Option<CalibrationMemory>,
    /// True if the calibration is not verified by a sample yet: it is a stored one, or lengths were impossible with it.
    unverified: bool,
    jig: JigLog,
    readings_misfit: bool,
    length_misfit: f64,
}

impl Locator {
    /// Creates a locator without calibration.
    pub fn new(geometry: &Geometry) -> Self {
        let (drawn, home, jig_poses) = (geometry.rig(), geometry.home(), geometry.jig());
        Self {
            drawn,
            home,
            axial_stiffness_n: geometry.drive.axial_stiffness_n,
            jig: JigLog::new(&jig_poses),
            jig_poses,
            caps: None,
            estimator: PoseEstimator::new(drawn, home),
            calibration: None,
            memory: None,
            unverified: false,
            readings_misfit: false,
            length_misfit: 0.0,
        }
    }

    /// Returns the calibration, once there is one.
    pub fn calibration(&self) -> Option<&Calibration> {
        self.calibration.as_ref()
    }

    /// Sets a calibration; it is valid until the encoders lose their count.
    pub fn calibrate(&mut self, calibration: Calibration) {
        self.estimator = PoseEstimator::new(calibration.rig, self.home);
        self.calibration = Some(calibration);
    }

    /// Sets where calibrations are stored.
    pub fn remember(&mut self, memory: CalibrationMemory) {
        self.memory = Some(memory);
    }

    /// Returns true if the readings on the jig fit no device near the drawing.
    pub fn readings_misfit(&self) -> bool {
        self.readings_misfit
    }

    /// Returns the residual of the last lengths over the largest possible one [-].
    pub fn length_misfit(&self) -> f64 {
        self.length_misfit
    }

    /// Returns the last pose.
    pub fn pose(&self) -> Pose {
        self.estimator.pose()
    }

    /// Returns the twist at the last pose [m/s, rad/s].
    pub fn twist(&self) -> Twist {
        self.estimator.twist()
    }

    /// Returns the strings at the last pose.
    pub fn lines(&self) -> Lines {
        self.calibration.map_or(self.drawn, |c| c.rig).lines(&self.pose())
    }

    /// Takes the capabilities of the device that has answered: a calibration of another boot or another device is discarded.
    pub fn meet(&mut self, caps: &Caps) {
        if self.caps.is_some_and(|before| (before.name, before.boot) != (caps.name, caps.boot)) {
            self.discard();
            self.readings_misfit = false;
            self.jig = JigLog::new(&self.jig_poses);
        }
        self.caps = Some(*caps);
        self.restore(caps);
    }

    /// Doubts the calibration after impossible lengths: the next sample verifies it.
    pub fn doubt(&mut self) {
        self.unverified = self.calibration.is_some();
        self.length_misfit = 0.0;
    }

    /// Restores a calibration that was stored since this device was switched on.
    fn restore(&mut self, caps: &Caps) {
        let known = self.memory.as_ref().and_then(|m| m.known).filter(|_| self.calibration.is_none());
        let own = |k: &KeptCalibration| {
            (k.device, k.boot) == (caps.name, caps.boot) && k.calibration.rig.is_near(&self.drawn, FARTHEST)
        };
        if let Some(known) = known.filter(own) {
            self.calibrate(known.calibration);
            self.unverified = true;
        }
    }

    fn discard(&mut self) {
        self.calibration = None;
        self.estimator = PoseEstimator::new(self.drawn, self.home);
    }

    /// Takes a sample: updates the pose, or continues the calibration; `dt` is the time since the last sample of the session, 0 for
    /// the first one [s].
    pub fn locate(&mut self, sample: &Sample, dt: f64) {
        let (by_count, stretch) = self.by_count(sample);
        if self.calibration.is_none() {
            self.note_on_jig(sample.jig, &by_count, dt);
        }
        if let Some(calibration) = self.calibration {
            self.update(&calibration, &by_count, &stretch, dt);
        }
    }

    fn note_on_jig(&mut self, place: u8, by_count: &[f64; STRINGS], dt: f64) {
        if dt == 0.0 || dt > LONGEST_GAP_S {
            self.jig.lose_sight();
        }
        match self.jig.note(place, by_count, &self.drawn) {
            None => {}
            Some(Ok(calibration)) => {
                self.calibrate(calibration);
                self.store(calibration);
            }
            Some(Err(_)) => self.readings_misfit = true,
        }
    }

    /// Updates the pose, unless no pose has these lengths: then the last one stays.
    fn update(&mut self, calibration: &Calibration, by_count: &[f64; STRINGS], stretch: &[f64; STRINGS], dt: f64) {
        let mut updated = self.estimator;
        updated.update(&calibration.lengths(by_count), dt);
        if std::mem::take(&mut self.unverified) && updated.residual() > FITS {
            self.discard();
            return;
        }
        self.length_misfit = updated.residual() / possible(calibration, stretch);
        if self.length_misfit <= 1.0 {
            self.estimator = updated;
        }
    }

    /// Stores a calibration for the next start.
    fn store(&mut self, calibration: Calibration) {
        if let (Some(memory), Some(caps)) = (&mut self.memory, &self.caps) {
            memory.keep(KeptCalibration { device: caps.name, boot: caps.boot, calibration });
        }
    }

    /// Returns lengths by count, corrected for the stretch by the tensions, and that stretch [m].
    fn by_count(&self, sample: &Sample) -> ([f64; STRINGS], [f64; STRINGS]) {
        let pitch = self.caps.map_or(0.0, |c| f64::from(c.pitch_nm) * 1e-9);
        let length = self.lines().length;
        let stretch: [f64; STRINGS] =
            std::array::from_fn(|i| f64::from(sample.tension_mn[i]) * 1e-3 / self.axial_stiffness_n * length[i]);
        (std::array::from_fn(|i| f64::from(sample.count[i]) * pitch + stretch[i]), stretch)
    }
}

/// Returns the largest possible residual of the lengths: what calibration and stretch leave at worst, as a root mean square [m].
fn possible(calibration: &Calibration, stretch: &[f64; STRINGS]) -> f64 {
    let squares: f64 = stretch.iter().map(|s| s * s).sum();
    POSSIBLE + CALIBRATION_ERROR * calibration.residual + STRETCH_ERROR * libm::sqrt(squares / STRINGS as f64)
}
