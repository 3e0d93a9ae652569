//! The numbers of `saute haptics check`.

use saute_haptics::Health;
use saute_haptics::control::jitter::Lateness;
use serde::Serialize;

use super::fault_run::FaultOutcome;
use super::truth::{PoseError, WrenchError};

/// Goal: the lowest rate of the loop [Hz] (chosen: 1 kHz less 1 %).
const LEAST_RATE_HZ: f64 = 990.0;
/// Goal: the 99th percentile of lateness stays below [µs] (chosen: a fifth of a tick).
const LATEST_P99_US: f64 = 200.0;
/// Rounding of the forces that the device reports [N].
const ROUNDING_N: f64 = 0.01;

/// All numbers, as `--json` prints them.
#[derive(Debug, Serialize)]
pub struct CheckReport {
    /// Device.
    pub device: String,
    /// True if it was simulated.
    pub simulated: bool,
    /// Rate of control ticks, faults included [Hz].
    pub rate_hz: f64,
    /// Scheduling policy of the control thread.
    pub scheduler: String,
    /// Lateness of control ticks [µs].
    pub jitter_us: Lateness,
    /// Number of control ticks that were skipped because the thread was late.
    pub missed_ticks: u64,
    /// Error of poses against the true poses of the simulator; none for a real device.
    pub pose_error: Option<PoseError>,
    /// Error of wrenches against the true wrenches of the simulator; none for a real device.
    pub wrench_error: Option<WrenchError>,
    /// Largest force of the strings, preload included [N].
    pub max_force_n: f64,
    /// Limit of the force [N].
    pub force_limit_n: f64,
    /// Lowest energy of the passivity observer after correction; none if the pan did not move: without motion no energy is exchanged,
    /// and the observer's reserve stays full [J].
    pub passivity_j: Option<f64>,
    /// Longest time for which the pan was still during the measurement [s].
    pub still_s: f64,
    /// Allowed longest time of that [s].
    pub still_limit_s: f64,
    /// First state in which the device did not work, or its state at the end.
    pub health: Health,
    /// Number of gaps of more than 10 ms without a new sample, faults excluded.
    pub dropouts: u64,
    /// Rate of frames of the kitchen next to the loop [Hz].
    pub kitchen_hz: f64,
    /// Food in the pan at the end of the measurement [kg].
    pub contents_kg: f64,
    /// Injected faults.
    pub faults: Vec<FaultOutcome>,
    /// Missed goals, in words; those of the observed device come first.
    pub missed: Vec<String>,
}

impl CheckReport {
    /// Returns the report with the missed goals of its numbers.
    pub fn judged(mut self) -> Self {
        let mut missed = std::mem::take(&mut self.missed);
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
        if let Some(lowest) = self.passivity_j {
            goal(lowest >= 0.0, format!("passive: {lowest:.2e} J"));
        }
        for fault in self.faults.iter().filter(|f| !f.passed) {
            goal(false, format!("{}: {}", fault.kind, fault.outcome));
        }
        self.missed = missed;
        self
    }

    /// Returns the numbers as text.
    pub fn text(&self) -> String {
        let known = |words: Option<String>| words.unwrap_or_else(|| "unknown: the device is real".into());
        let pose = known(self.pose_error.map(|e| format!("{:.3} mm, {:.3}° (99 of 100 samples)", e.mm, e.deg)));
        let wrench = known(
            self.wrench_error
                .map(|e| format!("{:.3} N, {:.4} N·m (rms, lag and friction of the motors included)", e.n, e.nm)),
        );
        let passivity = self.passivity_j.map_or("no motion: nothing to judge".into(), |lowest| {
            format!("{:.2} mJ at the lowest, of 5 mJ", lowest * 1e3)
        });
        let j = &self.jitter_us;
        let mut lines = vec![
            format!(
                "device        {}{}",
                self.device,
                if self.simulated { ", simulated in its own process" } else { "" }
            ),
            format!("rate          {:.1} Hz, {}, {} ticks skipped", self.rate_hz, self.scheduler, self.missed_ticks),
            format!("lateness      {} µs median, {} µs for 99 of 100 ticks, {:.0} µs at most", j.p50, j.p99, j.max),
            format!("pose error    {pose}"),
            format!("wrench error  {wrench}"),
            format!("force         {:.1} N at most, limit {} N", self.max_force_n, self.force_limit_n),
            format!("passivity     {passivity}"),
            format!("standstill    {:.1} s at most, {} s allowed (--still-s)", self.still_s, self.still_limit_s),
            format!("dropouts      {}", self.dropouts),
            format!(
                "kitchen       {:.1} frames per second next to the loop, {:.0} g of food in the pan",
                self.kitchen_hz,
                self.contents_kg * 1e3
            ),
        ];
        lines.extend(self.faults.iter().map(|f| format!("fault         {}: {}", f.kind, f.outcome)));
        lines.extend(self.missed.iter().map(|m| format!("missed        {m}")));
        lines.join("\n") + "\n"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn report(passivity_j: Option<f64>) -> CheckReport {
        CheckReport {
            device: "spidar-pan".into(),
            simulated: false,
            rate_hz: 1000.0,
            scheduler: String::new(),
            jitter_us: Lateness::default(),
            missed_ticks: 0,
            pose_error: None,
            wrench_error: None,
            max_force_n: 5.0,
            force_limit_n: 25.0,
            passivity_j,
            still_s: 3.0,
            still_limit_s: 10.0,
            health: Health::Running,
            dropouts: 0,
            kitchen_hz: 60.0,
            contents_kg: 0.3,
            faults: Vec::new(),
            missed: vec!["what was seen".into()],
        }
    }

    #[test]
    fn the_energy_account_of_a_pan_that_did_not_move_is_not_judged() {
        let still = report(None).judged();
        assert_eq!(still.missed, ["what was seen"]);
        assert!(still.text().contains("passivity     no motion: nothing to judge\n"), "{}", still.text());
        assert!(report(Some(4e-3)).text().contains("4.00 mJ at the lowest, of 5 mJ"));
        assert_eq!(report(Some(-1e-3)).judged().missed.len(), 2, "that of one that moved is");
    }
}
