//! The tutorial: a steak in ten steps, one control at a time; each step ends when its thing is done.
//!
//! Where one waits, time runs fast until something is to be done; then it runs as it is, so that nothing burns while one reads.

use crate::app::SauteApp;
use saute_controls::act::Card;
use saute_controls::tutorial::{FAST, SLOW, Step, Tutorial};
use saute_kitchen::Place;
use saute_kitchen::advice::Advice;
use saute_session::FoodChoice;

impl SauteApp {
    /// The tutorial while it runs.
    pub fn tutorial(&self) -> Option<&Tutorial> {
        self.leads.learn.tutorial.as_ref()
    }

    /// Begins with a raw steak and a cold pan, or leaves the tutorial.
    pub(crate) fn set_tutorial(&mut self, on: bool) {
        if let Some(left) = self.leads.learn.tutorial.take() {
            self.session.set_speed(left.before);
        }
        // What else leads has the line to itself.
        if !on || self.leads.guided.is_some() {
            return;
        }
        self.settings.choice = FoodChoice::default();
        self.set_out(1);
        self.session.set_paused(false);
        (self.settings.introduced, self.settings.skill_mode, self.settings.few) = (true, false, false);
        (self.desk.card, self.sights.slice) = (None, None);
        (self.settings.panels_hidden, self.settings.projector) = (false, false);
        self.settings.view = saute_picture::View::Look;
        let (before, last_s) = (self.session.speed, self.session.kitchen.time_s());
        self.session.set_speed(SLOW);
        self.leads.learn.tutorial = Some(Tutorial { step: Step::HobOn, before, set: SLOW, passed: [0.0; 2], last_s });
    }

    /// Goes on to the next step once the present one is done, and sets the speed of time.
    pub(crate) fn tutor(&mut self, advice: &[Advice]) {
        let Some(mut tutorial) = self.leads.learn.tutorial.take() else { return };
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
        // A speed that the machine cannot sustain stays given up until the next wait.
        if speed != tutorial.set {
            self.session.set_speed(speed);
            tutorial.set = speed;
        }
        self.leads.learn.tutorial = Some(tutorial);
    }

    /// Returns true if what a step requests is done.
    fn is_done(&self, step: Step, advice: &[Advice]) -> bool {
        let (kitchen, piece) = (&self.session.kitchen, self.session.shown_piece());
        let is_at = |wanted: fn(Place) -> bool| piece.is_some_and(|piece| wanted(piece.place));
        let says = |wanted: fn(&Advice) -> bool| advice.iter().any(wanted);
        match step {
            Step::HobOn => kitchen.hob_w() > 0.0,
            Step::Heat => says(|one| matches!(one, Advice::PutIn { .. })),
            Step::PutIn => is_at(|place| matches!(place, Place::Pan(_))),
            Step::Inside => self.sights.slice.is_some(),
            Step::Flip => piece.is_some_and(|piece| piece.flipped_at().is_some()),
            Step::TakeOut => is_at(|place| matches!(place, Place::Rest(_))),
            Step::HobOff => kitchen.hob_w() == 0.0,
            Step::Rest => says(|one| matches!(one, Advice::Rested { .. })),
            Step::Halve => piece.is_some_and(|piece| piece.halved().is_some()),
            Step::Result => self.desk.card == Some(Card::Result),
        }
    }
}
