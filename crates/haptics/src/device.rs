//! What every haptic device is to the control loop: capabilities as data, and one exchange.

use saute_kitchen::dynamics::Pose;
use serde::Serialize;

use crate::strings::kept_calibration::CalibrationMemory;
use crate::control::rumble::Rumble;
use crate::strings::{STRINGS, StringRig};
use crate::wrench::{Twist, Wrench};

/// What a device may do to a hand.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Limits {
    /// Force [N].
    pub force_n: f64,
    /// Torque [N·m].
    pub torque_nm: f64,
    /// Change of force [N/s].
    pub slew_n_s: f64,
    /// Change of torque [N·m/s].
    pub slew_nm_s: f64,
    /// Energy given to the hand within a second [J]; the work of weights, and what a felt body gives back of what the hand had put into
    /// it, are left out. Older gifts fade out of the count as e^(−t/1 s): the mean power stays below this much a second.
    pub energy_j: f64,
    /// Stiffest spring that stays stable [N/m].
    pub stiffness_n_m: f64,
    /// Stiffest spring of turning that stays stable [N·m/rad].
    pub stiffness_nm_rad: f64,
}

impl Limits {
    /// Of a device that makes no forces.
    pub const NONE: Self = Self {
        force_n: 0.0,
        torque_nm: 0.0,
        slew_n_s: 0.0,
        slew_nm_s: 0.0,
        energy_j: 0.0,
        stiffness_n_m: 0.0,
        stiffness_nm_rad: 0.0,
    };
}

/// Where a device may be moved.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Workspace {
    /// Middle, in the kitchen [m].
    pub home_m: [f64; 3],
    /// Reach to either side [m].
    pub half_m: [f64; 3],
    /// Tilt to either side [rad].
    pub tilt_rad: f64,
}

/// How a device vibrates.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Vibration {
    /// Not at all: sizzle is heard and seen.
    None,
    /// By rumble motors.
    Rumble,
    /// By its forces.
    Wrench,
}

/// What a device knows of the hand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Sensed {
    /// Place and turning.
    Pose,
    /// Place alone.
    Place,
    /// Turning; place only as far as it tosses.
    Turning,
}

/// What a device can do.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Capabilities {
    /// Name for people.
    pub name: String,
    /// What it knows of the hand; what it does not know stays as it is at home.
    pub sensed: Sensed,
    /// Degrees of freedom that it moves: 6 wrench, 3 force alone, 0 none.
    pub dof_actuated: u8,
    /// What it may do to a hand.
    pub limits: Limits,
    /// Where it may be moved.
    pub workspace: Workspace,
    /// Rate of exchanges [Hz].
    pub rate_hz: f64,
    /// How it vibrates.
    pub vibration: Vibration,
    /// Whether the hand holds a real pan; else the pan's own weight is rendered too.
    pub holds_real_pan: bool,
    /// Mass of what the hand really holds [kg].
    pub real_mass_kg: f64,
}

/// What the hand shall feel beyond the empty device.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct HapticCommand {
    /// Wrench on the hand [N, N·m].
    pub wrench: Wrench,
    /// Whether forces may be shown at all; else the device goes to its rest.
    pub enabled: bool,
    /// What a device shakes with that makes no forces.
    pub rumble: Rumble,
}

/// How a device is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Health {
    /// Looked for.
    #[default]
    Connecting,
    /// There, but its encoders count from an unknown place: put it on its jig.
    Uncalibrated,
    /// What was measured on the jig fits no device near the drawing.
    Misfit,
    /// At work.
    Running,
    /// It has fallen silent.
    Lost,
    /// It refused the pairing code.
    WrongCode,
    /// It states units, strings or a version that this program does not speak.
    WrongUnits,
    /// It reports a fault of its own.
    Fault,
    /// It was stopped and stays so.
    Stopped,
}

/// What a device said last.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HapticSample {
    /// The device's own time [s].
    pub time_s: f64,
    /// Pose of the pan in the kitchen.
    pub pose: Pose,
    /// Whether it tells that pose: a device may know the turner alone, and then the pan is not its own.
    pub leads_pan: bool,
    /// Its velocity [m/s, rad/s].
    pub twist: Twist,
    /// The wrench that its last command really makes beyond the empty device [N, N·m].
    pub achieved: Wrench,
    /// Force with which the device really pulls, rest included [N].
    pub total_force_n: f64,
    /// Tension of each string, for a device of strings [N].
    pub tension_n: Option<[f64; STRINGS]>,
    /// Pose of the turner in the other hand, where the device knows it.
    pub turner: Option<Pose>,
    /// How it is.
    pub health: Health,
    /// Whether it said something new since the last exchange.
    pub fresh: bool,
    /// Buttons, one bit each.
    pub buttons: u32,
    /// Messages that were thrown away because they were damaged, old or meant nothing.
    pub rejected: u32,
}

impl Default for HapticSample {
    /// A device that is looked for and that will lead the pan, as nearly all do.
    fn default() -> Self {
        Self {
            time_s: 0.0,
            pose: Pose::default(),
            leads_pan: true,
            twist: Twist::default(),
            achieved: Wrench::ZERO,
            total_force_n: 0.0,
            tension_n: None,
            turner: None,
            health: Health::Connecting,
            fresh: false,
            buttons: 0,
            rejected: 0,
        }
    }
}

/// A device that a hand holds.
///
/// `exchange` is called from the control loop: it neither blocks, nor allocates, nor locks; a device that is away answers with
/// its [`Health`] and goes on looking.
pub trait HapticDevice: Send {
    /// What it can do.
    fn capabilities(&self) -> &Capabilities;
    /// Tells it what the hand shall feel, `dt` after the last exchange [s], and takes what it said last.
    fn exchange(&mut self, command: &HapticCommand, dt: f64) -> HapticSample;
    /// Lets go of the hand at once.
    fn stop(&mut self);
    /// Its strings as drawn, for a device of strings.
    fn strings(&self) -> Option<StringRig> {
        None
    }
    /// Takes over what was found on its jig before, and keeps there what it finds; nothing for a device without a jig.
    fn remember(&mut self, _memory: CalibrationMemory) {}
}

impl Sensed {
    /// Degrees of freedom.
    pub fn dof(self) -> u8 {
        match self {
            Self::Pose => 6,
            Self::Place | Self::Turning => 3,
        }
    }
}

/// Most damping over what the hand really holds [1/s] (chosen: a third of the delay of 6 ms with which velocity is known; more
/// would shake a light grip).
const DAMPING_RATE: f64 = 50.0;

impl Capabilities {
    /// Most damping that the delay of the measured velocity allows [N·s/m].
    pub fn most_damping(&self) -> f64 {
        DAMPING_RATE * self.real_mass_kg
    }
}
