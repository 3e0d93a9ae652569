//! The thread that keeps time: a thousand times a second device, renderer, device.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use saute_kitchen::dynamics::Pose;

use crate::kitchen::contact_model::ContactModel;
use crate::device::{HapticCommand, HapticDevice, HapticSample, Health};
use crate::control::feel::Feel;
use crate::control::jitter::{Jitter, Lateness};
use crate::control::renderer::Renderer;
use crate::control::scheduling;
use crate::wrench::{Twist, Wrench};

/// The thread wakes so long before its moment and waits for it awake (chosen: what a sleep oversleeps).
const AWAKE: Duration = Duration::from_micros(60);
/// A step that is later than this is left out (chosen: two steps at once would be one jerk).
const TOO_LATE: Duration = Duration::from_millis(1);
/// How often rate and lateness are told anew [s] (chosen: numbers that can be read).
const TELLING_S: f64 = 1.0;
/// A gap without a fresh sample from which it counts as a dropout [s] (chosen: ten samples).
const DROPOUT_S: f64 = 0.01;
/// Longest step that forces are reckoned with [s] (chosen: shorter than a collision's 8 ms, so that a late step leaves none out, and a
/// fifth of what the spring of the contents stays stable with).
const LONGEST_STEP_S: f64 = 0.005;

/// What the loop tells others after each step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LoopState {
    /// Steps so far.
    pub steps: u64,
    /// What the device said last.
    pub sample: HapticSample,
    /// What it was told.
    pub command: HapticCommand,
    /// Lowest value of the passivity observer's account [J].
    pub passivity_j: f64,
    /// Gaps of more than 10 ms without a fresh sample.
    pub dropouts: u64,
    /// Largest force that the device reported [N].
    pub max_force_n: f64,
    /// Energy that the passivity observer's account holds now [J].
    pub account_j: f64,
    /// Steps a second over the last second [Hz].
    pub rate_hz: f64,
    /// Lateness of all steps so far.
    pub lateness: Lateness,
}

/// One step, for comparisons afterwards.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LogRow {
    /// The device's time [s].
    pub time_s: f64,
    /// The host's time since the start [s].
    pub host_s: f64,
    /// Where the pan was found.
    pub pose: Pose,
    /// What the hand should feel.
    pub wanted: Wrench,
    /// What the device can do of that.
    pub achieved: Wrench,
    /// How the device was.
    pub health: Health,
}

/// What a whole run was like.
#[derive(Clone, Debug)]
pub struct LoopReport {
    /// Steps a second [Hz].
    pub rate_hz: f64,
    /// Scheduling that the thread got.
    pub scheduler: String,
    /// Lateness of steps.
    pub lateness: Lateness,
    /// Steps that were left out because the thread was late.
    pub missed: u64,
    /// Gaps of more than 10 ms without a fresh sample.
    pub dropouts: u64,
    /// Largest force that strings or motors made, as the device reports it [N].
    pub max_force_n: f64,
    /// Largest force beyond the empty device that was asked for [N].
    pub max_wanted_n: f64,
    /// Lowest value of the passivity observer's account [J].
    pub passivity_j: f64,
    /// Every step, as many as there was room for.
    pub log: Vec<LogRow>,
}

/// A running loop.
///
/// The thread holds no lock and allocates nothing: models come and states go through triple buffers, orders through flags.
#[derive(Debug)]
pub struct ControlLoop {
    models: triple_buffer::Input<ContactModel>,
    states: triple_buffer::Output<LoopState>,
    orders: Arc<Orders>,
    thread: Option<JoinHandle<LoopReport>>,
}

#[derive(Debug, Default)]
struct Orders {
    end: AtomicBool,
    emergency: AtomicBool,
}

/// Why the loop could not be run.
#[derive(Debug, thiserror::Error)]
pub enum LoopError {
    /// The system gave no thread.
    #[error("the control loop's thread could not be started: {0}")]
    Start(#[from] std::io::Error),
    /// The thread ended badly.
    #[error("the control loop's thread broke off")]
    BrokeOff,
}

impl ControlLoop {
    /// Starts the loop of a device, with room for so many log rows.
    pub fn start(device: Box<dyn HapticDevice>, feel: &Feel, log_rows: usize) -> Result<Self, LoopError> {
        let (models, model_out) = triple_buffer::triple_buffer(&ContactModel::default());
        let (state_in, states) = triple_buffer::triple_buffer(&LoopState::default());
        let orders = Arc::new(Orders::default());
        let renderer = Renderer::new(device.capabilities(), feel);
        let beat = Beat::new(device, renderer, log_rows);
        let given = Arc::clone(&orders);
        let run = move || run(beat, model_out, state_in, &given);
        let thread = Some(std::thread::Builder::new().name("haptics".into()).spawn(run)?);
        Ok(Self { models, states, orders, thread })
    }

    /// Publishes a contact model; the loop takes it up at its next step.
    pub fn publish(&mut self, model: ContactModel) {
        self.models.write(model);
    }

    /// The loop's last state; a loop that broke off has lost its device, which stands still.
    pub fn state(&mut self) -> LoopState {
        let state = *self.states.read();
        if self.thread.as_ref().is_some_and(|thread| !thread.is_finished()) {
            return state;
        }
        let sample = HapticSample { health: Health::Lost, fresh: false, twist: Twist::default(), ..state.sample };
        LoopState { sample, command: HapticCommand::default(), rate_hz: 0.0, ..state }
    }

