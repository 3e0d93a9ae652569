//! Keeps the forecasts of one piece fresh, in small parts of work.
//!
//! A round answers some or all questions from one present, on coarse meshes; the next begins from a newer present. While nothing is done, "as
//! it is" goes on from where it is instead, and begins again every half minute. It also runs the full model, from the present at which
//! something was done last, and ten seconds further every ten seconds. The desk has no
//! clock: the shell gives it the present when it needs it ([`Desk::wants`]), and calls [`Desk::advance`] while it has time.

use std::sync::Arc;

use saute_kitchen::food::{BuildError, Scale};
use saute_kitchen::reduced::Reductions;
use saute_kitchen::{FRAME_S, Kitchen};
use serde::{Deserialize, Serialize};

use crate::forecast::ahead::Ahead;
use crate::forecast::exact::{EXACT_S, Exact};
use crate::forecast::outlook::Outlook;
use crate::forecast::question::{Ask, Question};

/// Age at which "as it is" with the full model looks further [s].
const EXACT_AGE_S: f64 = 10.0;
/// Age at which "as it is" on coarse meshes begins again, if its core is still that of the kitchen [s] (chosen: its other errors have not grown
/// by then, and the work of beginning is spread over many rounds).
const COURSE_AGE_S: f64 = 30.0;
/// Difference of the core from that of "as it is" up to which that is still the course of the kitchen [K] (chosen: between two samples
/// the core is not quite linear).
const SAME_K: f64 = 0.05;
/// Steps on coarse meshes that cost as much as a tick of the full model [-] (measured with a steak of 120 × 80 × 25 mm: 0.07
/// and 0.49 ms).
const STEPS_PER_TICK: u64 = 7;
/// Parts of work on a round for each part with the full model, while both are open [-] (chosen: with half a core, a steak's
/// round then ends twice a second, and the full model is through in three seconds).
const ROUND_PARTS: u64 = 3;

/// A finished forecast.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Foreseen {
    /// Its content.
    pub outlook: Outlook,
    /// What had been done when it began, as the shell counts it.
    pub done: u64,
}

impl Foreseen {
    /// Age at a frame of the kitchen [s].
    pub fn age_s(&self, frame: u64) -> f64 {
        frame.saturating_sub(self.outlook.frame) as f64 * FRAME_S
    }

    /// Returns true if nothing was done since it began, given what has been done now.
    pub fn is_current(&self, done: u64) -> bool {
        self.done == done
    }
}

/// What the desk needs from the shell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wanted {
    /// Time for its work.
    Time,
    /// The present kitchen.
    Present,
    /// Nothing: no piece is watched, or the present is what it has forecast.
    Nothing,
}

/// The desk: questions, running forecasts and results.
#[derive(Clone, Debug, Default)]
pub struct Desk {
    watched: Option<(String, Option<Arc<Scale>>)>,
    reductions: Reductions,
    /// What of the round is still to do, the next one last.
    round: Vec<Ahead>,
    /// "As it is" on coarse meshes once it is through, and what had been done when it began: it can look further.
    course: Option<(Ahead, u64)>,
    exact: Option<Exact>,
    /// Frame and what had been done at the last present.
    present: Option<(u64, u64)>,
    /// The same when the full model began.
    exact_from: Option<(u64, u64)>,
    answers: Vec<Foreseen>,
    exact_answer: Option<Foreseen>,
    parts: u64,
}

impl Desk {
    /// Watches a piece, with the scale in whose classes its section is shared out; or none. What was found of another one is
    /// dropped.
    pub fn watch(&mut self, food: Option<&str>, scale: Option<Arc<Scale>>) {
        let same = self.watched.as_ref().map(|(food, scale)| (food.as_str(), scale.as_ref().map(|scale| &scale.id)));
        if same != food.map(|food| (food, scale.as_ref().map(|scale| &scale.id))) {
            *self = Self { reductions: std::mem::take(&mut self.reductions), ..Self::default() };
            self.watched = food.map(|food| (food.to_owned(), scale));
        }
    }

