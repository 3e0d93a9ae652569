//! The control loop's thread: exchanges with the device at its rate, typically 1 kHz.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use crate::control::end_signals::EndSignals;
use crate::control::feel::Feel;
use crate::control::jitter::Jitter;
use crate::control::loop_step::LoopStep;
use crate::control::pacer::Pacer;
use crate::control::renderer::Renderer;
use crate::control::scheduling;
use crate::device::{HapticCommand, HapticDevice, HapticSample, Health};
use crate::kitchen::contact_model::ContactModel;
use crate::wrench::Twist;

pub use crate::control::loop_state::{LogRow, LoopReport, LoopState};

/// Interval between two updates of rate and lateness [s] (chosen: readable numbers).
const REPORT_INTERVAL_S: f64 = 1.0;

/// A running control loop.
///
/// The thread takes no lock and allocates nothing: models and states pass through triple buffers, requests through flags.
#[derive(Debug)]
pub struct ControlLoop {
    models: triple_buffer::Input<ContactModel>,
    states: triple_buffer::Output<LoopState>,
    requests: Arc<Requests>,
    thread: Option<JoinHandle<LoopReport>>,
}

#[derive(Debug, Default)]
struct Requests {
    end: AtomicBool,
    emergency: AtomicBool,
    resume: AtomicBool,
}

/// Why the loop could not be run.
#[derive(Debug, thiserror::Error)]
pub enum LoopError {
    /// The system did not start the thread.
    #[error("the control loop's thread could not be started: {0}")]
    Start(#[from] std::io::Error),
    /// The thread panicked.
    #[error("the control loop's thread broke off")]
    BrokeOff,
}

impl ControlLoop {
    /// Starts the loop of a device; the log has `log_rows` rows.
    pub fn start(device: Box<dyn HapticDevice>, feel: &Feel, log_rows: usize) -> Result<Self, LoopError> {
        let (models, model_out) = triple_buffer::triple_buffer(&ContactModel::default());
        let (state_in, states) = triple_buffer::triple_buffer(&LoopState::default());
        let requests = Arc::new(Requests::default());
        let renderer = Renderer::new(device.capabilities(), feel);
        let step = LoopStep::new(device, renderer, log_rows);
        let shared = Arc::clone(&requests);
        // Dropped after the loop's device: a signal ends the program when the device has received its stop.
        let signals = EndSignals::watch();
        let run = move || run(step, model_out, state_in, &shared, &signals);
        let thread = Some(std::thread::Builder::new().name("haptics".into()).spawn(run)?);
        Ok(Self { models, states, requests, thread })
    }

    /// Publishes a contact model; the loop uses it from its next step.
    pub fn publish(&mut self, model: ContactModel) {
        self.models.write(model);
    }

    /// Returns the loop's last state; after a panic of the thread the device is reported as lost and at rest.
    pub fn state(&mut self) -> LoopState {
        let state = *self.states.read();
        if self.thread.as_ref().is_some_and(|thread| !thread.is_finished()) {
            return state;
        }
        let sample = HapticSample { health: Health::Lost, fresh: false, twist: Twist::default(), ..state.sample };
        LoopState { sample, command: HapticCommand::default(), rate_hz: 0.0, ..state }
    }

    /// Stops all forces at once, until `resume`.
    pub fn emergency_stop(&self) {
        self.requests.resume.store(false, Ordering::Release);
        self.requests.emergency.store(true, Ordering::Release);
    }

    /// Lets the device make forces again after a stop; only a person's hand may request it.
    pub fn resume(&self) {
        self.requests.resume.store(true, Ordering::Release);
    }

    /// Stops all forces, ends the loop and returns its report.
    pub fn end(mut self) -> Result<LoopReport, LoopError> {
        self.requests.end.store(true, Ordering::Release);
        self.thread.take().and_then(|thread| thread.join().ok()).ok_or(LoopError::BrokeOff)
    }
}

impl Drop for ControlLoop {
    /// Stops all forces and waits for the thread's end.
    fn drop(&mut self) {
        self.requests.end.store(true, Ordering::Release);
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

/// The thread's function.
fn run(
    mut step: LoopStep,
    mut models: triple_buffer::Output<ContactModel>,
    mut states: triple_buffer::Input<LoopState>,
    requests: &Requests,
    signals: &EndSignals,
) -> LoopReport {
    scheduling::request_fifo();
    let scheduler = scheduling::granted();
    let mut jitter = Jitter::default();
    let started = Instant::now();
    let mut pacer = Pacer::new(Duration::from_secs_f64(1.0 / step.rate_hz()), started);
    let (mut reported, mut reported_steps, mut last) = (started, 0, started);
    while !requests.end.load(Ordering::Acquire) && !signals.is_asked() {
        let (now, late_us) = pacer.wait();
        jitter.note(late_us);
        if requests.resume.swap(false, Ordering::AcqRel) {
            step.resume();
        }
        if requests.emergency.swap(false, Ordering::AcqRel) {
            step.stop();
        }
        let since = (now - reported).as_secs_f64();
        if since > REPORT_INTERVAL_S {
            step.set_timing((jitter.count() - reported_steps) as f64 / since, jitter.lateness());
            (reported, reported_steps) = (now, jitter.count());
        }
        states.write(step.step(models.read(), (now - last).as_secs_f64()));
        last = now;
        pacer.schedule_next();
    }
    step.stop();
    report(step, &jitter, scheduler, pacer.missed(), started.elapsed())
}

fn report(step: LoopStep, jitter: &Jitter, scheduler: String, missed: u64, took: Duration) -> LoopReport {
    let totals = step.into_totals();
    LoopReport {
        rate_hz: jitter.count() as f64 / took.as_secs_f64(),
        scheduler,
        lateness: jitter.lateness(),
        missed,
        dropouts: totals.dropouts,
        max_force_n: totals.max_force_n,
        max_wanted_n: totals.max_wanted_n,
        passivity_j: totals.passivity_j,
        log: totals.log,
    }
}
