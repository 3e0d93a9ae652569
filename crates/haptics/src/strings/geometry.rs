//! The geometry file of a string device.

use glam::DVec3;
use saute_kitchen::dynamics::Pose;
use saute_kitchen::dynamics::pose::about;
use saute_kitchen::food::sourced_table;
use saute_schema::InputError;
use serde::Deserialize;

use crate::device::{Capabilities, Limits, Sensed, Vibration, Workspace};
use crate::library::parse_table;
use crate::strings::jig_log::PLACES;
use crate::strings::tension::TensionRule;
use crate::strings::{STRINGS, StringRig};
use crate::wrench::Wrench;

sourced_table! {
    /// End points of the strings.
    StringTable {
        /// Motor end of each string, in the kitchen [mm].
        motor_mm: Vec<[f64; 3]>,
        /// Body end of each string, in the body's frame [mm].
        attachment_mm: Vec<[f64; 3]>,
    }
}

sourced_table! {
    /// Motors, encoders and string material.
    DriveTable {
        /// String length per encoder count [µm].
        encoder_pitch_um: f64,
        /// Least tension [N].
        min_tension_n: f64,
        /// Largest tension [N].
        max_tension_n: f64,
        /// Axial stiffness EA: tension per strain [N].
        axial_stiffness_n: f64,
        /// Control rate [Hz].
        rate_hz: f64,
    }
}

sourced_table! {
    /// The real object in the hand.
    GripTable {
        /// True if it is a real pan.
        holds_real_pan: bool,
        /// Its mass [kg].
        real_mass_kg: f64,
        /// Downward preload at rest, which makes the real pan feel heavier than it is [N].
        preload_n: f64,
    }
}

sourced_table! {
    /// Limits of what the device may do to the hand.
    LimitTable {
        /// Force [N].
        force_n: f64,
        /// Torque [N·m].
        torque_nm: f64,
        /// Slew rate of force [N/s].
        slew_n_s: f64,
        /// Slew rate of torque [N·m/s].
        slew_nm_s: f64,
        /// Energy given to the hand per second, as [`Limits::energy_j`] counts it [J].
        energy_j: f64,
        /// Greatest stable stiffness [N/m].
        stiffness_n_m: f64,
        /// Greatest stable rotational stiffness [N·m/rad].
        stiffness_nm_rad: f64,
    }
}

sourced_table! {
    /// Range of motion.
    WorkspaceTable {
        /// Centre [mm].
        home_mm: [f64; 3],
        /// Half width along each axis [mm].
        half_mm: [f64; 3],
        /// Largest tilt to either side [°].
        tilt_deg: f64,
    }
}

sourced_table! {
    /// Tension distribution.
    TensionTable {
        /// Lever that converts a torque error to a force error [mm].
        lever_mm: f64,
        /// Weight of squared tension over squared force error [-].
        regularisation: f64,
    }
}

sourced_table! {
    /// The calibration jig.
    JigTable {
        /// Poses of the jig: x, y, z [mm] and the rotation vector [°].
        pose: Vec<[f64; 6]>,
    }
}

/// A string device.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Geometry {
    /// Display name.
    pub name: String,
    /// Strings.
    pub strings: StringTable,
    /// Motors and encoders.
    pub drive: DriveTable,
    /// The real object in the hand.
    pub grip: GripTable,
    /// Limits.
    pub limits: LimitTable,
    /// Workspace.
    pub workspace: WorkspaceTable,
    /// Tension distribution.
    pub tension: TensionTable,
    /// Calibration jig.
    pub jig: JigTable,
}

/// Largest coordinate [mm] (chosen: larger than any device).
const FARTHEST_MM: f64 = 5000.0;

