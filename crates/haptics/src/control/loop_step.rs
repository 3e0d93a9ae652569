//! One step of the control loop: exchange with the device, render the next command, record the result.

use crate::control::jitter::Lateness;
use crate::control::loop_state::{LogRow, LoopState};
use crate::control::renderer::Renderer;
use crate::control::safety_watch::SafetyWatch;
use crate::device::{HapticCommand, HapticDevice, HapticSample, Health};
use crate::kitchen::contact_model::ContactModel;

/// Time without a fresh sample that counts as a dropout [s] (chosen: ten samples).
const DROPOUT_S: f64 = 0.01;
/// Longest step of force rendering [s] (chosen: shorter than a collision's 8 ms, so that a late step skips none, and a fifth of the
/// stability limit of the contents' spring).
const LONGEST_STEP_S: f64 = 0.005;

/// A device with its renderer, stepped without a clock or a thread; a step allocates nothing.
pub struct LoopStep {
    device: Box<dyn HapticDevice>,
    renderer: Renderer,
    watch: SafetyWatch,
    command: HapticCommand,
    state: LoopState,
    /// Time since the last fresh sample [s].
    stale: f64,
    dropouts: u64,
    max_force: f64,
    max_wanted: f64,
    host_s: f64,
    log: Vec<LogRow>,
    /// Why the device is stopped; none while it may make forces.
    halt: Option<Health>,
}

impl LoopStep {
    /// Creates a loop before its first step; the log has `log_rows` rows.
    pub fn new(device: Box<dyn HapticDevice>, renderer: Renderer, log_rows: usize) -> Self {
        let watch = SafetyWatch::new(&device.capabilities().limits);
        Self {
            device,
            renderer,
            watch,
            command: HapticCommand::default(),
            state: LoopState::default(),
            stale: 0.0,
            dropouts: 0,
            max_force: 0.0,
            max_wanted: 0.0,
            host_s: 0.0,
            log: Vec::with_capacity(log_rows),
            halt: None,
        }
    }

    /// Sends the last command, receives a sample, and renders the next command; `dt` is the time since the last step [s].
    pub fn step(&mut self, model: &ContactModel, dt: f64) -> LoopState {
        let mut sample = self.device.exchange(&self.command, dt);
        sample.health = self.halt.unwrap_or(sample.health);
        self.host_s += dt;
        self.count(&sample, dt);
        self.record(&sample);
        self.command = match self.halt {
            None => self.renderer.step(&sample, model, dt.min(LONGEST_STEP_S)),
            Some(_) => HapticCommand::default(),
        };
        self.judge(&sample, dt);
        sample.health = self.halt.unwrap_or(sample.health);
        self.max_wanted = self.max_wanted.max(self.command.wrench.force.length());
        self.state = LoopState {
            steps: self.state.steps + 1,
            sample,
            command: self.command,
            passivity_j: self.renderer.passivity().lowest(),
            dropouts: self.dropouts,
            max_force_n: self.max_force,
            account_j: self.renderer.passivity().account(),
            ..self.state
        };
        self.state
    }

    /// Returns the device's nominal rate [Hz].
    pub fn rate_hz(&self) -> f64 {
        self.device.capabilities().rate_hz
    }

    /// Sets rate [Hz] and lateness [µs] in the published state.
    pub(crate) fn set_timing(&mut self, rate_hz: f64, lateness: Lateness) {
        (self.state.rate_hz, self.state.lateness) = (rate_hz, lateness);
    }

    /// Stops the device: it makes no force until `resume`.
    pub fn stop(&mut self) {
        self.device.stop();
        // The reason of an earlier stop stays visible.
        self.halt.get_or_insert(Health::Stopped);
    }

    /// Lets the device make forces again after a stop; only a person's hand may request it.
    pub fn resume(&mut self) {
        if self.halt.take().is_some() {
            self.watch = SafetyWatch::new(&self.device.capabilities().limits);
            self.renderer.restart();
            self.device.resume();
        }
    }

    /// Stops the device if a safety rule fires.
    fn judge(&mut self, sample: &HapticSample, dt: f64) {
        if self.halt.is_some() {
            return;
        }
        self.halt = self.watch.judge(sample, self.renderer.passivity(), dt);
        if self.halt.is_some() {
            self.command = HapticCommand::default();
            self.device.trip();
        }
    }

    fn count(&mut self, sample: &HapticSample, dt: f64) {
        let before = self.stale;
        self.stale = if sample.fresh { 0.0 } else { self.stale + dt };
        if before <= DROPOUT_S && self.stale > DROPOUT_S && self.state.sample.time_s > 0.0 && self.halt.is_none() {
            self.dropouts += 1;
        }
        self.max_force = self.max_force.max(sample.total_force_n);
    }

    fn record(&mut self, sample: &HapticSample) {
        if self.log.len() < self.log.capacity() && sample.fresh {
            self.log.push(LogRow {
                time_s: sample.time_s,
                host_s: self.host_s,
                pose: sample.pose,
                wanted: self.command.wrench,
                achieved: sample.achieved,
                health: sample.health,
            });
        }
    }

    /// Returns the log, and the totals of all steps.
    pub(crate) fn into_totals(self) -> Totals {
        Totals {
            dropouts: self.dropouts,
            max_force_n: self.max_force,
            max_wanted_n: self.max_wanted,
            passivity_j: self.renderer.passivity().lowest(),
            log: self.log,
        }
    }
}

/// Totals of all steps of a loop.
pub(crate) struct Totals {
    /// Number of dropouts.
    pub dropouts: u64,
    /// Largest reported force [N].
    pub max_force_n: f64,
    /// Largest commanded force [N].
    pub max_wanted_n: f64,
    /// Lowest value of the passivity account [J].
    pub passivity_j: f64,
    /// Logged steps.
    pub log: Vec<LogRow>,
}