    /// Returns what it needs, given the frame of the present kitchen and a count of what was done there so far.
    pub fn wants(&self, frame: u64, done: u64) -> Wanted {
        if self.watched.is_none() {
            return Wanted::Nothing;
        }
        match self.present {
            Some(present) if self.round.is_empty() && present == (frame, done) => {
                if self.exact.as_ref().is_some_and(|exact| !exact.is_done()) { Wanted::Time } else { Wanted::Nothing }
            }
            // An older frame is that of a cook that went back.
            Some((then, was_done)) if !self.round.is_empty() && was_done == done && frame >= then => Wanted::Time,
            _ => Wanted::Present,
        }
    }

    /// Begins a round of all questions from a kitchen, given a count of what was done there so far.
    ///
    /// # Errors
    /// If a coarse mesh cannot be built.
    pub fn begin(&mut self, kitchen: &Kitchen, done: u64) -> Result<(), BuildError> {
        self.begin_with(kitchen, done, &Question::ALL)
    }

    /// Begins a round of some questions from a kitchen, given a count of what was done there so far; the last answers to the others age.
    /// While a hand moves food there is none, and all of them age.
    ///
    /// # Errors
    /// If a coarse mesh cannot be built.
    pub fn begin_with(&mut self, kitchen: &Kitchen, done: u64, questions: &[Question]) -> Result<(), BuildError> {
        let Some((food, scale)) = self.watched.clone() else { return Ok(()) };
        let ask = |question| Ask { food: food.clone(), question, scale: scale.clone() };
        let frame = kitchen.frame();
        if self.present.is_some_and(|(then, _)| frame < then) {
            (self.answers, self.course, self.exact, self.exact_answer, self.exact_from) =
                (Vec::new(), None, None, None, None);
        }
        self.present = Some((frame, done));
        let asks: Vec<Ask> = questions.iter().copied().map(ask).collect();
        self.round = self.asked(kitchen, &asks, done)?;
        let all = Question::ALL.map(ask);
        let possible = |answer: &Foreseen| all.iter().any(|ask| is_of(answer, ask) && is_possible(kitchen, ask));
        self.answers.retain(possible);
        if self.is_exact_due(frame, done) && !self.looks_further(kitchen, done) {
            self.exact_from = Some((frame, done));
            // A kitchen refuses nothing to one that does nothing.
            self.exact = Exact::begin(kitchen, &ask(Question::AsItIs), EXACT_S).ok().flatten();
        }
        Ok(())
    }

    /// Lets the full model look further from a later present that it has passed; returns false if it has to begin again.
    fn looks_further(&mut self, kitchen: &Kitchen, done: u64) -> bool {
        let (Some((then, was_done)), Some(exact)) = (self.exact_from, &mut self.exact) else { return false };
        let age_s = kitchen.frame().saturating_sub(then) as f64 * FRAME_S;
        if was_done != done || kitchen.frame() < then || age_s >= EXACT_S {
            return false;
        }
        if !exact.is_done() {
            return true;
        }
        if !is_course_of(exact.outlook(), kitchen, age_s) {
            return false;
        }
        let by_s = EXACT_AGE_S * libm::floor(age_s / EXACT_AGE_S);
        exact.look_further(by_s);
        self.exact_from = Some((then + (by_s / FRAME_S).round() as u64, done));
        true
    }

    /// What the full model still has to run; nothing once it is done.
    fn open_exact(&mut self) -> Option<&mut Exact> {
        self.exact.as_mut().filter(|exact| !exact.is_done())
    }

    /// The forecasts of a round; nothing while a hand moves food: on coarse meshes it would stay where it is.
    fn asked(&mut self, kitchen: &Kitchen, asks: &[Ask], done: u64) -> Result<Vec<Ahead>, BuildError> {
        let mut course = self.course_from(kitchen, done);
        if kitchen.is_moving_food() {
            return Ok(Vec::new());
        }
        let reduced = kitchen.reduced(&mut self.reductions)?;
        let of = |ask: &Ask| {
            let going_on = if ask.question == Question::AsItIs { course.take() } else { None };
            going_on.or_else(|| Ahead::from(kitchen, reduced.clone(), ask))
        };
        Ok(asks.iter().rev().filter_map(of).collect())
    }

