//! The part of a geometry file that the simulator uses.

use std::path::Path;

use include_dir::{Dir, include_dir};
use serde::Deserialize;

static DEVICES: Dir = include_dir!("$CARGO_MANIFEST_DIR/../../data/haptics/devices");

/// A device's file; keys for the driver alone are ignored.
#[derive(Clone, Debug, Deserialize)]
pub struct RigFile {
    pub name: String,
    pub strings: Strings,
    pub drive: Drive,
    pub grip: Grip,
    pub workspace: Workspace,
    pub jig: Jig,
}

#[derive(Clone, Debug, Deserialize)]
pub struct Strings {
    pub motor_mm: [[f64; 3]; 8],
    pub attachment_mm: [[f64; 3]; 8],
}

#[derive(Clone, Debug, Deserialize)]
pub struct Drive {
    pub encoder_pitch_um: f64,
    pub min_tension_n: f64,
    pub max_tension_n: f64,
    pub axial_stiffness_n: f64,
    pub rate_hz: f64,
}

#[derive(Clone, Debug, Deserialize)]
pub struct Grip {
    pub real_mass_kg: f64,
}

#[derive(Clone, Debug, Deserialize)]
pub struct Workspace {
    pub home_mm: [f64; 3],
    pub half_mm: [f64; 3],
    pub tilt_deg: f64,
}

#[derive(Clone, Debug, Deserialize)]
pub struct Jig {
    pub pose: Vec<[f64; 6]>,
}

/// Why a device could not be loaded.
#[derive(Debug, thiserror::Error)]
pub enum RigFileError {
    /// There is no such device.
    #[error("{0}: there is no such file or device\n  remedy: name a .toml file or one of: {1}")]
    Unknown(String, String),
    /// Its file cannot be read.
    #[error("{0} cannot be read: {1}\n  remedy: check the path and the file's permissions")]
    Unreadable(String, std::io::Error),
    /// Its file is wrong.
    #[error("{0}: {1}\n  remedy: see data/haptics/devices/spidar-pan-crossed.toml for the keys")]
    Wrong(String, String),
}

/// Loads a device by name or path.
pub fn load(device: &str) -> Result<RigFile, RigFileError> {
    let path = Path::new(device);
    let text = if path.is_file() {
        std::fs::read_to_string(path).map_err(|e| RigFileError::Unreadable(device.into(), e))?
    } else {
        let file = DEVICES.get_file(format!("{device}.toml")).and_then(|f| f.contents_utf8());
        file.ok_or_else(|| RigFileError::Unknown(device.into(), names()))?.to_owned()
    };
    toml::from_str(&text).map_err(|e| RigFileError::Wrong(device.into(), e.to_string().trim().to_owned()))
}

fn names() -> String {
    let stem = |f: &include_dir::File| Some(f.path().file_stem()?.to_str()?.to_owned());
    DEVICES.files().filter_map(stem).collect::<Vec<_>>().join(", ")
}
