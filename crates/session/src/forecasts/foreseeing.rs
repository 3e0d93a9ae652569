//! How forecasts are made off the frame: a [`Desk`] with the present kitchen, which came as bytes.

use std::sync::Arc;

use saute_kitchen::bytes::Models;
use saute_kitchen::{Kitchen, Library};
use saute_plan::forecast::{Desk, Question, Wanted};
use web_time::{Duration, Instant};

use super::{FoundForecast, Present};
use crate::work::worker::Worker;

/// Forecasts of one piece, with its own foods and pans.
pub struct Foreseeing {
    library: Arc<Library>,
    models: Models,
    desk: Desk,
    /// The present that was taken last.
    present: Option<Taken>,
    /// What was reported of it; none until something was.
    told: Option<Told>,
}

/// A present without its kitchen.
#[derive(Clone, Copy, Debug)]
struct Taken {
    number: u64,
    cook: u64,
    frame: u64,
    done: u64,
}

/// Frames of the answers that were reported, and whether the next present was requested.
type Told = ([Option<u64>; 5], bool);

impl Foreseeing {
    /// Without a present.
    pub fn new(library: Arc<Library>) -> Self {
        Self { library, models: Models::default(), desk: Desk::default(), present: None, told: None }
    }

    fn begin(&mut self, order: &[u8]) -> Option<Taken> {
        let (Present { number, cook, done, food, scale, questions }, kitchen) =
            postcard::take_from_bytes(order).ok()?;
        let kitchen = Kitchen::from_bytes_with(kitchen, &self.library, &mut self.models).ok()?;
        if self.present.is_none_or(|before| before.cook != cook) {
            self.desk.watch(None, None);
        }
        self.desk.watch(Some(&food), scale.and_then(|id| self.library.scale(&id).cloned()));
        // Without coarse meshes nothing is foreseen of this present.
        self.desk.begin_with(&kitchen, done, &questions).ok()?;
        Some(Taken { number, cook, frame: kitchen.frame(), done })
    }

    fn wants(&self, later: u64) -> Wanted {
        self.present.map_or(Wanted::Nothing, |taken| self.desk.wants(taken.frame + later, taken.done))
    }

    /// What can be reported now.
    fn news(&self) -> Told {
        let frame = |question| self.desk.answer(question).map(|answer| answer.outlook.frame);
        let [a, b, c, d] = Question::ALL.map(frame);
        let exact = self.desk.exact_answer().map(|answer| answer.outlook.frame);
        ([a, b, c, d, exact], self.wants(1) == Wanted::Present)
    }

    fn tell(&mut self, taken: Taken) -> Option<Vec<u8>> {
        let news = self.news();
        if self.told == Some(news) {
            return None;
        }
        self.told = Some(news);
        let found = FoundForecast {
            number: taken.number,
            answers: Question::ALL.into_iter().filter_map(|question| self.desk.answer(question)).cloned().collect(),
            exact: self.desk.exact_answer().cloned(),
            wants_present: news.1,
        };
        postcard::to_allocvec(&found).ok()
    }
}

impl Worker for Foreseeing {
    fn take(&mut self, order: &[u8]) {
        let present = self.begin(order);
        if present.is_none() {
            self.desk.watch(None, None);
        }
        (self.present, self.told) = (present, None);
    }

    fn is_busy(&self) -> bool {
        self.present.is_some() && (self.told.is_none() || self.wants(0) == Wanted::Time)
    }

    fn go_on(&mut self, budget: Duration) -> Option<Vec<u8>> {
        let taken = self.present?;
        let begun = Instant::now();
        while self.desk.advance(1) > 0 && begun.elapsed() < budget {}
        self.tell(taken)
    }
}
