//! The interface of every haptic device: capabilities as data, and one exchange per step.

use saute_kitchen::dynamics::Pose;
use serde::Serialize;

use crate::control::rumble::Rumble;
use crate::strings::kept_calibration::CalibrationMemory;
use crate::strings::{STRINGS, StringRig};
use crate::wrench::{Twist, Wrench};

/// Limits of what a device may do to a hand.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Limits {
    /// Force [N].
    pub force_n: f64,
    /// Torque [N·m].
    pub torque_nm: f64,
    /// Slew rate of force [N/s].
    pub slew_n_s: f64,
    /// Slew rate of torque [N·m/s].
    pub slew_nm_s: f64,
    /// Energy given to the hand per second [J].
    ///
    /// The work of weights and energy that a virtual body returns to the hand do not count. Earlier energy decays as
    /// e^(−t/1 s), so the mean power stays below this value per second.
    pub energy_j: f64,
    /// Greatest stable stiffness [N/m].
    pub stiffness_n_m: f64,
    /// Greatest stable rotational stiffness [N·m/rad].
    pub stiffness_nm_rad: f64,
}

impl Limits {
    /// Limits of a device without forces.
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

/// Range of motion of a device.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Workspace {
    /// Centre, in the kitchen [m].
    pub home_m: [f64; 3],
    /// Half width along each axis [m].
    pub half_m: [f64; 3],
    /// Largest tilt to either side [rad].
    pub tilt_rad: f64,
}

/// How a device renders vibration.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Vibration {
    /// Not at all: sizzle is audible and visible only.
    None,
    /// With rumble motors.
    Rumble,
    /// With its forces.
    Wrench,
}

/// What a device measures of the hand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Sensed {
    /// Position and orientation.
    Pose,
    /// Position only.
    Place,
    /// Orientation; position only during a toss.
    Turning,
}

/// Capabilities of a device.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Capabilities {
    /// Display name.
    pub name: String,
    /// What it measures; the rest keeps its value at home.
    pub sensed: Sensed,
    /// Actuated degrees of freedom: 6 wrench, 3 force only, 0 none.
    pub dof_actuated: u8,
    /// Limits of what it may do to a hand.
    pub limits: Limits,
    /// Range of motion.
    pub workspace: Workspace,
    /// Rate of exchanges [Hz].
    pub rate_hz: f64,
    /// How it renders vibration.
    pub vibration: Vibration,
    /// True if the hand holds a real pan; otherwise the pan's own weight is rendered too.
    pub holds_real_pan: bool,
    /// Mass of the real object in the hand [kg].
    pub real_mass_kg: f64,
}

/// Command to a device: what the hand feels beyond the empty device.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct HapticCommand {
    /// Wrench on the hand [N, N·m].
    pub wrench: Wrench,
    /// True if forces are enabled; otherwise the device goes to its rest state.
    pub enabled: bool,
    /// Rumble, for devices without forces [-].
    pub rumble: Rumble,
}

/// Health of a device.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Health {
    /// Not found yet.
    #[default]
    Connecting,
    /// Connected, but its encoders count from an unknown zero: put it on its jig.
    Uncalibrated,
    /// The readings on the jig fit no device near the drawing.
    Misfit,
    /// Running.
    Running,
    /// Silent for longer than its timeout.
    Lost,
    /// The pairing code was refused.
    WrongCode,
    /// Another host drives it.
    Busy,
    /// Units or number of strings are not supported.
    WrongUnits,
    /// It has an older protocol version: its firmware must be updated.
    DeviceOutdated,
    /// It has a newer protocol version: this program must be updated.
    ProgramOutdated,
    /// The device reports a fault.
    Fault,
    /// Its watchdog time is not lawful.
    WatchdogUnlawful,
    /// Its least tension is above the geometry's.
    LeastTensionTooHigh,
    /// Its largest tension is below the geometry's.
    LargestTensionTooLow,
    /// Its largest rate of commands is below the geometry's.
    RateTooLow,
    /// Stopped until a hand resumes.
    Stopped,
    /// Stopped by a safety rule: its string lengths contradict each other.
    ImpossibleLengths,
    /// Stopped by a safety rule: it reported a force above its limit.
    ForceAboveLimit,
    /// Stopped by a safety rule: it gave the hand energy that it did not have.
    EnergyOverdrawn,
}

