//! The tutorial: a steak in ten steps, one control at a time; each step ends when its thing is done.
//!
//! Where one waits, time runs fast until something is to be done; then it runs as it is, so that nothing burns while one reads.

use crate::act::{Act, AppAct, Card, CookAct, ViewAct};

/// Speed of time while one waits [-].
pub const FAST: f64 = 20.0;

/// Speed of time while something is to be done [-].
pub const SLOW: f64 = 1.0;

/// What the whole tutorial stays below [wall s].
pub const MOST_S: f64 = 180.0;

/// A step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// Turn the hob on.
    HobOn,
    /// Wait until the pan is hot.
    Heat,
    /// Put the steak in.
    PutIn,
    /// Look inside.
    Inside,
    /// Flip it when it is time.
    Flip,
    /// Take it out when it is time.
    TakeOut,
    /// Turn the hob off.
    HobOff,
    /// Let it rest.
    Rest,
    /// Halve it.
    Halve,
    /// See the result.
    Result,
}

impl Step {
    /// All steps in their order.
    pub const ALL: [Self; 10] = [
        Self::HobOn,
        Self::Heat,
        Self::PutIn,
        Self::Inside,
        Self::Flip,
        Self::TakeOut,
        Self::HobOff,
        Self::Rest,
        Self::Halve,
        Self::Result,
    ];

    /// Time that it takes to read its text and to find its control [wall s] (chosen: a sentence of twenty words, and a look
    /// round).
    pub fn reading_s(self) -> f64 {
        match self {
            Self::Heat | Self::Rest => 5.0,
            _ => 8.0,
        }
    }

    /// Returns true if one waits in it until the food or the pan is ready.
    pub fn waits(self) -> bool {
        matches!(self, Self::Heat | Self::Flip | Self::TakeOut | Self::Rest)
    }
}

/// The tutorial while it runs.
#[derive(Clone, Debug, PartialEq)]
pub struct Tutorial {
    /// The present step.
    pub step: Step,
    /// Speed that was set before it began [-].
    pub before: f64,
    /// Speed that it has set [-].
    pub set: f64,
    /// Simulated and wall time of what has run so far [s].
    pub passed: [f64; 2],
    /// Simulated time at the last look [s].
    pub last_s: f64,
}

impl Tutorial {
    /// The present step.
    pub fn step(&self) -> Step {
        self.step
    }

    /// Place of the present step among all.
    pub fn place(&self) -> usize {
        Step::ALL.iter().position(|step| *step == self.step).unwrap_or(0)
    }

    /// Time that passed in the kitchen, and how long that took at the speeds of the tutorial [s].
    pub fn passed_s(&self) -> [f64; 2] {
        self.passed
    }

    /// Notes the time of the kitchen.
    pub fn note(&mut self, time_s: f64) {
        let by = (time_s - self.last_s).max(0.0);
        self.passed = [self.passed[0] + by, self.passed[1] + by / self.set];
        self.last_s = time_s;
    }
}

/// The control that a step is about.
pub fn control(step: Step) -> Option<Act> {
    Some(match step {
        Step::PutIn => Act::Cook(CookAct::Put),
        Step::Inside => Act::View(ViewAct::Slice),
        Step::Flip => Act::Cook(CookAct::Flip),
        Step::TakeOut => Act::Cook(CookAct::Out),
        Step::Halve => Act::Cook(CookAct::Halve),
        Step::Result => Act::App(AppAct::Open(Card::Result)),
        Step::HobOn => Act::Cook(CookAct::HobSet(1100.0)),
        Step::HobOff => Act::Cook(CookAct::HobSet(0.0)),
        Step::Heat | Step::Rest => return None,
    })
}
