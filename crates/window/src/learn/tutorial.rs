//! The tutorial: a steak in ten steps, one control at a time; each step ends when its thing is done.
//!
//! Where one waits, time runs fast until something is to be done; then it runs as it is, so that nothing burns while one reads.

use saute_kitchen::Place;
use saute_kitchen::advice::Advice;

use crate::act::{Act, AppAct, Card, CookAct, ViewAct};
use crate::app::SauteApp;
use saute_session::SteakChoice;

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

    /// Time that it takes to read what it says and to find its control [wall s] (chosen: a sentence of twenty words, and a look
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
    step: Step,
    /// Speed that was set before it began [-].
    before: f64,
    /// Speed that it has set [-].
    set: f64,
    /// Simulated and wall time of what has run so far [s].
    passed: [f64; 2],
    last_s: f64,
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
    fn note(&mut self, time_s: f64) {
        let by = (time_s - self.last_s).max(0.0);
        self.passed = [self.passed[0] + by, self.passed[1] + by / self.set];
        self.last_s = time_s;
    }
}

impl SauteApp {
    /// The tutorial while it runs.
    pub fn tutorial(&self) -> Option<&Tutorial> {
        self.learn.tutorial.as_ref()
    }

    /// Begins with a raw steak and a cold pan, or leaves the tutorial.
    pub(crate) fn set_tutorial(&mut self, on: bool) {
        if let Some(left) = self.learn.tutorial.take() {
            self.session.set_speed(left.before);
        }
        if !on {
            return;
        }
        self.settings.choice = SteakChoice::default();
        self.set_out();
        self.session.set_paused(false);
        (self.settings.introduced, self.settings.skill_mode) = (true, false);
        (self.card, self.slice, self.settings.panels_hidden) = (None, None, false);
        self.settings.view = saute_picture::View::Look;
        let (before, last_s) = (self.session.speed, self.session.kitchen.time_s());
        self.session.set_speed(SLOW);
        self.learn.tutorial = Some(Tutorial { step: Step::HobOn, before, set: SLOW, passed: [0.0; 2], last_s });
    }

    /// Goes on to the next step once the present one is done, and sets the speed of time.
    pub(crate) fn tutor(&mut self, advice: &[Advice]) {
        let Some(mut tutorial) = self.learn.tutorial.take() else { return };
        tutorial.note(self.session.kitchen.time_s());
        if self.is_done(tutorial.step, advice) {
            let Some(next) = Step::ALL.get(tutorial.place() + 1) else {
                self.session.set_speed(tutorial.before);
                return self.say("tutorial.over");
            };
            tutorial.step = *next;
        }
        let is_due = advice.iter().any(|one| one.is_due());
        let speed = if tutorial.step.waits() && !is_due { FAST } else { SLOW };
        // A speed that the machine cannot hold stays given up until the next wait.
        if speed != tutorial.set {
            self.session.set_speed(speed);
            tutorial.set = speed;
        }
        self.learn.tutorial = Some(tutorial);
    }

    /// Returns true if what a step asks for is done.
    fn is_done(&self, step: Step, advice: &[Advice]) -> bool {
        let (kitchen, piece) = (&self.session.kitchen, self.session.steak());
        let is_at = |wanted: fn(Place) -> bool| piece.is_some_and(|piece| wanted(piece.place));
        let says = |wanted: fn(&Advice) -> bool| advice.iter().any(wanted);
        match step {
            Step::HobOn => kitchen.hob_w() > 0.0,
            Step::Heat => says(|one| matches!(one, Advice::PutIn { .. })),
            Step::PutIn => is_at(|place| matches!(place, Place::Pan(_))),
            Step::Inside => self.slice.is_some(),
            Step::Flip => piece.is_some_and(|piece| piece.flipped_at().is_some()),
            Step::TakeOut => is_at(|place| matches!(place, Place::Rest(_))),
            Step::HobOff => kitchen.hob_w() == 0.0,
            Step::Rest => says(|one| matches!(one, Advice::Rested { .. })),
            Step::Halve => piece.is_some_and(|piece| piece.halved().is_some()),
            Step::Result => self.card == Some(Card::Result),
        }
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
