//! Studies and lessons by acts, and what leads them in each frame.

use crate::app::SauteApp;
use crate::host::Host;
use crate::system::time_of_day;
use saute_controls::act::Act;
use saute_controls::act::GuidedAct;
use saute_picture::View;
use saute_session::guided::{Guided, LessonDesk, LessonStart, StudyDesk, StudyStart};
use saute_session::permits::{Permit, Permits};
use saute_study::class::{Scenario, shipped, to_csv};
use saute_study::{Event, Stage};
use saute_words::guided_words;
use std::sync::Arc;
use web_time::Duration;

/// How long a frame cooks on behind a card (chosen: the card's time runs smoothly, and little is lost to drawing).
const COOKING_ON: Duration = Duration::from_millis(80);

impl SauteApp {
    /// The study or the lesson that leads the cook.
    pub fn guided(&self) -> Option<&Guided> {
        self.leads.guided.as_ref()
    }

    /// Begins a study.
    pub(crate) fn begin_study(&mut self, start: StudyStart) {
        self.desk.card = None;
        self.leads.guided = Some(Guided::Study(Box::new(StudyDesk::begin(start, time_of_day()))));
    }

    /// Opens a lesson: its food is set out, and its card states what it is about.
    pub(crate) fn open_lesson(&mut self, start: LessonStart) {
        let (recipe, speed) = (Arc::clone(&start.scenario.recipe), start.scenario.speed);
        if let Err(error) = self.session.set_out_led(recipe) {
            return self.say_trouble(&error);
        }
        self.set_tutorial(false);
        let mut desk = LessonDesk::begin(start);
        self.session.lesson = Some(desk.watch(&self.session));
        self.session.set_speed(speed);
        self.sights.motions.clear();
        self.desk.card = None;
        self.leads.guided = Some(Guided::Lesson(Box::new(desk)));
    }

    /// What a person may do now.
    pub(crate) fn permits(&self) -> Permits {
        self.leads.guided.as_ref().map(Guided::permits).unwrap_or_default()
    }

    /// Returns true if read-outs are allowed: what is measured, foreseen or advised.
    pub(crate) fn reads_out(&self) -> bool {
        self.permits().allow(&[Permit::ReadOuts])
    }

    /// Returns true if an act is locked, and then shows a notice.
    pub(crate) fn refuses(&self, act: &Act) -> bool {
        let refused = !self.permits().allow(act.traits().needs);
        if refused {
            self.say("guided.locked");
        }
        refused
    }

    /// Leads the study or the lesson: ends what is over, and reports what has become known.
    pub(crate) fn guide(&mut self, ctx: &egui::Context) {
        self.try_machine();
        match &mut self.leads.guided {
            Some(Guided::Study(desk)) if desk.is_over(&self.session) => self.end_trial(),
            Some(Guided::Lesson(desk)) => {
                let known = self.session.lesson.as_ref().and_then(|lesson| desk.newly_known(lesson));
                let is_over = desk.is_over(&self.session);
                if let (Some(place), Some(lesson)) = (known, &self.session.lesson) {
                    let words = guided_words::truth(lesson, place, self.settings.speech());
                    self.desk.notice.say(words);
                }
                if is_over {
                    self.end_lesson();
                }
                self.cook_on(ctx);
            }
            _ => {}
        }
    }

    /// Carries out what a participant or a student does.
    pub(crate) fn guided_act(&mut self, act: GuidedAct, ctx: &egui::Context) {
        match act {
            GuidedAct::Agree => self.study_event(Event::Agreed),
            GuidedAct::TryMachine => self.with_study(StudyDesk::try_again),
            GuidedAct::Decline => self.with_study(|desk| desk.decline()),
            GuidedAct::BeginTrial => self.begin_trial(),
            GuidedAct::EndTrial => self.end_trial(),
            GuidedAct::Answer(answers) => self.study_event(Event::Answered(answers)),
            GuidedAct::KeepRows => self.with_study(StudyDesk::keep_rows),
            GuidedAct::SaveLog => self.save_log(),
            GuidedAct::Lesson(id) => self.open_shipped_lesson(&id),
            GuidedAct::BeginLesson => self.begin_lesson(),
            GuidedAct::Predict(answer) => self.predict(answer),
            GuidedAct::GoOn => self.with_lesson(LessonDesk::go_on),
            GuidedAct::EndLesson => self.end_lesson(),
            GuidedAct::SaveResult => self.save_result(),
            GuidedAct::CopyResult => self.copy_result(ctx),
            GuidedAct::AgainLesson => self.lesson_again(),
            GuidedAct::Leave => self.leave_lesson(),
            GuidedAct::CloseWindow => ctx.send_viewport_cmd(egui::ViewportCommand::Close),
        }
    }

    fn with_study(&mut self, change: impl FnOnce(&mut StudyDesk)) {
        if let Some(Guided::Study(desk)) = &mut self.leads.guided {
            change(desk);
        }
    }

    fn with_lesson(&mut self, change: impl FnOnce(&mut LessonDesk)) {
        if let Some(Guided::Lesson(desk)) = &mut self.leads.guided {
            change(desk);
        }
    }

    fn study_event(&mut self, event: Event) {
        let mut refused = None;
        self.with_study(|desk| refused = desk.take(event).err());
        self.desk.memory.answers = Default::default();
        if let Some(error) = refused {
            self.say_trouble(&error);
        }
    }

