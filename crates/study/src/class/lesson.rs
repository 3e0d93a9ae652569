//! A cook of a scenario, watched: questions, answers and the truth.

use std::sync::Arc;

use saute_kitchen::{Kitchen, Piece, celsius};

use super::result_row::{RestKind, ResultRow};
use super::scenario::{Ask, Scenario, When};
use super::scenario_file::Deed;
use crate::measures::Measures;
use crate::participant::Participant;

/// A cook of a scenario, watched from its beginning.
#[derive(Clone, Debug)]
pub struct Lesson {
    /// The scenario.
    pub scenario: Arc<Scenario>,
    /// Code of the student, if there is one.
    pub student: Option<Participant>,
    put_s: Option<f64>,
    flip_s: Option<f64>,
    out_s: Option<f64>,
    asked: Vec<Asked>,
}

/// A question of a lesson.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Asked {
    /// When it was asked [s]; none before.
    pub at_s: Option<f64>,
    /// The answer, in the unit of the question; of a class its place.
    pub answer: Option<f64>,
    /// The truth, in the same unit; none until it is known.
    pub truth: Option<f64>,
}

impl Lesson {
    /// Begins a lesson.
    pub fn begin(scenario: Arc<Scenario>, student: Option<Participant>) -> Self {
        let asked = vec![Asked::default(); scenario.predictions.len()];
        Self { scenario, student, put_s: None, flip_s: None, out_s: None, asked }
    }

    /// Questions in the order of the scenario.
    pub fn asked(&self) -> &[Asked] {
        &self.asked
    }

    /// The place of the question that waits for an answer.
    pub fn waiting(&self) -> Option<usize> {
        self.asked.iter().position(|asked| asked.at_s.is_some() && asked.answer.is_none())
    }

    /// True while a question about what is still to come has no answer: what foretells it would give it away.
    pub fn asks_ahead(&self) -> bool {
        let is_ahead = |ask| matches!(ask, Ask::CoreIn(_) | Ask::CorePeak | Ask::ClassInTheEnd);
        self.asked
            .iter()
            .zip(&self.scenario.predictions)
            .any(|(one, predict)| one.answer.is_none() && is_ahead(predict.ask))
    }

    /// Looks at the kitchen after a tick; returns true if a question has become due: the cook is then to be paused.
    pub fn observe(&mut self, kitchen: &Kitchen) -> bool {
        let Some(piece) = kitchen.pieces().first() else { return false };
        let now = kitchen.time_s();
        if piece.in_pan() {
            self.put_s.get_or_insert(now);
        }
        self.flip_s = self.flip_s.or(piece.flipped_at());
        if self.put_s.is_some() && piece.lies_on_board() {
            self.out_s.get_or_insert(now);
        }
        self.learn_truths(piece, now);
        self.ask_next(piece, now)
    }

    /// Notes the truths about an instant that has come, without a new question.
    pub(super) fn learn(&mut self, kitchen: &Kitchen) {
        if let Some(piece) = kitchen.pieces().first() {
            self.learn_truths(piece, kitchen.time_s());
        }
    }

    /// True if the food was in the pan and was taken out.
    pub(super) fn was_cooked(&self) -> bool {
        self.put_s.is_some() && self.out_s.is_some()
    }

    /// True if the instant of a question is still to come.
    pub(super) fn awaits(&self, now: f64) -> bool {
        self.asked.iter().zip(&self.scenario.predictions).any(|(asked, predict)| match (predict.ask, asked.at_s) {
            (Ask::CoreIn(in_s), Some(at_s)) => asked.truth.is_none() && now < at_s + in_s,
            _ => false,
        })
    }

    /// Asks the first question that is due, if none waits.
    fn ask_next(&mut self, piece: &Piece, now: f64) -> bool {
        if self.waiting().is_some() {
            return false;
        }
        let due = |when: When| match when {
            When::At(at_s) => now >= at_s,
            When::Core(core) => piece.core() >= core,
            When::After(deed, after_s) => self.done_s(deed).is_some_and(|done_s| now >= done_s + after_s),
        };
        let next = (0..self.asked.len())
            .find(|place| self.asked[*place].at_s.is_none() && due(self.scenario.predictions[*place].when));
        let Some(place) = next else { return false };
        let truth = match self.scenario.predictions[place].ask {
            Ask::CoreNow => Some(celsius(piece.core())),
            Ask::UndersideBrown => Some(piece.model.face_reading(&piece.state, piece.up()).browned_pct),
            Ask::CoreIn(_) | Ask::CorePeak | Ask::ClassInTheEnd => None,
        };
        self.asked[place] = Asked { at_s: Some(now), answer: None, truth };
        true
    }

    fn done_s(&self, deed: Deed) -> Option<f64> {
        match deed {
            Deed::Put => self.put_s,
            Deed::Flip => self.flip_s,
            Deed::Out => self.out_s,
        }
    }

    /// Notes the truths about an instant that has come.
    fn learn_truths(&mut self, piece: &Piece, now: f64) {
        for (asked, predict) in self.asked.iter_mut().zip(&self.scenario.predictions) {
            let (Ask::CoreIn(in_s), Some(at_s)) = (predict.ask, asked.at_s) else { continue };
            if now >= at_s + in_s {
                asked.truth.get_or_insert(celsius(piece.core()));
            }
        }
    }

    /// Takes the answer to the question that waits; returns its place. An answer out of its range is refused.
    pub fn answer(&mut self, answer: f64) -> Option<usize> {
        let place = self.waiting()?;
        let ask = self.scenario.predictions[place].ask;
        let [low, high] = ask.range().unwrap_or([0.0, self.scenario.goal.scale.class.len() as f64 - 1.0]);
        if !(low..=high).contains(&answer) {
            return None;
        }
        self.asked[place].answer = Some(answer);
        Some(place)
    }

    /// Ends the lesson. The truth about the end is known if the food has rested; else it stays empty. Returns the row to hand in.
    pub fn end(&mut self, measures: &Measures, rest: RestKind) -> ResultRow {
        let scale = &self.scenario.goal.scale;
        for (asked, predict) in self.asked.iter_mut().zip(&self.scenario.predictions) {
            let truth = match predict.ask {
                Ask::CorePeak => Some(measures.core_peak_c),
                Ask::ClassInTheEnd => Some(scale.class_of(scale.of_nodes(measures.at_core)) as f64),
                _ => None,
            };
            let is_known = rest != RestKind::None && asked.at_s.is_some();
            asked.truth = asked.truth.or(truth.filter(|_| is_known));
        }
        let row = ResultRow::of(&self.scenario, self.student.as_ref(), measures, &self.asked);
        ResultRow { rest: Some(rest), ..row }
    }
}