    /// Lets go of the hand at once and stays so.
    pub fn emergency_stop(&self) {
        self.orders.emergency.store(true, Ordering::Release);
    }

    /// Ends the loop and lets go of the hand.
    pub fn end(mut self) -> Result<LoopReport, LoopError> {
        self.orders.end.store(true, Ordering::Release);
        self.thread.take().and_then(|thread| thread.join().ok()).ok_or(LoopError::BrokeOff)
    }
}

impl Drop for ControlLoop {
    /// Nobody steers any more: the hand is let go before the program goes on.
    fn drop(&mut self) {
        self.orders.end.store(true, Ordering::Release);
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

/// One step after the other, and what is noted about them.
pub struct Beat {
    device: Box<dyn HapticDevice>,
    renderer: Renderer,
    command: HapticCommand,
    state: LoopState,
    unheard: f64,
    dropouts: u64,
    max_force: f64,
    max_wanted: f64,
    host_s: f64,
    log: Vec<LogRow>,
    stopped: bool,
}

impl Beat {
    /// Nothing has happened yet; the log has room for so many rows.
    pub fn new(device: Box<dyn HapticDevice>, renderer: Renderer, log_rows: usize) -> Self {
        Self {
            device,
            renderer,
            command: HapticCommand::default(),
            state: LoopState::default(),
            unheard: 0.0,
            dropouts: 0,
            max_force: 0.0,
            max_wanted: 0.0,
            host_s: 0.0,
            log: Vec::with_capacity(log_rows),
            stopped: false,
        }
    }

    /// Exchanges with the device and finds what to tell it next, `dt` after the last step [s].
    pub fn step(&mut self, model: &ContactModel, dt: f64) -> LoopState {
        let sample = self.device.exchange(&self.command, dt);
        self.host_s += dt;
        self.count(&sample, dt);
        self.note(&sample);
        self.command = if self.stopped {
            HapticCommand::default()
        } else {
            self.renderer.step(&sample, model, dt.min(LONGEST_STEP_S))
        };
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

    /// Takes over how punctual the last second was.
    fn tell(&mut self, rate_hz: f64, lateness: Lateness) {
        (self.state.rate_hz, self.state.lateness) = (rate_hz, lateness);
    }

    /// Lets go of the hand.
    pub fn stop(&mut self) {
        if !self.stopped {
            self.device.stop();
        }
        self.stopped = true;
    }

    fn count(&mut self, sample: &HapticSample, dt: f64) {
        let before = self.unheard;
        self.unheard = if sample.fresh { 0.0 } else { self.unheard + dt };
        if before <= DROPOUT_S && self.unheard > DROPOUT_S && self.state.sample.time_s > 0.0 && !self.stopped {
            self.dropouts += 1;
        }
        self.max_force = self.max_force.max(sample.total_force_n);
    }

    fn note(&mut self, sample: &HapticSample) {
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
}

/// What the thread does.
fn run(
    mut beat: Beat,
    mut models: triple_buffer::Output<ContactModel>,
    mut states: triple_buffer::Input<LoopState>,
    orders: &Orders,
) -> LoopReport {
    scheduling::ask_for_fifo();
    let scheduler = scheduling::granted();
    let period = Duration::from_secs_f64(1.0 / beat.device.capabilities().rate_hz);
    let mut jitter = Jitter::default();
    let mut missed = 0;
    let started = Instant::now();
    let (mut told, mut told_steps) = (started, 0);
    let (mut due, mut last) = (started + period, started);
    while !orders.end.load(Ordering::Acquire) {
        wait_until(due);
        let now = Instant::now();
        jitter.note((now - due).as_secs_f64() * 1e6);
        if orders.emergency.load(Ordering::Acquire) {
            beat.stop();
        }
        let since = (now - told).as_secs_f64();
        if since > TELLING_S {
            beat.tell((jitter.count() - told_steps) as f64 / since, jitter.lateness());
            (told, told_steps) = (now, jitter.count());
        }
        let state = beat.step(models.read(), (now - last).as_secs_f64());
        states.write(state);
        last = now;
        due += period;
        let behind = Instant::now().saturating_duration_since(due);
        if behind > TOO_LATE {
            let skipped = (behind.as_nanos() / period.as_nanos()) as u32;
            missed += u64::from(skipped);
            due += period * skipped;
        }
    }
    beat.stop();
    report(beat, &jitter, scheduler, missed, started.elapsed())
}

fn report(beat: Beat, jitter: &Jitter, scheduler: String, missed: u64, took: Duration) -> LoopReport {
    LoopReport {
        rate_hz: jitter.count() as f64 / took.as_secs_f64(),
        scheduler,
        lateness: jitter.lateness(),
        missed,
        dropouts: beat.dropouts,
        max_force_n: beat.max_force,
        max_wanted_n: beat.max_wanted,
        passivity_j: beat.renderer.passivity().lowest(),
        log: beat.log,
    }
}

fn wait_until(due: Instant) {
    let left = due.saturating_duration_since(Instant::now());
    if left > AWAKE {
        std::thread::sleep(left - AWAKE);
    }
    while Instant::now() < due {
        std::hint::spin_loop();
    }
}