    fn begin_trial(&mut self) {
        let Some(Guided::Study(desk)) = &self.leads.guided else { return };
        let (Stage::Trial { .. }, Some(simulate)) = (desk.study().stage(), desk.study().simulate()) else { return };
        let (recipe, speed) = (Arc::clone(&simulate.recipe), simulate.speed);
        if let Err(error) = self.session.set_out_led(recipe) {
            return self.say_trouble(&error);
        }
        self.set_tutorial(false);
        self.session.set_speed(speed);
        self.sights.motions.clear();
        let session = &self.session;
        if let Some(Guided::Study(desk)) = &mut self.leads.guided {
            desk.begin_trial(session);
        }
        self.show_only_what_is_allowed();
    }

    fn end_trial(&mut self) {
        let session = &self.session;
        if let Some(Guided::Study(desk)) = &mut self.leads.guided {
            desk.end_trial(session);
        }
    }

    /// Closes what the list of what is allowed does not contain: other views, the cut, curves, the list of the pieces, the food.
    fn show_only_what_is_allowed(&mut self) {
        (self.sights.glance, self.desk.card) = (None, None);
        let permits = self.permits();
        if !permits.allow(&[Permit::Foods]) {
            self.settings.pantry_open = false;
        }
        if !permits.allow(&[Permit::Views]) {
            (self.settings.view, self.settings.split, self.sights.slice) = (View::Look, false, None);
        }
        if !permits.allow(&[Permit::ReadOuts]) {
            (self.settings.curves_open, self.settings.pieces_open) = (false, false);
        }
    }

    fn open_shipped_lesson(&mut self, id: &str) {
        let parsed = shipped::text(id).map(|text| Scenario::parse(text, id, &self.session.library));
        match parsed {
            Some(Ok(scenario)) => {
                self.open_lesson(LessonStart { scenario: Arc::new(scenario), student: None, is_locked: false });
            }
            Some(Err(error)) => self.say_trouble(&error),
            None => {}
        }
    }

    fn begin_lesson(&mut self) {
        self.with_lesson(LessonDesk::start_cook);
        self.session.set_paused(false);
        self.show_only_what_is_allowed();
    }

    fn predict(&mut self, answer: f64) {
        let Some(lesson) = &mut self.session.lesson else { return };
        let Some(place) = lesson.answer(answer) else { return };
        let is_known = lesson.asked()[place].truth.is_some();
        self.desk.memory.answers = Default::default();
        self.with_lesson(|desk| desk.show_truth(place, is_known));
        self.session.set_paused(false);
    }

    fn end_lesson(&mut self) {
        if let Some(Guided::Lesson(desk)) = &mut self.leads.guided {
            desk.end(&mut self.session);
        }
    }

    /// Cooks on what the lesson waits for, behind its card.
    fn cook_on(&mut self, ctx: &egui::Context) {
        if matches!(&self.leads.guided, Some(Guided::Lesson(desk)) if desk.rest().is_some()) {
            ctx.request_repaint();
        }
        if let Some(Guided::Lesson(desk)) = &mut self.leads.guided
            && desk.cook_on(&mut self.session, COOKING_ON)
            && let Some((row, _)) = desk.result()
        {
            self.host.report(row);
        }
    }

    pub(crate) fn lesson_again(&mut self) {
        let Some(Guided::Lesson(desk)) = &self.leads.guided else { return };
        let start = desk.start().clone();
        self.open_lesson(start);
    }

    fn leave_lesson(&mut self) {
        let may = matches!(&self.leads.guided, Some(Guided::Lesson(desk)) if !desk.is_locked());
        if may {
            (self.leads.guided, self.session.lesson) = (None, None);
            self.session.set_paused(false);
        }
    }

    fn save_log(&mut self) {
        let Some(Guided::Study(desk)) = &self.leads.guided else { return };
        let (name, csv) = (format!("study-{}.csv", desk.study().participant()), desk.csv());
        self.save_table(&name, &csv);
    }

    fn save_result(&mut self) {
        let Some((row, _)) = self.lesson_result() else { return };
        let student = row.student.clone().unwrap_or_else(|| "result".to_owned());
        let (name, csv) = (format!("{}-{student}.csv", row.scenario), to_csv(std::slice::from_ref(row)));
        self.save_table(&name, &csv);
    }

    fn copy_result(&mut self, ctx: &egui::Context) {
        let Some((row, _)) = self.lesson_result() else { return };
        self.host.copy_text(&row.line(), ctx);
        self.say("guided.copied");
    }

    fn lesson_result(&self) -> Option<&(saute_study::class::ResultRow, saute_study::Measures)> {
        match &self.leads.guided {
            Some(Guided::Lesson(desk)) => desk.result(),
            _ => None,
        }
    }

    /// Saves a table, and shows where it is if it has a path.
    fn save_table(&self, name: &str, csv: &str) {
        match self.host.save_table(name, csv) {
            Ok(None) => self.desk.notice.say(self.settings.language.fill("notice.downloaded", &[("file", &name)])),
            Ok(Some(path)) => {
                let said = self.settings.language.fill("notice.table_saved", &[("path", &path.display())]);
                self.desk.notice.say_of(said, path);
            }
            Err(error) => self.say_trouble(&error),
        }
    }
}
