//! Stored calibrations: the file format, and the hand-over between the control loop and the file.

use std::path::{Path, PathBuf};

use glam::DVec3;
use saute_schema::InputError;
use serde::{Deserialize, Serialize};

use crate::library::{error_at, parse_table};
use crate::strings::jig_calibration::{Calibration, WORST};
use crate::strings::{STRINGS, StringRig};

/// Remedy for an invalid file.
const REMEDY: &str = "delete the file and put the pan on its jig again";
/// Largest coordinate or offset [mm] (chosen: larger than any device).
const FARTHEST_MM: f64 = 5000.0;

/// A calibration with the device that it belongs to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KeptCalibration {
    /// Name that the device reports, padded with zeros.
    pub device: [u8; 16],
    /// Boot number of the device: its encoders keep their zeros until it is switched off.
    pub boot: u32,
    /// The calibration.
    pub calibration: Calibration,
}

/// One string of the file.
#[derive(Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
struct StringEntry {
    motor_mm: [f64; 3],
    attachment_mm: [f64; 3],
    offset_mm: f64,
}

/// Contents of the file.
#[derive(Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
struct CalibrationFile {
    device: String,
    boot: u32,
    residual_mm: f64,
    string: Vec<StringEntry>,
}

/// A driver's side of the storage: the known calibration, and where new ones go.
#[derive(Debug)]
pub struct CalibrationMemory {
    /// Calibration of an earlier run.
    pub known: Option<KeptCalibration>,
    found: triple_buffer::Input<Option<KeptCalibration>>,
}

/// The receiving side of the storage: new calibrations of a driver.
#[derive(Debug)]
pub struct CalibrationNews(triple_buffer::Output<Option<KeptCalibration>>);

impl CalibrationMemory {
    /// Creates both sides of the storage.
    pub fn new(known: Option<KeptCalibration>) -> (Self, CalibrationNews) {
        let (found, news) = triple_buffer::triple_buffer(&None);
        (Self { known, found }, CalibrationNews(news))
    }

    /// Stores a new calibration; it neither blocks nor allocates.
    pub fn keep(&mut self, found: KeptCalibration) {
        self.known = Some(found);
        self.found.write(Some(found));
    }
}

impl CalibrationNews {
    /// Returns a calibration that is new since the last call.
    pub fn take(&mut self) -> Option<KeptCalibration> {
        if self.0.updated() { *self.0.read() } else { None }
    }
}

impl KeptCalibration {
    /// Returns the device's name as text.
    pub fn device_name(&self) -> String {
        String::from_utf8_lossy(&self.device).trim_end_matches('\0').to_owned()
    }

    /// Parses a file.
    pub fn parse(text: &str, file: &str) -> Result<Self, InputError> {
        let kept: CalibrationFile = parse_table(text, file, REMEDY)?;
        let wrong = |key: &str, message: &str| Err(error_at(text, file, key, message.to_owned(), REMEDY));
        if kept.string.len() != STRINGS {
            return wrong("string", "there are not eight strings");
        }
        let numbers = |s: &StringEntry| s.motor_mm.into_iter().chain(s.attachment_mm).chain([s.offset_mm]);
        if kept.string.iter().flat_map(numbers).any(|v| !v.is_finite() || v.abs() > FARTHEST_MM) {
            return wrong("motor_mm", "a number is out of range");
        }
        // A large residual would make all lengths possible, and so disarm the rule that detects impossible ones.
        if !(0.0..=WORST * 1e3).contains(&kept.residual_mm) {
            return wrong("residual_mm", "the residual is out of range");
        }
        if kept.device.len() > 16 {
            return wrong("device", "the device's name has more than 16 bytes");
        }
        let mut device = [0; 16];
        device[..kept.device.len()].copy_from_slice(kept.device.as_bytes());
        let place = |v: [f64; 3]| DVec3::from_array(v) * 1e-3;
        let rig = StringRig {
            motor: std::array::from_fn(|i| place(kept.string[i].motor_mm)),
            attachment: std::array::from_fn(|i| place(kept.string[i].attachment_mm)),
        };
        let offset = std::array::from_fn(|i| kept.string[i].offset_mm * 1e-3);
        let calibration = Calibration { rig, offset, residual: kept.residual_mm * 1e-3 };
        Ok(Self { device, boot: kept.boot, calibration })
    }

    /// Returns the file's text.
    pub fn text(&self) -> Result<String, toml::ser::Error> {
        let Calibration { rig, offset, residual } = &self.calibration;
        let entry = |i: usize| StringEntry {
            motor_mm: (rig.motor[i] * 1e3).to_array(),
            attachment_mm: (rig.attachment[i] * 1e3).to_array(),
            offset_mm: offset[i] * 1e3,
        };
        let file = CalibrationFile {
            device: self.device_name(),
            boot: self.boot,
            residual_mm: residual * 1e3,
            string: (0..STRINGS).map(entry).collect(),
        };
        const HEAD: &str = "# Calibration that saute found on the jig. It is valid until the device is switched off.\n";
        Ok(HEAD.to_owned() + &toml::to_string(&file)?)
    }
}

/// Returns the path of a device's calibration in a folder; the device's name and place form the file name.
pub fn file_in(folder: &Path, device: &str) -> PathBuf {
    let plain = |c: char| if c.is_ascii_alphanumeric() || "-_.".contains(c) { c } else { '_' };
    folder.join(device.chars().map(plain).collect::<String>() + ".toml")
}