/// Last sample of a device.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HapticSample {
    /// The device's clock [s].
    pub time_s: f64,
    /// Pose of the pan in the kitchen.
    pub pose: Pose,
    /// True if the device moves the pan; a device may measure the turner only.
    pub leads_pan: bool,
    /// Twist of the pan [m/s, rad/s].
    pub twist: Twist,
    /// Wrench that the last command really makes beyond the empty device [N, N·m].
    pub achieved: Wrench,
    /// Total force of the device, its rest state included [N].
    pub total_force_n: f64,
    /// Residual of the string lengths over the largest possible one, 0 without strings; above 1 no pose fits the lengths [-].
    pub length_misfit: f64,
    /// Tension of each string, for string devices [N].
    pub tension_n: Option<[f64; STRINGS]>,
    /// Pose of the turner in the other hand, if measured.
    pub turner: Option<Pose>,
    /// Health of the device.
    pub health: Health,
    /// True if the sample is new since the last exchange.
    pub fresh: bool,
    /// Buttons, one bit each.
    pub buttons: u32,
    /// Number of rejected messages: damaged, outdated or meaningless.
    pub rejected: u32,
}

impl Default for HapticSample {
    /// Returns the sample of a device that is not found yet and that moves the pan, as nearly all do.
    fn default() -> Self {
        Self {
            time_s: 0.0,
            pose: Pose::default(),
            leads_pan: true,
            twist: Twist::default(),
            achieved: Wrench::ZERO,
            total_force_n: 0.0,
            length_misfit: 0.0,
            tension_n: None,
            turner: None,
            health: Health::Connecting,
            fresh: false,
            buttons: 0,
            rejected: 0,
        }
    }
}

/// A haptic device that a hand holds.
///
/// The control loop calls `exchange`: it must not block, allocate or lock. A device without connection returns its [`Health`]
/// and keeps looking.
pub trait HapticDevice: Send {
    /// Returns the device's capabilities.
    fn capabilities(&self) -> &Capabilities;
    /// Sends a command and returns the last sample; `dt` is the time since the last exchange [s].
    fn exchange(&mut self, command: &HapticCommand, dt: f64) -> HapticSample;
    /// Releases all forces at once, until `resume`; a device that is stopped receives nothing more.
    fn stop(&mut self);
    /// Releases all forces within 2 ms, as gently as that allows, and then stops: a safety rule has fired.
    fn trip(&mut self) {
        self.stop();
    }
    /// Looks for the device again after a stop; only a person's hand may request it.
    fn resume(&mut self);
    /// Returns the strings as drawn, for string devices.
    fn strings(&self) -> Option<StringRig> {
        None
    }
    /// Restores a stored calibration, and stores new ones there; does nothing for devices without a jig.
    fn remember(&mut self, _memory: CalibrationMemory) {}
}

impl Health {
    /// Returns true after a stop, by a hand or by a safety rule.
    pub fn is_stopped(self) -> bool {
        matches!(self, Self::Stopped) || self.is_safety_fault()
    }

    /// Returns true if a safety rule has stopped the device.
    pub fn is_safety_fault(self) -> bool {
        matches!(self, Self::ImpossibleLengths | Self::ForceAboveLimit | Self::EnergyOverdrawn)
    }
}

impl Sensed {
    /// Returns the number of measured degrees of freedom.
    pub fn dof(self) -> u8 {
        match self {
            Self::Pose => 6,
            Self::Place | Self::Turning => 3,
        }
    }
}

/// Greatest damping per mass in the hand [1/s] (chosen: a third of the inverse delay of 6 ms of the measured velocity; more would
/// shake a light grip).
const DAMPING_RATE: f64 = 50.0;

impl Capabilities {
    /// Returns the greatest damping that the delay of the measured velocity allows [N·s/m].
    pub fn most_damping(&self) -> f64 {
        DAMPING_RATE * self.real_mass_kg
    }
}
