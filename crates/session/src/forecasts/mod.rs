//! Forecasts of the piece that the panels show, made off the frame ([`work`](crate::work)).
//!
//! The window hands over the present kitchen as bytes when the desk on the other side needs it, twice a second at most, and keeps what
//! comes back. Nobody waits: an answer states from which frame it is, and what had been done by then.

pub mod foreseeing;
mod present;

use saute_kitchen::Kitchen;
use saute_plan::forecast::{Band, Bands, Foreseen, Question};
use serde::{Deserialize, Serialize};

use crate::work::Helper;

/// Wall time between two presents at least [s]: two rounds a second.
const APART_S: f64 = 0.5;
/// How late a present may be that still counts as on time, so that frames that do not meet half a second make no round fewer [s] (chosen:
/// some frames).
const LATE_S: f64 = 0.1;
/// Age from which an answer states how old it is [simulated s].
const OLD_S: f64 = 2.0;

/// An order: the present of a cook. Behind it come the bytes of the kitchen, which are not copied once more for that.
#[derive(Debug, Deserialize, Serialize)]
struct Present {
    number: u64,
    /// The cook: what was found of another one is dropped.
    cook: u64,
    /// What has been done so far.
    done: u64,
    /// Name of the piece that is watched.
    food: String,
    /// Id of the scale in whose classes its section is shared out.
    scale: Option<String>,
    /// The questions.
    questions: Vec<Question>,
}

impl Present {
    /// The order as bytes.
    fn order(&self, kitchen: &Kitchen) -> Vec<u8> {
        let mut bytes = postcard::to_allocvec(self).expect("a present has no kind that postcard lacks");
        kitchen.append_bytes(&mut bytes);
        bytes
    }
}

/// What comes back: all that is known of the piece.
#[derive(Debug, Deserialize, Serialize)]
struct FoundForecast {
    number: u64,
    answers: Vec<Foreseen>,
    exact: Option<Foreseen>,
    /// True if the round is over: a newer present is needed.
    wants_present: bool,
}

/// What is watched, in which cook.
#[derive(Clone, Debug, PartialEq)]
struct Watched {
    cook: u64,
    food: String,
    scale: Option<String>,
}

/// What of the forecasts is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Shown {
    /// Nothing.
    Nothing,
    /// The line and the curves.
    Line,
    /// The table of all questions, too.
    Table,
}

impl Shown {
    /// What it shows the answers to.
    fn questions(self) -> &'static [Question] {
        match self {
            Self::Nothing => &[],
            Self::Line => &[Question::AsItIs, Question::TakeOut],
            Self::Table => &Question::ALL,
        }
    }
}

/// The last request.
#[derive(Clone, Debug)]
struct Asked {
    watched: Watched,
    at_s: f64,
    frame: u64,
    done: u64,
    shown: Shown,
    is_over: bool,
}

/// The window's side: the helper, its request and its results.
#[derive(Default)]
pub struct Forecasts {
    helper: Option<Box<dyn Helper>>,
    bands: Option<Bands>,
    asked: Option<Asked>,
    number: u64,
    /// The number from which on orders are about what is watched now.
    since: u64,
    rounds: u64,
    /// The request for the end of the tick, and the wall time at which that became due [s].
    due: Option<(Watched, f64, Shown)>,
    answers: Vec<Foreseen>,
    exact: Option<Foreseen>,
}

/// An answer relative to the instant that is shown.
#[derive(Clone, Copy, Debug)]
pub struct AgedForecast<'a> {
    /// What was found.
    pub answer: &'a Foreseen,
    /// How far from a full cook it may be.
    pub band: &'a Band,
    /// Age of the answer [simulated s].
    pub age_s: f64,
    /// True if nothing was done since.
    pub is_current: bool,
}

impl AgedForecast<'_> {
    /// Core temperature at a time from the shown instant on, and half the width of its band [K].
    pub fn core_in(&self, s: f64) -> (f64, f64) {
        let after_s = self.age_s + s;
        (self.answer.outlook.core_at(after_s), self.band.core_at(after_s))
    }

    /// True if its age is worth a word.
    pub fn is_old(&self) -> bool {
        self.age_s > OLD_S
    }
}

