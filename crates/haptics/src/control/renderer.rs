//! Force rendering: from the device's sample and the latest contact model to the commanded wrench.

use crate::control::coupled_payload::CoupledPayload;
use crate::control::feel::Feel;
use crate::control::guard_planes::GuardPlanes;
use crate::control::impulse_train::ImpulseTrain;
use crate::control::passivity::Passivity;
use crate::control::rumble::{Rumble, RumbleRule};
use crate::control::safety_limits::SafetyLimits;
use crate::control::vibration::Vibration;
use crate::device::{Capabilities, HapticCommand, HapticSample, Health};
use crate::kitchen::contact_model::ContactModel;
use crate::wrench::Wrench;

/// Renders the command of each step; it uses no clock, no thread and no allocation.
#[derive(Clone, Debug)]
pub struct Renderer {
    capabilities: Capabilities,
    payload: CoupledPayload,
    guard: GuardPlanes,
    impulses: ImpulseTrain,
    vibration: Vibration,
    rumble: RumbleRule,
    passivity: Passivity,
    limits: SafetyLimits,
    timing: Timing,
    model: ContactModel,
    model_age: f64,
    /// Gain of soft start and fade, 0 to 1 [-].
    share: f64,
}

#[derive(Clone, Copy, Debug)]
struct Timing {
    soft_start: f64,
    timeout: f64,
    fade: f64,
}

impl Renderer {
    /// Creates a renderer that commands no force until a model and a sample have arrived.
    pub fn new(capabilities: &Capabilities, feel: &Feel) -> Self {
        let limits = &capabilities.limits;
        let timing = &feel.timing;
        Self {
            payload: CoupledPayload::new(&feel.payload, capabilities),
            guard: GuardPlanes::new(&feel.guard, limits),
            impulses: ImpulseTrain::new(&feel.impulse),
            vibration: Vibration::new(&feel.sizzle, &feel.slide),
            rumble: RumbleRule::new(feel),
            passivity: Passivity::new(timing.reserve_mj * 1e-3, capabilities.most_damping()),
            limits: SafetyLimits::new(*limits),
            timing: Timing { soft_start: timing.soft_start_s, timeout: timing.model_timeout_s, fade: timing.fade_s },
            model: ContactModel::default(),
            model_age: f64::INFINITY,
            share: 0.0,
            capabilities: capabilities.clone(),
        }
    }

    /// Returns the command for a sample; `model` is the newest contact model, `dt` the time since the last step [s].
    pub fn step(&mut self, sample: &HapticSample, model: &ContactModel, dt: f64) -> HapticCommand {
        self.take(model, dt);
        // Without a valid pose no force has a defined direction.
        let running = sample.health == Health::Running && sample.pose.is_finite() && sample.twist.is_finite();
        let lively = running && self.model_age < self.timing.timeout;
        let change = if lively { dt / self.timing.soft_start.max(dt) } else { -dt / self.timing.fade };
        self.share = if running { (self.share + change).clamp(0.0, 1.0) } else { 0.0 };
        // Collisions during a pause must not be rendered later.
        let rumble = self.rumble(dt);
        if self.share == 0.0 {
            self.rest();
            return HapticCommand { enabled: lively, ..HapticCommand::default() };
        }
        HapticCommand { wrench: self.wrench(sample, dt), enabled: true, rumble }
    }

    /// Restarts from rest with a full reserve of energy, after a stop.
    pub fn restart(&mut self) {
        self.rest();
        self.passivity.restart();
        self.share = 0.0;
    }

    /// Resets everything that must restart from rest.
    fn rest(&mut self) {
        self.limits.rest();
        self.passivity.rest();
        self.payload.forget();
    }

    fn take(&mut self, model: &ContactModel, dt: f64) {
        if model.number == self.model.number {
            self.model_age += dt;
            return;
        }
        self.model = *model;
        self.model_age = 0.0;
        let energy = self.impulses.take(&model.impulses);
        // A scaled collision brings scaled energy.
        self.passivity.credit(energy * self.share);
    }

    fn wrench(&mut self, sample: &HapticSample, dt: f64) -> Wrench {
        let (model, pose, twist) = (&self.model, &sample.pose, &sample.twist);
        let renders_pan = self.capabilities.renders_pan(model.own.mass);
        let carried = if renders_pan { model.payload.with(&model.own) } else { model.payload };
        let held = self.payload.held();
        let payload = self.payload.step(&carried, pose, twist, dt);
        let mut active = payload.felt - payload.weight;
        active += model.loose;
        active += self.guard.wrench(&model.planes, pose, twist);
        active += self.impulses.step(pose, dt);
        active += self.vibration.step(model, pose, dt);
        let active = self.capabilities.shown(&(active * self.share));
        let weight = self.capabilities.shown(&((payload.weight + model.loose_weight) * self.share));
        self.account(sample, held, dt);
        let active = self.limits.within_energy(&active, twist, dt);
        let active = self.passivity.control(&active, twist, dt);
        let shown = self.limits.bounded(&(active + weight), dt);
        self.passivity.shown(&(shown - weight), &weight);
        shown
    }

    /// Charges the work of the last command; `held` is the payload's energy before this step [J].
    fn account(&mut self, sample: &HapticSample, held: f64, dt: f64) {
        let now = self.payload.held();
        let spent = self.passivity.observe(&sample.pose, &sample.achieved, now * self.share, dt);
        self.limits.charge(spent, (held - now) * self.share, dt);
    }

    fn rumble(&mut self, dt: f64) -> Rumble {
        let Rumble { strong, weak } = self.rumble.step(&self.model, dt);
        self.capabilities.rumbled(&Rumble { strong: strong * self.share, weak: weak * self.share })
    }

    /// Returns the passivity observer.
    pub fn passivity(&self) -> &Passivity {
        &self.passivity
    }

    /// Returns the gain of soft start and fade, 0 to 1 [-]; it falls when no fresh model arrives.
    pub fn share(&self) -> f64 {
        self.share
    }
}
