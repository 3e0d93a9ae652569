//! A lesson in the window.

use std::sync::Arc;

use saute_study::class::rest::{Rest, has_rested};
use saute_study::class::{Lesson, RestKind, ResultRow, Scenario};
use saute_study::protocol_file::Information;
use saute_study::{Measures, Participant, Times};
use web_time::{Duration, Instant};

use crate::Session;
use crate::hands::Hands;

/// A lesson to begin with.
#[derive(Clone, Debug)]
pub struct LessonStart {
    /// The scenario.
    pub scenario: Arc<Scenario>,
    /// Code of the student, if there is one.
    pub student: Option<Participant>,
    /// True if it cannot be left.
    pub is_locked: bool,
}

/// A lesson in the window. What watches the cook is with the session ([`Session::lesson`]).
pub struct LessonDesk {
    start: LessonStart,
    masses: Vec<f64>,
    has_begun: bool,
    /// A question that was answered, whose truth is shown until the student goes on.
    shown: Option<usize>,
    /// Questions whose truth was shown.
    told: Vec<usize>,
    /// The rest that is cooked on in a copy, after the lesson was ended.
    rest: Option<Rest>,
    result: Option<(ResultRow, Measures)>,
}

impl LessonDesk {
    /// Opens a lesson.
    pub fn begin(start: LessonStart) -> Self {
        Self { start, masses: Vec::new(), has_begun: false, shown: None, told: Vec::new(), rest: None, result: None }
    }

    /// The scenario.
    pub fn scenario(&self) -> &Scenario {
        &self.start.scenario
    }

    /// What it began with.
    pub fn start(&self) -> &LessonStart {
        &self.start
    }

    /// True if it cannot be left.
    pub fn is_locked(&self) -> bool {
        self.start.is_locked
    }

    /// True once the student has begun.
    pub fn has_begun(&self) -> bool {
        self.has_begun
    }

    /// The question whose truth is shown.
    pub fn shown(&self) -> Option<usize> {
        self.shown
    }

    /// The rest that is cooked on before there is a result.
    pub fn rest(&self) -> Option<&Rest> {
        self.rest.as_ref()
    }

    /// What came of it, once it is over.
    pub fn result(&self) -> Option<&(ResultRow, Measures)> {
        self.result.as_ref()
    }

    /// True while a card has a question. The session's pause shows that a question waits.
    pub fn asks(&self) -> bool {
        !self.has_begun || self.shown.is_some() || self.rest.is_some() || self.result.is_some()
    }

    /// True while the scenario hides read-outs.
    pub fn hides_read_outs(&self) -> bool {
        self.has_begun && self.result.is_none() && self.start.scenario.overlays == Information::Hidden
    }

    /// The lesson that watches the cook.
    pub fn watch<H: Hands>(&mut self, session: &Session<H>) -> Lesson {
        self.masses = session.kitchen.pieces().iter().map(saute_kitchen::Piece::mass).collect();
        (self.has_begun, self.shown, self.rest, self.result) = (false, None, None, None);
        self.told.clear();
        Lesson::begin(Arc::clone(&self.start.scenario), self.start.student.clone())
    }

    /// The student begins to cook.
    pub fn start_cook(&mut self) {
        self.has_begun = true;
    }

    /// Shows the truth of an answered question if it is known already.
    pub fn show_truth(&mut self, place: usize, is_known: bool) {
        if is_known {
            self.shown = Some(place);
            self.told.push(place);
        }
    }

    /// The student has seen the truth that is shown.
    pub fn go_on(&mut self) {
        self.shown = None;
    }

    /// The first question whose truth has become known since it was answered.
    pub fn newly_known(&mut self, lesson: &Lesson) -> Option<usize> {
        let known = |place: &usize| {
            let asked = lesson.asked()[*place];
            asked.answer.is_some() && asked.truth.is_some() && !self.told.contains(place)
        };
        let place = (0..lesson.asked().len()).find(known)?;
        self.told.push(place);
        Some(place)
    }

    /// True if it has come to its end.
    pub fn is_over<H: Hands>(&self, session: &Session<H>) -> bool {
        let runs = self.has_begun && self.rest.is_none() && self.result.is_none();
        runs && (session.kitchen.time_s() >= self.start.scenario.max_s || has_rested(&session.kitchen))
    }

    /// Ends it. What time has not yet shown is cooked on first, if the food is out of the pan ([`Self::cook_on`]).
    pub fn end<H: Hands>(&mut self, session: &mut Session<H>) {
        self.rest = session.lesson.as_ref().and_then(|lesson| Rest::of(lesson, &session.kitchen));
        if self.rest.is_none() {
            let kitchen = session.kitchen.clone();
            self.finish(session, &kitchen, RestKind::None);
        }
    }

    /// Cooks on what the lesson waits for, for no longer than `budget`; returns true once there is a result.
    pub fn cook_on<H: Hands>(&mut self, session: &mut Session<H>, budget: Duration) -> bool {
        let (Some(rest), Some(lesson)) = (&mut self.rest, &mut session.lesson) else { return false };
        let begun = Instant::now();
        let mut is_over = rest.tick(lesson);
        while !is_over && begun.elapsed() < budget {
            is_over = rest.tick(lesson);
        }
        let Some(rest) = self.rest.take_if(|_| is_over) else { return false };
        self.finish(session, rest.kitchen(), rest.kind());
        true
    }

    fn finish<H: Hands>(&mut self, session: &mut Session<H>, kitchen: &saute_kitchen::Kitchen, rest: RestKind) {
        let times = Times::of(session.recording(), &session.recorder);
        let measures = Measures::read(kitchen, &self.masses, &self.start.scenario.goal, &times);
        if let Some(lesson) = &mut session.lesson {
            self.result = Some((lesson.end(&measures, rest), measures));
        }
    }
}