/// A checked number: key, value, minimum, maximum.
type Ranged = (&'static str, f64, f64, f64);

fn vector_mm(v: [f64; 3]) -> DVec3 {
    DVec3::from_array(v) * 1e-3
}

impl Geometry {
    /// Parses and checks the file of a device.
    pub fn parse(text: &str, file: &str) -> Result<Self, InputError> {
        let geometry: Self = parse_table(text, file, "see data/haptics/devices/spidar-pan-crossed.toml for the keys")?;
        geometry.check(text, file)?;
        Ok(geometry)
    }

    fn check(&self, text: &str, file: &str) -> Result<(), InputError> {
        let error =
            |key: &str, message: String, remedy: &str| Err(crate::library::error_at(text, file, key, message, remedy));
        for (key, places) in [("motor_mm", &self.strings.motor_mm), ("attachment_mm", &self.strings.attachment_mm)] {
            if places.len() != STRINGS {
                return error(key, format!("{key} has {} places", places.len()), "give eight, one for each string");
            }
        }
        for (key, mut numbers) in self.places() {
            if let Some(value) = numbers.find(|v| !v.is_finite() || v.abs() > FARTHEST_MM) {
                let remedy = "give finite numbers within ±5000 mm, and angles in degrees";
                return error(key, format!("{key} has {value}, which is out of range"), remedy);
            }
        }
        for (key, value, low, high) in self.ranged() {
            if !(low..=high).contains(&value) {
                return error(key, format!("{key} = {value} is out of range"), &format!("give {low} to {high}"));
            }
        }
        if self.drive.max_tension_n <= self.drive.min_tension_n {
            return error("max_tension_n", "max_tension_n is no more than min_tension_n".into(), "give a larger one");
        }
        if !(8..=PLACES).contains(&self.jig.pose.len()) {
            let remedy = format!("give 8 to {PLACES}, far apart");
            return error("pose", format!("the jig has {} poses", self.jig.pose.len()), &remedy);
        }
        Ok(())
    }

    /// Returns all places with their keys.
    fn places(&self) -> [(&'static str, Box<dyn Iterator<Item = f64> + '_>); 5] {
        let (strings, workspace) = (&self.strings, &self.workspace);
        [
            ("motor_mm", Box::new(strings.motor_mm.iter().flatten().copied())),
            ("attachment_mm", Box::new(strings.attachment_mm.iter().flatten().copied())),
            ("home_mm", Box::new(workspace.home_mm.into_iter())),
            ("half_mm", Box::new(workspace.half_mm.into_iter())),
            ("pose", Box::new(self.jig.pose.iter().flatten().copied())),
        ]
    }

    fn ranged(&self) -> [Ranged; 18] {
        let (d, g, l, w) = (&self.drive, &self.grip, &self.limits, &self.workspace);
        [
            ("encoder_pitch_um", d.encoder_pitch_um, 0.1, 1000.0),
            ("min_tension_n", d.min_tension_n, 0.0, 10.0),
            ("max_tension_n", d.max_tension_n, 0.1, 60.0),
            ("axial_stiffness_n", d.axial_stiffness_n, 100.0, 1e7),
            ("rate_hz", d.rate_hz, 100.0, 4000.0),
            ("real_mass_kg", g.real_mass_kg, 0.0, 10.0),
            ("preload_n", g.preload_n, 0.0, 50.0),
            ("force_n", l.force_n, 0.1, 200.0),
            ("torque_nm", l.torque_nm, 0.0, 20.0),
            ("slew_n_s", l.slew_n_s, 1.0, 1e6),
            ("slew_nm_s", l.slew_nm_s, 0.1, 1e5),
            ("energy_j", l.energy_j, 0.01, 100.0),
            ("stiffness_n_m", l.stiffness_n_m, 1.0, 1e5),
            ("stiffness_nm_rad", l.stiffness_nm_rad, 0.01, 1e4),
            ("half_mm", w.half_mm.into_iter().fold(0.0, f64::max), 1.0, 2000.0),
            ("tilt_deg", w.tilt_deg, 0.0, 90.0),
            ("lever_mm", self.tension.lever_mm, 1.0, 1000.0),
            ("regularisation", self.tension.regularisation, 1e-9, 1.0),
        ]
    }

    /// Returns the strings as drawn.
    pub fn rig(&self) -> StringRig {
        let place = |list: &[[f64; 3]], i: usize| list.get(i).map_or(DVec3::ZERO, |v| vector_mm(*v));
        StringRig {
            motor: std::array::from_fn(|i| place(&self.strings.motor_mm, i)),
            attachment: std::array::from_fn(|i| place(&self.strings.attachment_mm, i)),
        }
    }

    /// Returns the centre of the workspace.
    pub fn home(&self) -> Pose {
        let [x, y, z] = vector_mm(self.workspace.home_mm).to_array();
        Pose::at(x, y, z)
    }

    /// Returns the poses of the jig.
    pub fn jig(&self) -> Vec<Pose> {
        let pose = |p: &[f64; 6]| Pose {
            position: vector_mm([p[0], p[1], p[2]]),
            rotation: about(DVec3::new(p[3], p[4], p[5]) * std::f64::consts::PI / 180.0),
        };
        self.jig.pose.iter().map(pose).collect()
    }

    /// Returns the string length per encoder count [m].
    pub fn pitch(&self) -> f64 {
        self.drive.encoder_pitch_um * 1e-6
    }

    /// Returns the wrench of the strings at rest [N, N·m].
    pub fn preload(&self) -> Wrench {
        Wrench { force: DVec3::new(0.0, 0.0, -self.grip.preload_n), torque: DVec3::ZERO }
    }

    /// Returns the rule of the tension distribution.
    pub fn tension_rule(&self) -> TensionRule {
        TensionRule {
            min: self.drive.min_tension_n,
            max: self.drive.max_tension_n,
            lever: self.tension.lever_mm * 1e-3,
            regularisation: self.tension.regularisation,
        }
    }

    /// Returns the device's capabilities.
    pub fn capabilities(&self) -> Capabilities {
        let (limits, half) = (&self.limits, vector_mm(self.workspace.half_mm));
        Capabilities {
            name: self.name.clone(),
            sensed: Sensed::Pose,
            dof_actuated: 6,
            limits: Limits {
                force_n: limits.force_n,
                torque_nm: limits.torque_nm,
                slew_n_s: limits.slew_n_s,
                slew_nm_s: limits.slew_nm_s,
                energy_j: limits.energy_j,
                stiffness_n_m: limits.stiffness_n_m,
                stiffness_nm_rad: limits.stiffness_nm_rad,
            },
            workspace: Workspace {
                home_m: self.home().position.to_array(),
                half_m: half.to_array(),
                tilt_rad: self.workspace.tilt_deg.to_radians(),
            },
            rate_hz: self.drive.rate_hz,
            vibration: Vibration::Wrench,
            holds_real_pan: self.grip.holds_real_pan,
            real_mass_kg: self.grip.real_mass_kg,
        }
    }
}
