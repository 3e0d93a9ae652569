//! Remembered settings of the half mirror.

use std::collections::BTreeMap;

use crate::calibration::Calibration;
use crate::options::MirrorOptions;
use crate::rig::Rig;
use crate::rig_file::SHIPPED;
use crate::stereo::Stereo;

/// Widest distance from eye to eye [mm] (chosen: half as much again as any person's).
pub const WIDEST_MM: f64 = 120.0;

/// Remembered choices, and a calibration for every projector.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize)]
#[serde(default)]
pub struct MirrorSettings {
    /// Name of a shipped rig, or path of a rig file.
    pub rig: String,
    /// The user's name for the projector or screen in use.
    pub projector: String,
    /// Stereo mode.
    pub stereo: Stereo,
    /// From eye to eye, if not as the rig has it [mm].
    pub eye_distance_mm: Option<f64>,
    /// True if the virtual pan is drawn.
    pub pan_shown: bool,
    /// By the projector's name.
    pub calibrations: BTreeMap<String, Calibration>,
}

impl Default for MirrorSettings {
    fn default() -> Self {
        Self {
            rig: SHIPPED[0].0.to_owned(),
            projector: "1".to_owned(),
            stereo: Stereo::Off,
            eye_distance_mm: None,
            pan_shown: false,
            calibrations: BTreeMap::new(),
        }
    }
}

impl MirrorSettings {
    /// The calibration of the projector in use.
    pub fn calibration(&self) -> Calibration {
        self.calibrations.get(&self.projector).cloned().unwrap_or_default()
    }

    /// Keeps a calibration for the projector in use; one without moved marks is forgotten.
    pub fn keep(&mut self, calibration: Calibration) {
        if calibration.moved.is_empty() {
            self.calibrations.remove(&self.projector);
        } else {
            self.calibrations.insert(self.projector.clone(), calibration);
        }
    }

    /// From eye to eye [m].
    pub fn eye_distance(&self, rig: &Rig) -> f64 {
        self.eye_distance_mm.map_or(rig.eye_distance, |mm| 1e-3 * mm.clamp(0.0, WIDEST_MM))
    }

    /// Options of the picture.
    pub fn options(&self, rig: &Rig) -> MirrorOptions {
        MirrorOptions { stereo: self.stereo, eye_distance: self.eye_distance(rig), pan_shown: self.pan_shown }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;
    use crate::rig_file::shipped;

    #[test]
    fn every_projector_keeps_its_own_calibration() {
        let rig = shipped("flat-screen").expect("is there").expect("is read");
        let size = DVec2::new(1920.0, 1080.0);
        let mut settings = MirrorSettings::default();
        let mut calibration = settings.calibration();
        calibration.shift(0, DVec2::new(7.0, -3.1), &rig, size);
        settings.keep(calibration.clone());
        settings.projector = "ceiling".to_owned();
        assert!(settings.calibration().moved.is_empty());
        let text = serde_json::to_string(&settings).expect("is written");
        let mut read: MirrorSettings = serde_json::from_str(&text).expect("is read");
        read.projector = "1".to_owned();
        assert_eq!(read.calibration().moved.len(), 4, "a corner that is moved makes all four known");
        let [now, before] =
            [&read.calibration(), &Calibration::default()].map(|c| c.pixels(&rig, size).expect("is")[0]);
        assert!((now - before).distance(DVec2::new(7.0, -3.1)) < 1e-9);
    }
}
