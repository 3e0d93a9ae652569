//! What the control loop publishes: its state after each step, a log for later comparison, and a report of the whole run.

use saute_kitchen::dynamics::Pose;

use crate::control::jitter::Lateness;
use crate::device::{HapticCommand, HapticSample, Health};
use crate::wrench::Wrench;

/// State of the loop after a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LoopState {
    /// Number of steps so far.
    pub steps: u64,
    /// Last sample of the device.
    pub sample: HapticSample,
    /// Last command to the device.
    pub command: HapticCommand,
    /// Lowest value of the passivity observer's account so far [J].
    pub passivity_j: f64,
    /// Number of gaps of more than 10 ms without a fresh sample.
    pub dropouts: u64,
    /// Largest force that the device has reported [N].
    pub max_force_n: f64,
    /// Present value of the passivity observer's account [J].
    pub account_j: f64,
    /// Step rate over the last second [Hz].
    pub rate_hz: f64,
    /// Lateness of all steps so far [µs].
    pub lateness: Lateness,
}

/// One logged step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LogRow {
    /// The device's time [s].
    pub time_s: f64,
    /// The host's time since the start [s].
    pub host_s: f64,
    /// Measured pose of the pan.
    pub pose: Pose,
    /// Commanded wrench [N, N·m].
    pub wanted: Wrench,
    /// Wrench that the device achieves of the commanded one [N, N·m].
    pub achieved: Wrench,
    /// Health of the device.
    pub health: Health,
}

/// Report of a whole run.
#[derive(Clone, Debug)]
pub struct LoopReport {
    /// Mean step rate [Hz].
    pub rate_hz: f64,
    /// Granted scheduling policy of the thread.
    pub scheduler: String,
    /// Lateness of the steps [µs].
    pub lateness: Lateness,
    /// Number of steps that were skipped because the thread was late.
    pub missed: u64,
    /// Number of gaps of more than 10 ms without a fresh sample.
    pub dropouts: u64,
    /// Largest force of strings or motors that the device has reported [N].
    pub max_force_n: f64,
    /// Largest commanded force beyond the empty device [N].
    pub max_wanted_n: f64,
    /// Lowest value of the passivity observer's account [J].
    pub passivity_j: f64,
    /// All steps with a fresh sample, up to the log's capacity.
    pub log: Vec<LogRow>,
}