    /// Takes "as it is" on coarse meshes, to look further from a later present; none if it has to begin again.
    fn course_from(&mut self, kitchen: &Kitchen, done: u64) -> Option<Ahead> {
        let (mut course, was_done) = self.course.take()?;
        let by_s = kitchen.frame().saturating_sub(course.outlook().frame) as f64 * FRAME_S;
        let is_young = course.since_begun_s() + by_s < COURSE_AGE_S;
        let goes_on = was_done == done && is_young && is_course_of(course.outlook(), kitchen, by_s);
        goes_on.then(|| {
            course.look_further(kitchen);
            course
        })
    }

    fn is_exact_due(&self, frame: u64, done: u64) -> bool {
        self.exact_from.is_none_or(|(then, was_done)| {
            was_done != done || frame < then || (frame - then) as f64 * FRAME_S >= EXACT_AGE_S
        })
    }

    /// Works for `ticks` ticks of the full model at most, or for as long as as many steps on coarse meshes take; returns
    /// those that it worked.
    pub fn advance(&mut self, ticks: u64) -> u64 {
        let mut worked = 0;
        while worked < ticks && self.work_a_tick() {
            worked += 1;
        }
        worked
    }

    fn work_a_tick(&mut self) -> bool {
        self.parts += 1;
        let turn_of_exact = self.round.is_empty() || self.parts.is_multiple_of(ROUND_PARTS + 1);
        if turn_of_exact && self.open_exact().is_some() {
            self.work_exact();
            return true;
        }
        self.work_round()
    }

    fn work_exact(&mut self) {
        let done = self.exact_from.map_or(0, |(_, done)| done);
        let Some(exact) = self.open_exact() else { return };
        exact.advance(1);
        if exact.is_done() {
            self.exact_answer = Some(Foreseen { outlook: exact.outlook().clone(), done });
        }
    }

    fn work_round(&mut self) -> bool {
        let Some(ahead) = self.round.last_mut() else { return false };
        ahead.advance(STEPS_PER_TICK);
        if let Some(ahead) = self.round.pop_if(|ahead| ahead.is_done()) {
            self.keep(ahead);
        }
        true
    }

    fn keep(&mut self, ahead: Ahead) {
        let outlook = ahead.outlook().clone();
        let done = self.present.map_or(0, |(_, done)| done);
        self.answers.retain(|answer| answer.outlook.question != outlook.question);
        if outlook.question == Question::AsItIs {
            self.course = Some((ahead, done));
        }
        self.answers.push(Foreseen { outlook, done });
    }

    /// The last answer to a question, five minutes ahead on coarse meshes.
    pub fn answer(&self, question: Question) -> Option<&Foreseen> {
        self.answers.iter().find(|answer| answer.outlook.question == question)
    }

    /// The last answer of the full model to "as it is", a minute ahead.
    pub fn exact_answer(&self) -> Option<&Foreseen> {
        self.exact_answer.as_ref()
    }
}

/// Returns true if a kitchen has come, `by_s` after the present of "as it is", to the state in that forecast.
fn is_course_of(outlook: &Outlook, kitchen: &Kitchen, by_s: f64) -> bool {
    kitchen.piece(&outlook.food).is_some_and(|piece| (piece.core() - outlook.core_at(by_s)).abs() <= SAME_K)
}

fn is_of(answer: &Foreseen, ask: &Ask) -> bool {
    answer.outlook.question == ask.question && answer.outlook.food == ask.food
}

fn is_possible(kitchen: &Kitchen, ask: &Ask) -> bool {
    ask.question.commands(kitchen, &ask.food).is_some()
}
