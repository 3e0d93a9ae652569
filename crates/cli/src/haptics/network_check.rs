//! `saute haptics check` of a device without strings: it moves the pan, and messages, motion and forces are measured.

use std::sync::mpsc::Receiver;
use std::time::Instant;

use saute_haptics::control::control_loop::{ControlLoop, LogRow, LoopState};
use saute_haptics::{Health, Named, Pose, Rendering, library};
use saute_kitchen::Library;
use serde::Serialize;

use super::check::CheckArgs;
use super::fry::Fry;
use super::observation::{Observation, Seen};
use super::trouble::not_there;
use crate::error::CliError;
use crate::output::stderr;

/// Longest time to find a device [s] (chosen: a person fetches a phone and types a code).
const PATIENCE_S: f64 = 120.0;
/// Lowest rate of messages [Hz] (chosen: half of what the page sends; a lower rate feels sluggish).
const LEAST_HZ: f64 = 30.0;
/// Rounding of the forces that the device reports [N].
const ROUNDING_N: f64 = 0.01;

/// All numbers, as `--json` prints them.
#[derive(Debug, Serialize)]
pub struct NetworkReport {
    /// Device.
    pub device: String,
    /// How it renders forces.
    pub rendering: Rendering,
    /// Rate of exchanges [Hz].
    pub rate_hz: f64,
    /// Rate of new messages during the measurement [Hz].
    pub messages_hz: f64,
    /// Longest time without a new message [s].
    pub longest_gap_s: f64,
    /// Number of rejected messages.
    pub rejected: u32,
    /// Why messages were rejected since the start, once for each reason.
    pub rejections: Vec<String>,
    /// Longest time for which the pan was still during the measurement [s].
    pub still_s: f64,
    /// Allowed longest time of that [s].
    pub still_limit_s: f64,
    /// Largest displacement of the pan from its home position [mm].
    pub moved_mm: f64,
    /// Largest tilt of the pan [°].
    pub tilted_deg: f64,
    /// Largest force [N].
    pub max_force_n: f64,
    /// Limit of the force [N].
    pub force_limit_n: f64,
    /// Rate of frames of the kitchen next to the loop [Hz].
    pub kitchen_hz: f64,
    /// First state in which the device did not work, or its state at the end.
    pub health: Health,
    /// Missed goals, in words.
    pub missed: Vec<String>,
}

/// Opens the device, waits for it and cooks with it.
pub fn measure(args: &CheckArgs, named: &Named, library: &Library) -> Result<NetworkReport, CliError> {
    let opened = named.open(args.pairing)?;
    let capabilities = opened.device.capabilities().clone();
    opened.access.lines().into_iter().for_each(stderr::say);
    let rows = (args.for_s * capabilities.rate_hz) as usize;
    let mut notices = Notices { coming: opened.notices, lines: Vec::new() };
    let mut fry = Fry::new(library, ControlLoop::start(opened.device, &library::feel()?, rows)?)?;
    let found = fry.until(args.wait_s.unwrap_or(PATIENCE_S), |s| {
        notices.show();
        s.sample.health == Health::Running
    });
    if !found {
        return Err(not_there(fry.control.state().sample.health));
    }
    stderr::say(format!("found; measuring for {} s", args.for_s));
    let before = fry.control.state();
    let mut observation = Observation::begin(&before, Instant::now());
    fry.until(args.for_s, |s| {
        notices.show();
        observation.note(s, Instant::now())
    });
    let (after, seen) = (fry.control.state(), observation.end());
    let kitchen_hz = fry.rate_hz();
    let run = fry.control.end()?;
    let of_measurement: Vec<LogRow> =
        run.log.into_iter().filter(|r| r.health == Health::Running && r.time_s > before.sample.time_s).collect();
    let mut report = NetworkReport {
        device: args.device.clone(),
        rendering: capabilities.rendering(),
        rate_hz: run.rate_hz,
        messages_hz: of_measurement.len() as f64 / args.for_s,
        longest_gap_s: longest_gap(&of_measurement, &before, &after),
        rejections: notices.lines,
        still_s: seen.still_s,
        still_limit_s: args.still_s,
        rejected: after.sample.rejected.wrapping_sub(before.sample.rejected),
        moved_mm: most(&of_measurement, |pose| (pose.position - middle(&capabilities.workspace.home_m)).length() * 1e3),
        tilted_deg: most(&of_measurement, |pose| pose.up()[2].clamp(-1.0, 1.0).acos().to_degrees()),
        max_force_n: run.max_force_n,
        force_limit_n: capabilities.limits.force_n,
        kitchen_hz,
        health: seen.unwell.unwrap_or(after.sample.health),
        missed: Vec::new(),
    };
    report.missed = report.misses(&seen);
    Ok(report)
}

