//! Files of devices, rigs and the window.

use std::io;

use glam::{DVec2, DVec3};
use saute_controls::settings::Settings;
use saute_controls::settings::stored_zoom;
use saute_haptics::strings::wire::{Frame, FrameError, Link};
use saute_haptics::{Geometry, HapticCommand, HapticDevice, KeptCalibration, Spidar};
use saute_mirror::rig_file;
use saute_words::language::Language;

use crate::text;

/// A link to no device.
struct Silence;

impl Link for Silence {
    fn send(&mut self, _: &Frame) -> io::Result<()> {
        Ok(())
    }

    fn receive(&mut self) -> Option<Result<Frame, FrameError>> {
        None
    }
}

/// Geometry of a string device, or a kept calibration; a driver is built and polled ten times.
pub fn geometry(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    if let Ok(kept) = KeptCalibration::parse(text, "kept.toml") {
        let again = KeptCalibration::parse(&kept.text().expect("it can be written"), "kept.toml");
        assert_eq!(again.map(|kept| kept.boot).ok(), Some(kept.boot));
    }
    let Ok(geometry) = Geometry::parse(text, "device.toml") else { return };
    let poses = geometry.jig();
    assert!(poses.iter().all(|pose| pose.position.is_finite()));
    let mut driver = Spidar::new(Silence, geometry, 0);
    for _ in 0..10 {
        let sample = driver.exchange(&HapticCommand::default(), 1e-3);
        assert!(sample.pose.position.is_finite() && sample.total_force_n.is_finite());
    }
}

/// A rig of the half mirror, with the picture that it needs.
pub fn rig(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    let Ok(rig) = rig_file::parse(text, "rig.toml") else { return };
    let _ = rig.mark_places();
    let _ = rig.seen(rig.eye, DVec3::new(0.0, 0.1, 0.05));
    let matrix = rig.view_projection(rig.eye);
    let [width, height] = rig.picture_size(DVec2::new(1920.0, 1080.0), 4096.0);
    assert!(width >= 1 && height >= 1 && width.max(height) <= 4096, "{width} x {height}");
    assert!(matrix.to_cols_array().iter().all(|v| !v.is_infinite()), "{matrix}");
}

/// Remembered settings, as the window stores them, and egui's own zoom.
pub fn settings(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    if let Some(mended) = stored_zoom::mended(text) {
        assert_eq!(stored_zoom::mended(&mended), None, "a mended text needs no mending");
    }
    let (settings, _) = Settings::remembered(text, Language::ENGLISH);
    let written = serde_json::to_string(&settings).expect("settings can be written");
    assert_eq!(Settings::remembered(&written, Language::ENGLISH), (settings, false));
}
