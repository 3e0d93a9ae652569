//! From where the pan is and what the kitchen last said, what the hand shall feel.

use crate::kitchen::contact_model::ContactModel;
use crate::control::coupled_payload::CoupledPayload;
use crate::device::{Capabilities, HapticCommand, HapticSample, Health};
use crate::control::feel::Feel;
use crate::control::guard_planes::GuardPlanes;
use crate::control::impulse_train::ImpulseTrain;
use crate::control::passivity::Passivity;
use crate::control::rumble::{Rumble, RumbleRule};
use crate::control::safety_limits::SafetyLimits;
use crate::control::vibration::Vibration;
use crate::wrench::Wrench;

/// One step after the other of what a hand feels: no clock, no thread, no allocation.
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
    /// How much of the forces is shown: 0 to 1.
    share: f64,
}

#[derive(Clone, Copy, Debug)]
struct Timing {
    soft_start: f64,
    timeout: f64,
    fade: f64,
}

impl Renderer {
    /// Nothing is felt until a model and a sample have come.
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

    /// What to command after a sample; `model` is the newest one, `dt` the time since the last step [s].
    pub fn step(&mut self, sample: &HapticSample, model: &ContactModel, dt: f64) -> HapticCommand {
        self.take(model, dt);
        // A device that does not know where it is cannot be pulled anywhere.
        let running = sample.health == Health::Running && sample.pose.is_finite() && sample.twist.is_finite();
        let lively = running && self.model_age < self.timing.timeout;
        let change = if lively { dt / self.timing.soft_start.max(dt) } else { -dt / self.timing.fade };
        self.share = if running { (self.share + change).clamp(0.0, 1.0) } else { 0.0 };
        // What collides while nothing is felt must not be felt later.
        let rumble = self.rumble(dt);
        if self.share == 0.0 {
            self.rest();
            return HapticCommand { enabled: lively, ..HapticCommand::default() };
        }
        HapticCommand { wrench: self.wrench(sample, dt), enabled: true, rumble }
    }

    /// Nothing is felt: what comes next begins from stillness.
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
        // What is felt in part brings its energy in part.
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
        self.settle(sample, held, dt);
        let active = self.limits.within_energy(&active, twist, dt);
        let active = self.passivity.control(&active, twist, dt);
        let shown = self.limits.bounded(&(active + weight), dt);
        self.passivity.shown(&(shown - weight), &weight);
        shown
    }

    /// Settles what the last command did; before it the payload held so much [J].
    fn settle(&mut self, sample: &HapticSample, held: f64, dt: f64) {
        let now = self.payload.held();
        let spent = self.passivity.observe(&sample.pose, &sample.achieved, now * self.share, dt);
        self.limits.settle(spent, (held - now) * self.share, dt);
    }

    fn rumble(&mut self, dt: f64) -> Rumble {
        let Rumble { strong, weak } = self.rumble.step(&self.model, dt);
        self.capabilities.rumbled(&Rumble { strong: strong * self.share, weak: weak * self.share })
    }

    /// The passivity observer.
    pub fn passivity(&self) -> &Passivity {
        &self.passivity
    }

    /// How much of the forces is shown: grows from 0 to 1 at the start, fades when no fresh model comes [-].
    pub fn share(&self) -> f64 {
        self.share
    }
}
