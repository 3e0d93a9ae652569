//! The present of a session, which is handed over for forecasts, and what was found of it.

use saute_plan::forecast::{Foreseen, Question};

use super::{AgedForecast, Forecasts, Shown, Watched};
use crate::Session;
use crate::hands::Hands;
use crate::work::Helper;

impl<H: Hands> Session<H> {
    /// Keeps the forecasts fresh at a wall time: those of the piece that the panels show, in the classes of the scale with an id.
    /// Where none is shown, while time is turned, and for food in its packet there are none.
    pub fn foresee(&mut self, now_s: f64, shown: Shown, scale: &str) {
        self.forecasts.take_answers();
        let is_turned = self.is_travelling() || self.timeline.is_held;
        let piece = self.shown_piece().filter(|piece| shown != Shown::Nothing && !is_turned && piece.is_out());
        let Some(food) = piece.map(|piece| piece.id.clone()).filter(|_| self.forecasts.are_made()) else {
            return self.forecasts.rest();
        };
        let scale = self.scale(scale).map(|scale| scale.id.clone());
        let watched = Watched { cook: self.generation, food, scale };
        self.forecasts.watch(&watched);
        self.forecasts.due = None;
        // A clock that lags has no time for what is to come.
        let present = (self.kitchen.frame(), self.done());
        if self.behind_s().is_some() || !self.forecasts.want(&watched, shown, present, now_s) {
            return;
        }
        self.forecasts.due = Some((watched, now_s, shown));
        if self.paused || self.kitchen.is_between_ticks() {
            self.hand_over_present();
        }
    }

    /// Hands the present over if it is due.
    pub(crate) fn hand_over_present(&mut self) {
        let Some(due) = self.forecasts.due.take() else { return };
        let done = self.done();
        self.forecasts.ask(due, &self.kitchen, done);
    }

    /// A count of what was done in this cook so far, by hands and by its recipe.
    fn done(&self) -> u64 {
        (self.recording.entries().len() + self.marks.len()) as u64
    }

    /// The last answer to a question about the piece that the panels show, relative to the shown instant.
    pub fn foreseen(&self, question: Question) -> Option<AgedForecast<'_>> {
        let food = &self.shown_piece()?.id;
        let of = |answer: &&Foreseen| answer.outlook.question == question && answer.outlook.food == *food;
        let answer = self.forecasts.answers.iter().find(of)?;
        let band = self.forecasts.bands.as_ref()?.of(question)?;
        Some(AgedForecast {
            answer,
            band,
            age_s: answer.age_s(self.kitchen.frame()),
            is_current: answer.is_current(self.done()),
        })
    }

    /// The last answer of the full model to "as it is", a minute ahead, if nothing was done since.
    pub fn foreseen_exactly(&self) -> Option<&Foreseen> {
        let answer = self.forecasts.exact.as_ref().filter(|answer| answer.is_current(self.done()))?;
        (answer.outlook.food == self.shown_piece()?.id).then_some(answer)
    }

    /// Who makes forecasts, and what was found.
    pub fn forecasts(&self) -> &Forecasts {
        &self.forecasts
    }

    /// Lets a helper make forecasts.
    pub fn employ_for_forecasts(&mut self, helper: Box<dyn Helper>) {
        self.forecasts.employ(helper);
    }
}