/// Notices of a device for its user, shown as it comes.
struct Notices {
    coming: Option<Receiver<String>>,
    lines: Vec<String>,
}

impl Notices {
    fn show(&mut self) {
        for line in self.coming.iter().flat_map(Receiver::try_iter) {
            stderr::say(&line);
            self.lines.push(line);
        }
    }
}

fn middle(home: &[f64; 3]) -> glam::DVec3 {
    glam::DVec3::from_array(*home)
}

fn most(log: &[LogRow], of: impl Fn(&Pose) -> f64) -> f64 {
    log.iter().map(|row| of(&row.pose)).fold(0.0, f64::max)
}

/// Returns the longest time between two messages, start and end of the measurement included [s].
fn longest_gap(log: &[LogRow], before: &LoopState, after: &LoopState) -> f64 {
    let ends = [before.sample.time_s, after.sample.time_s];
    let times: Vec<f64> = [ends[0]].into_iter().chain(log.iter().map(|r| r.time_s)).chain([ends[1]]).collect();
    times.windows(2).map(|w| w[1] - w[0]).fold(0.0, f64::max)
}

impl NetworkReport {
    fn misses(&self, seen: &Seen) -> Vec<String> {
        let mut missed = seen.misses(self.still_limit_s);
        let mut goal = |met: bool, words: String| {
            if !met {
                missed.push(words);
            }
        };
        goal(self.messages_hz >= LEAST_HZ, format!("{LEAST_HZ} messages/s: {:.1}", self.messages_hz));
        let (force, limit) = (self.max_force_n, self.force_limit_n);
        goal(force <= limit + ROUNDING_N, format!("force within {limit} N: {force:.2} N"));
        missed
    }

    /// Returns the numbers as text.
    pub fn text(&self) -> String {
        let shown = match self.rendering {
            Rendering::Wrench => "forces and torques",
            Rendering::Force => "forces; torques on the screen",
            Rendering::Rumble => "rumble; weights on the screen",
            Rendering::SoundAndPicture => "no forces: sound and picture",
        };
        let mut lines = vec![
            format!("device        {}", self.device),
            format!("shows         {shown}"),
            format!("rate          {:.1} Hz", self.rate_hz),
            format!("messages      {:.1} per second, longest gap {:.0} ms", self.messages_hz, self.longest_gap_s * 1e3),
            format!("rejected      {} messages", self.rejected),
            format!("pan           moved by {:.0} mm, tilted by {:.1}° at most", self.moved_mm, self.tilted_deg),
            format!("standstill    {:.1} s at most, {} s allowed (--still-s)", self.still_s, self.still_limit_s),
            format!("force         {:.1} N at most, limit {} N", self.max_force_n, self.force_limit_n),
            format!("kitchen       {:.1} frames per second next to the loop", self.kitchen_hz),
        ];
        lines.extend(self.rejections.iter().map(|why| format!("note          {why}")));
        lines.extend(self.missed.iter().map(|m| format!("missed        {m}")));
        lines.join("\n") + "\n"
    }
}
