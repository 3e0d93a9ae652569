//! `saute haptics check`.

use std::path::PathBuf;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use saute_haptics::control::control_loop::{ControlLoop, LoopState};
use saute_haptics::strings::simulator::open_or_simulate;
use saute_haptics::{Geometry, Health, Named, library};
use saute_kitchen::Library;

use super::fault_run;
use super::fry::Fry;
use super::network_check;
use super::observation::Observation;
use super::report::CheckReport;
use super::trouble::{broke_off, not_there};
use super::truth;
use crate::error::CliError;
use crate::exit_code;
use crate::output::{json, stderr, stdout};

/// Longest times to find a device and to calibrate it on its jig [s] (chosen: a person with a jig of 17 places).
const PATIENCE_S: [f64; 2] = [30.0, 300.0];
/// Silence on the jig after which the device counts as dead (chosen: its user may plug a cable in again).
const DEAD: Duration = Duration::from_secs(5);
/// Time after the calibration that is not measured: the hand starts to move and forces grow [s] (chosen).
const SETTLING_S: f64 = 1.0;
/// Capacity of the log beyond the measurement [s] (chosen: calibration and faults).
const MORE_LOG_S: f64 = 60.0;

/// `saute haptics check`.
#[derive(Debug, clap::Args)]
pub struct CheckArgs {
    /// Device: a name from `saute haptics list` or a geometry file. String devices are simulated unless @HOST:PORT or
    /// @SERIAL-PORT names a real one. phone, haply and osc are real; they are served to this machine only unless @HOST:PORT
    /// names another address (phone@0.0.0.0:8443: the whole network).
    #[arg(long, value_name = "NAME", default_value = library::DEFAULT_DEVICE)]
    pub device: String,
    /// Pairing code that the real device displays.
    #[arg(long, value_name = "CODE", default_value_t = 0)]
    pub pairing: u32,
    /// Longest time to find a phone, haply or osc [s] [default: 120].
    #[arg(long, value_name = "S")]
    pub wait_s: Option<f64>,
    /// Duration of the measurement [s].
    #[arg(long, value_name = "S", default_value_t = 60.0)]
    pub for_s: f64,
    /// Longest time for which the pan may be still: a device that measures nothing looks like a pan that nobody moves [s].
    #[arg(long, value_name = "S", default_value_t = 10.0)]
    pub still_s: f64,
    /// Injects faults after the measurement; needs the simulator.
    #[arg(long)]
    pub faults: bool,
    /// Prints the numbers as JSON.
    #[arg(long)]
    pub json: bool,
}

/// Runs the control loop, measures it and prints the numbers. Falls short unless the device was seen to work all the time.
pub fn check(args: &CheckArgs, library: &Library) -> Result<ExitCode, CliError> {
    if !(1.0..=3600.0).contains(&args.for_s) {
        return Err(CliError::place(format!("--for-s {}", args.for_s), "is out of range", "give 1 to 3600 seconds"));
    }
    if !(0.1..=3600.0).contains(&args.still_s) {
        let place = format!("--still-s {}", args.still_s);
        return Err(CliError::place(place, "is out of range", "give 0.1 to 3600 seconds"));
    }
    let named = Named::parse(&args.device)?;
    if args.faults && !named.is_simulated() {
        let remedy = "leave out --faults, or check a simulated string device";
        return Err(CliError::place("--faults", "faults cannot be injected into a real device", remedy));
    }
    let (json, text, is_met) = match named.geometry() {
        Some(geometry) => {
            let report = measure(args, &named, geometry, library)?.judged();
            (json::text(&report)?, report.text(), report.missed.is_empty())
        }
        None => {
            let report = network_check::measure(args, &named, library)?;
            (json::text(&report)?, report.text(), report.missed.is_empty())
        }
    };
    stdout::print(&if args.json { json } else { text })?;
    Ok(exit_code::of_goal(is_met))
}

