//! The part of a geometry file that the simulator uses.

use std::io::Read;
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

/// Largest file [bytes] (chosen: the largest shipped one has 4 kB).
const LARGEST: u64 = 1 << 20;
/// Largest coordinate of a place [mm] (chosen: larger than any device).
const FARTHEST_MM: f64 = 5000.0;
/// Largest number of places of a jig (chosen: as many as its host measures).
const MOST_PLACES: usize = 64;

/// A number with its key, and the least and the largest allowed value.
type Ranged = (&'static str, f64, f64, f64);

impl RigFile {
    /// Returns what is wrong with a number, and what to write instead.
    fn check(&self) -> Result<(), String> {
        let wrong = |(key, value, low, high): Ranged| format!("{key} has {value}; write a number from {low} to {high}");
        let out_of_range = |(_, value, low, high): &Ranged| !(*low..=*high).contains(value);
        if let Some(number) = self.places().chain(self.numbers()).find(out_of_range) {
            return Err(wrong(number));
        }
        if self.drive.max_tension_n <= self.drive.min_tension_n {
            return Err("max_tension_n is no more than min_tension_n; write a larger one".into());
        }
        match self.jig.pose.len() {
            1..=MOST_PLACES => Ok(()),
            places => Err(format!("the jig has {places} poses; write 1 to {MOST_PLACES}")),
        }
    }

    /// Returns the coordinates of all places [mm] and the angles of the jig [°].
    fn places(&self) -> impl Iterator<Item = Ranged> {
        let keyed = |key| move |value: &f64| (key, *value, -FARTHEST_MM, FARTHEST_MM);
        let Strings { motor_mm, attachment_mm } = &self.strings;
        let ends = motor_mm.iter().flatten().map(keyed("motor_mm"));
        let ends = ends.chain(attachment_mm.iter().flatten().map(keyed("attachment_mm")));
        let home = self.workspace.home_mm.iter().map(keyed("home_mm"));
        ends.chain(home).chain(self.jig.pose.iter().flatten().map(keyed("pose")))
    }

    /// Returns all other numbers; their ranges are those of the host's file, where the simulation needs no narrower one.
    fn numbers(&self) -> impl Iterator<Item = Ranged> {
        let (drive, half) = (&self.drive, self.workspace.half_mm);
        let single = [
            ("encoder_pitch_um", drive.encoder_pitch_um, 0.1, 1000.0),
            ("min_tension_n", drive.min_tension_n, 0.0, 10.0),
            ("max_tension_n", drive.max_tension_n, 0.1, 60.0),
            ("axial_stiffness_n", drive.axial_stiffness_n, 100.0, 1e7),
            ("rate_hz", drive.rate_hz, 100.0, 4000.0),
            // A pan without mass would have no finite acceleration.
            ("real_mass_kg", self.grip.real_mass_kg, 0.05, 10.0),
            ("tilt_deg", self.workspace.tilt_deg, 0.0, 90.0),
        ];
        single.into_iter().chain(half.map(|value| ("half_mm", value, 0.0, 2000.0)))
    }
}

fn read(path: &Path) -> std::io::Result<String> {
    let mut text = String::new();
    std::fs::File::open(path)?.take(LARGEST).read_to_string(&mut text)?;
    Ok(text)
}

/// Loads a device by name or path.
pub fn load(device: &str) -> Result<RigFile, RigFileError> {
    let path = Path::new(device);
    let text = if path.is_file() {
        read(path).map_err(|e| RigFileError::Unreadable(device.into(), e))?
    } else {
        let file = DEVICES.get_file(format!("{device}.toml")).and_then(|f| f.contents_utf8());
        file.ok_or_else(|| RigFileError::Unknown(device.into(), names()))?.to_owned()
    };
    let wrong = |message: String| RigFileError::Wrong(device.into(), message);
    let file: RigFile = toml::from_str(&text).map_err(|e| wrong(e.to_string().trim().to_owned()))?;
    file.check().map_err(wrong)?;
    Ok(file)
}

fn names() -> String {
    let stem = |f: &include_dir::File| Some(f.path().file_stem()?.to_str()?.to_owned());
    DEVICES.files().filter_map(stem).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    const CROSSED: &str = include_str!("../../../data/haptics/devices/spidar-pan-crossed.toml");

    /// Returns the shipped file with another first number after a key.
    fn with(key: &str, number: &str) -> RigFile {
        let (head, tail) = CROSSED.split_once(&format!("{key} = ")).expect("the key");
        let begins = tail.find(|c: char| c.is_ascii_digit() || c == '-').expect("a number");
        let ends = begins + tail[begins..].find([',', ']', ' ', '\n']).expect("an end");
        let text = format!("{head}{key} = {}{number}{}", &tail[..begins], &tail[ends..]);
        toml::from_str(&text).expect("TOML")
    }

    #[test]
    fn numbers_that_are_not_finite_are_refused_with_key_and_range() {
        let keys =
            ["motor_mm", "attachment_mm", "home_mm", "half_mm", "pose", "real_mass_kg", "encoder_pitch_um", "tilt_deg"];
        for key in keys {
            for number in ["nan", "inf", "-inf", "1e308", "-1e308"] {
                let said = with(key, number).check().expect_err("it is refused");
                assert!(said.starts_with(key) && said.contains("write a number from"), "{key} = {number}: {said}");
            }
        }
        assert!(with("real_mass_kg", "0").check().is_err(), "a pan without mass");
    }

    #[test]
    fn every_shipped_device_is_accepted() {
        for name in ["spidar-frame", "spidar-pan", "spidar-pan-crossed"] {
            assert!(load(name).is_ok(), "{name}");
        }
    }
}