impl Forecasts {
    /// Lets a helper make forecasts from now on.
    pub fn employ(&mut self, helper: Box<dyn Helper>) {
        // Without bands the data are broken, which a test of the core reports; then nothing is foreseen.
        *self = Self { helper: Some(helper), bands: Bands::embedded().ok(), ..Self::default() };
    }

    /// Returns true if somebody makes forecasts.
    pub fn are_made(&self) -> bool {
        self.helper.is_some() && self.bands.is_some()
    }

    /// Returns true if frames have to be drawn for the work to go on.
    pub fn need_frames(&self) -> bool {
        self.helper.as_ref().is_some_and(|helper| helper.needs_frames())
    }

    /// How many rounds came to their end [-].
    pub fn rounds(&self) -> u64 {
        self.rounds
    }

    fn take_answers(&mut self) {
        let Some(helper) = &mut self.helper else { return };
        let Some(answers) = helper.answers() else {
            *self = Self::default();
            return;
        };
        for found in answers.iter().filter_map(|bytes| postcard::from_bytes::<FoundForecast>(bytes).ok()) {
            let Some(asked) = self.asked.as_mut().filter(|_| found.number >= self.since) else { continue };
            let is_over = found.number == self.number && found.wants_present;
            self.rounds += u64::from(is_over && !asked.is_over);
            asked.is_over |= is_over;
            (self.answers, self.exact) = (found.answers, found.exact);
        }
    }

    /// What is watched now: what was found of anything else is dropped.
    fn watch(&mut self, watched: &Watched) {
        if self.asked.as_ref().is_some_and(|asked| asked.watched != *watched) {
            self.forget();
        }
    }

    fn forget(&mut self) {
        self.since = self.number + 1;
        (self.due, self.exact) = (None, None);
        self.answers.clear();
    }

    /// Ends the work, if there is any.
    fn rest(&mut self) {
        if let (Some(_), Some(helper)) = (self.asked.take(), &mut self.helper) {
            helper.ask(Vec::new());
            self.forget();
        }
    }

    /// Returns true if the desk needs this present.
    fn want(&self, watched: &Watched, shown: Shown, (frame, done): (u64, u64), now_s: f64) -> bool {
        self.asked.as_ref().is_none_or(|asked| {
            let is_new = asked.watched != *watched || asked.done != done || frame < asked.frame || shown > asked.shown;
            (now_s - asked.at_s).abs() >= APART_S && (is_new || asked.is_over && frame != asked.frame)
        })
    }

    fn ask(&mut self, (watched, now_s, shown): (Watched, f64, Shown), kitchen: &Kitchen, done: u64) {
        let Some(helper) = &mut self.helper else { return };
        self.number += 1;
        let Watched { cook, food, scale } = watched.clone();
        let present = Present { number: self.number, cook, done, food, scale, questions: shown.questions().to_vec() };
        let due_s = self.asked.as_ref().map(|asked| asked.at_s + APART_S);
        let at_s = due_s.filter(|due_s| (0.0..LATE_S).contains(&(now_s - due_s))).unwrap_or(now_s);
        self.asked = Some(Asked { watched, at_s, frame: kitchen.frame(), done, shown, is_over: false });
        helper.ask(present.order(kitchen));
    }
}

/// Returns true if an answer of the helper contains all questions, and the full model's minute.
pub fn is_whole(answer: &[u8]) -> bool {
    let found = postcard::from_bytes::<FoundForecast>(answer);
    found.is_ok_and(|found| found.answers.len() == Question::ALL.len() && found.exact.is_some())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_standing_kitchen_is_asked_again_once_more_is_shown() {
        let watched = Watched { cook: 0, food: "steak".into(), scale: None };
        let asked =
            Asked { watched: watched.clone(), at_s: 0.0, frame: 60, done: 1, shown: Shown::Line, is_over: true };
        let forecasts = Forecasts { asked: Some(asked), ..Forecasts::default() };
        let wanted = |shown| forecasts.want(&watched, shown, (60, 1), 3.0);
        assert_eq!([Shown::Line, Shown::Table].map(wanted), [false, true]);
        assert_eq!([Shown::Line, Shown::Table].map(|shown| shown.questions().len()), [2, 4]);
    }
}