fn measure(args: &CheckArgs, named: &Named, geometry: &Geometry, library: &Library) -> Result<CheckReport, CliError> {
    let truth_file = TruthFile::new();
    let (opened, mut simulator) = open_or_simulate(named, args.pairing, Some(&truth_file.0))?;
    let feel = library::feel()?;
    let rows = (args.for_s + MORE_LOG_S) * geometry.drive.rate_hz;
    let mut fry = Fry::new(library, ControlLoop::start(opened.device, &feel, rows as usize)?)?;
    calibrate(&mut fry, named, geometry)?;
    let before = fry.control.state();
    stderr::say(format!("measuring for {} s", args.for_s));
    let mut observation = Observation::begin(&before, Instant::now());
    fry.until(args.for_s, |s| observation.note(s, Instant::now()));
    let after = fry.control.state();
    let contents_kg = fry.contents_kg();
    let force_limit_n = geometry.limits.force_n;
    let faults = match simulator.as_mut().filter(|_| args.faults && !after.sample.health.is_stopped()) {
        Some(simulator) => fault_run::run(&mut fry, simulator, force_limit_n),
        None => Vec::new(),
    };
    let kitchen_hz = fry.rate_hz();
    let run = fry.control.end()?;
    let measured = [before.sample.time_s, after.sample.time_s];
    let seen = observation.end();
    let errors = match &mut simulator {
        Some(simulator) => {
            simulator.end();
            truth::compare(&truth_file.0, &run.log, measured, &geometry.preload())?
        }
        None => None,
    };
    Ok(CheckReport {
        device: args.device.clone(),
        simulated: named.is_simulated(),
        rate_hz: run.rate_hz,
        scheduler: run.scheduler,
        jitter_us: run.lateness,
        missed_ticks: run.missed,
        pose_error: errors.map(|e| e.0),
        wrench_error: errors.map(|e| e.1),
        max_force_n: run.max_force_n,
        force_limit_n,
        passivity_j: seen.moved.then_some(run.passivity_j),
        still_s: seen.still_s,
        still_limit_s: args.still_s,
        health: seen.unwell.unwrap_or(after.sample.health),
        dropouts: after.dropouts - before.dropouts,
        kitchen_hz,
        contents_kg,
        faults,
        missed: seen.misses(args.still_s),
    })
}

/// Waits until the device is found and calibrated.
fn calibrate(fry: &mut Fry, named: &Named, geometry: &Geometry) -> Result<(), CliError> {
    let answered = |s: &LoopState| !matches!(s.sample.health, Health::Connecting | Health::Lost | Health::Busy);
    let [find, jig] = PATIENCE_S;
    fry.until(find, answered);
    let health = fry.control.state().sample.health;
    if !matches!(health, Health::Running | Health::Uncalibrated | Health::Misfit) {
        return Err(not_there(health));
    }
    stderr::say(format!("found; put the pan into each of the {} places of its jig", geometry.jig.pose.len()));
    let mut answered = Instant::now();
    fry.until(jig, |s| match s.sample.health {
        Health::Uncalibrated => {
            answered = Instant::now();
            false
        }
        Health::Lost | Health::Connecting => answered.elapsed() > DEAD,
        _ => true,
    });
    match fry.control.state().sample.health {
        Health::Running => {}
        health @ (Health::Uncalibrated | Health::Misfit) => return Err(not_calibrated(named, health)),
        health => return Err(broke_off(health)),
    }
    fry.until(SETTLING_S, |_| false);
    Ok(())
}

/// Returns the error of a device that has been found but not calibrated.
fn not_calibrated(named: &Named, health: Health) -> CliError {
    let (message, remedy) = match health {
        Health::Misfit => (
            "the measurements on the jig do not match the geometry file",
            "check the routing of its strings, and that this is its geometry file",
        ),
        _ => ("was not calibrated in time", "leave the pan in each place of the jig until all have been measured"),
    };
    CliError::place(&named.name, message, remedy)
}

/// A temporary file that is removed on drop.
struct TruthFile(PathBuf);

impl TruthFile {
    fn new() -> Self {
        Self(std::env::temp_dir().join(format!("saute-haptics-{}.csv", std::process::id())))
    }
}

impl Drop for TruthFile {
    fn drop(&mut self) {
        let _ = std::fs::remove_file(&self.0);
    }
}
