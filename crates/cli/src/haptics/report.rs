//! The numbers of `saute haptics check`.

use saute_haptics::jitter::Lateness;
use serde::Serialize;

use super::fault_run::FaultOutcome;
use super::truth::{PoseError, WrenchError};

/// Goals: rate at least [Hz], lateness of 99 of 100 steps below [µs].
const LEAST_RATE_HZ: f64 = 990.0;
const LATEST_P99_US: f64 = 200.0;
/// A rounding of the device's own report of forces [N].
const ROUNDING_N: f64 = 0.01;

/// All numbers, as `--json` prints them.
#[derive(Debug, Serialize)]
pub struct CheckReport {
    /// Device.
    pub device: String,
    /// Whether it was simulated.
    pub simulated: bool,
    /// Control ticks a second, unplugged or not [Hz].
    pub rate_hz: f64,
    /// Scheduling that the control thread got.
    pub scheduler: String,
    /// Lateness of control ticks [µs].
    pub jitter_us: Lateness,
    /// Control ticks left out because the thread was late.
    pub missed_ticks: u64,
    /// Error of poses against the simulator's truth; none for a real device.
    pub pose_error: Option<PoseError>,
    /// Error of wrenches against the simulator's truth.
    pub wrench_error: Option<WrenchError>,
    /// Largest force of the strings, rest included [N].
    pub max_force_n: f64,
    /// What it may not exceed [N].
    pub force_limit_n: f64,
    /// Lowest value of the passivity observer's account, after correction [J].
    pub passivity_j: f64,
    /// Gaps of more than 10 ms without a fresh sample, faults left out.
    pub dropouts: u64,
    /// Frames a second of the kitchen beside the loop [Hz].
    pub kitchen_hz: f64,
    /// Food in the pan at the end of the measurement [kg].
    pub contents_kg: f64,
    /// Faults.
    pub faults: Vec<FaultOutcome>,
    /// Goals that are missed, in words.
    pub missed: Vec<String>,
}

impl CheckReport {
    /// Notes which goals are missed.
    pub fn judged(mut self) -> Self {
        let mut missed = Vec::new();
        let mut goal = |met: bool, words: String| {
            if !met {
                missed.push(words);
            }
        };
        goal(self.rate_hz >= LEAST_RATE_HZ, format!("1 kHz: {:.0} Hz", self.rate_hz));
        let p99 = self.jitter_us.p99;
        goal(p99 < LATEST_P99_US, format!("lateness below {LATEST_P99_US} µs for 99 of 100 ticks: {p99} µs"));
        let (force, limit) = (self.max_force_n, self.force_limit_n);
        goal(force <= limit + ROUNDING_N, format!("force within {limit} N: {force:.2} N"));
        goal(self.passivity_j >= 0.0, format!("passive: {:.2e} J", self.passivity_j));
        for fault in self.faults.iter().filter(|f| !f.passed) {
            goal(false, format!("{}: {}", fault.kind, fault.outcome));
        }
        self.missed = missed;
        self
    }

    /// In words.
    pub fn text(&self) -> String {
        let known = |words: Option<String>| words.unwrap_or_else(|| "not known: the device is real".into());
        let pose = known(self.pose_error.map(|e| format!("{:.3} mm, {:.3}° (99 of 100 samples)", e.mm, e.deg)));
        let wrench = known(
            self.wrench_error
                .map(|e| format!("{:.3} N, {:.4} N·m (rms, motors' lag and friction included)", e.n, e.nm)),
        );
        let j = &self.jitter_us;
        let mut lines = vec![
            format!(
                "device        {}{}",
                self.device,
                if self.simulated { ", simulated in its own process" } else { "" }
            ),
            format!("rate          {:.1} Hz, {}, {} ticks left out", self.rate_hz, self.scheduler, self.missed_ticks),
            format!("lateness      {} µs median, {} µs for 99 of 100 ticks, {:.0} µs at most", j.p50, j.p99, j.max),
            format!("pose error    {pose}"),
            format!("wrench error  {wrench}"),
            format!("force         {:.1} N at most, limit {} N", self.max_force_n, self.force_limit_n),
            format!("passivity     {:.2} mJ at the lowest, of 5 mJ", self.passivity_j * 1e3),
            format!("dropouts      {}", self.dropouts),
            format!(
                "kitchen       {:.1} frames a second beside the loop, {:.0} g of food in the pan",
                self.kitchen_hz,
                self.contents_kg * 1e3
            ),
        ];
        lines.extend(self.faults.iter().map(|f| format!("fault         {}: {}", f.kind, f.outcome)));
        lines.extend(self.missed.iter().map(|m| format!("missed        {m}")));
        lines.join("\n") + "\n"
    }
}
