//! Promise: forecasts of the piece are shown in the panel "Inside" as a line, as a table and as curves; they state how old they are and
//! whether they still apply; what a question is about can be done by a click. "As it is" is what comes, bit for bit.

use std::cell::RefCell;
use std::rc::Rc;
use std::sync::Arc;

use egui::{Rect, vec2};
use egui_kittest::{Harness, kittest::NodeT, kittest::Queryable};
use saute_controls::act::{Act, AppAct, Card, Setting};
use saute_controls::session::Session;
use saute_kitchen::advice::FORECAST_HIGH_K;
use saute_kitchen::{Command, Library, celsius};
use saute_plan::forecast::{EXACT_S, Question, SPANS_S};
use saute_session::work::executor::Executor;
use saute_session::work::thread::Threads;
use saute_session::work::{Agency, Helper, WorkKind};
use saute_window::ui::layout::Layout;
use saute_window::{SauteApp, Start};
use saute_words::language::Language;
use web_time::Duration;

use crate::harness::{WINDOW, cook, save, steps, window_with};

/// Works whole orders in the same thread, unless it is on holiday: no answer depends on the machine's speed.
#[derive(Clone, Default)]
struct AtOnce {
    orders: Rc<RefCell<Vec<Vec<u8>>>>,
    is_away: Rc<RefCell<bool>>,
}

struct Worker {
    executor: Executor,
    agency: AtOnce,
    is_kept: bool,
}

impl Agency for AtOnce {
    fn hire(&self, kind: WorkKind, library: &Arc<Library>) -> Box<dyn Helper> {
        let is_kept = kind == WorkKind::Forecast;
        Box::new(Worker { executor: Executor::new(kind, Arc::clone(library)), agency: self.clone(), is_kept })
    }
}

impl Helper for Worker {
    fn ask(&mut self, order: Vec<u8>) {
        if self.is_kept {
            self.agency.orders.borrow_mut().push(order.clone());
        }
        self.executor.take(&order);
    }

    fn answers(&mut self) -> Option<Vec<Vec<u8>>> {
        let mut answers = Vec::new();
        while self.executor.is_busy() && !*self.agency.is_away.borrow() {
            answers.extend(self.executor.go_on(Duration::from_secs(600)));
        }
        Some(answers)
    }
}

/// A steak that fries in a window with forecasts.
fn frying(size: egui::Vec2, language: Language) -> (Harness<'static, SauteApp>, AtOnce) {
    let mut harness = window_with(size, Start { language: Some(language), ..Start::default() });
    let agency = AtOnce::default();
    harness.state_mut().employ(Box::new(agency.clone()));
    let session = harness.state_mut().session_mut();
    session.command(&Command::Hob(1100.0)).expect("hob");
    (0..600).for_each(|_| session.tick().expect("ticks"));
    let steak = session.shown_id();
    session.command(&Command::Put { food: steak, at: [0.0; 2], heap: false }).expect("puts");
    let cook = |harness: &mut Harness<'static, SauteApp>, s: u32| {
        (0..10 * s).for_each(|_| harness.state_mut().session_mut().tick().expect("ticks"));
    };
    cook(&mut harness, 60);
    harness.state_mut().session_mut().command(&flip()).expect("flips");
    cook(&mut harness, 30);
    // A round is requested, and its answers are shown.
    steps(&mut harness, 3);
    (harness, agency)
}

fn flip() -> Command {
    Command::Flip { food: "steak".into() }
}

fn usual() -> (Harness<'static, SauteApp>, AtOnce) {
    frying(vec2(1280.0, 720.0), Language::ENGLISH)
}

/// Whole degrees of a core at a time ahead, as they are written.
fn degrees(session: &Session, question: Question, ahead_s: f64) -> String {
    format!("{:.0}", celsius(session.foreseen(question).expect("is foreseen").core_in(ahead_s).0))
}

/// The highest core with its band; of raw food that the board still warms a bound.
fn highest(session: &Session, question: Question) -> String {
    let standing = session.foreseen(question).expect("is foreseen");
    let outlook = &standing.answer.outlook;
    let core = celsius(outlook.peak.core);
    if outlook.still_warms() { format!("> {core:.0}") } else { format!("{core:.0} ± {:.1}", standing.band.peak_k) }
}

#[test]
fn a_line_says_what_comes_and_what_if_it_is_taken_out() {
    let (mut harness, agency) = usual();
    save(&mut harness, "forecast-line");
    let core = degrees(harness.state().session(), Question::AsItIs, 120.0);
    // The line and the advice answer one question with one number.
    let advised = harness.state_mut().session_mut().forecast().expect("steak is in the pan").peak_c - FORECAST_HIGH_K;
    harness.get_by_label_contains(&format!("In 2 min {core}\u{a0}°C · out now: {advised:.0}\u{a0}°C ("));
    // What was foreseen in the pan is not shown for a steak that is out of it.
    *agency.is_away.borrow_mut() = true;
    harness.get_by_label("Take out").click();
    cook(&mut harness, 3.0);
    harness.get_by_label_contains("A new forecast is coming.");
    assert!(
        harness.query_by_label_contains("In 2 min").is_none() && harness.query_by_label_contains("highest:").is_none()
    );
}

#[test]
fn a_table_shows_what_the_desk_answered_with_its_band() {
    let (mut harness, _) = usual();
    harness.get_by_label("More: curves and all readings").click();
    steps(&mut harness, 12);
    save(&mut harness, "forecast-table");
    let session = harness.state().session();
    let names = ["As it is", "Flip now", "Take out now", "Lower the heat"];
    for (question, name) in Question::ALL.into_iter().zip(names) {
        let [one, two, five] = SPANS_S.map(|span| degrees(session, question, span));
        let (highest, standing) = (highest(session, question), session.foreseen(question).expect("is foreseen"));
        let last = standing.answer.outlook.samples.last().expect("samples");
        let browned = last.faces[0].browned_pct;
        let row = format!("{name}: core after 1, 2 and 5 minutes {one}, {two}, {five} °C, highest {highest} °C");
        let row = harness.get_by_label_contains(&row);
        let said = row.accesskit_node().value().expect("is read out");
        assert!(said.ends_with(&format!("underside {browned:.0} % brown")), "{said}");
    }
    harness.key_press(egui::Key::C);
    steps(&mut harness, 2);
    assert!(harness.query_all_by_label_contains("°F, highest").next().is_some());
}

#[test]
fn answers_say_that_they_are_old_and_that_something_was_done() {
    let (mut harness, agency) = usual();
    harness.get_by_label("More: curves and all readings").click();
    steps(&mut harness, 12);
    assert!(harness.query_by_label_contains(" s old").is_none());
    *agency.is_away.borrow_mut() = true;
    cook(&mut harness, 7.0);
    save(&mut harness, "forecast-old");
    let age = harness.state().session().foreseen(Question::Flip).expect("is foreseen").age_s;
    assert!(age > 7.0);
    harness.get_by_label(&format!("forecast {age:.0} s old"));
    harness.get_by_label("Lower the heat").click();
    steps(&mut harness, 3);
    assert_eq!(harness.state().session().kitchen.hob_w(), 550.0);
    harness.get_by_label("outdated");
    save(&mut harness, "forecast-stale");
    *agency.is_away.borrow_mut() = false;
    steps(&mut harness, 24);
    let session = harness.state().session();
    assert!(Question::ALL.into_iter().all(|q| session.foreseen(q).expect("is foreseen").is_current));
    assert!(harness.query_by_label("outdated").is_none());
}

#[test]
fn what_is_asked_is_done_by_a_click() {
    let (mut harness, _) = usual();
    harness.get_by_label("More: curves and all readings").click();
    steps(&mut harness, 12);
    let up = harness.state().session().shown_piece().expect("steak").upside_down();
    harness.get_by_label("Flip now").click();
    cook(&mut harness, 3.0);
    assert_ne!(harness.state().session().shown_piece().expect("steak").upside_down(), up);
    steps(&mut harness, 12);
    harness.get_by_label("Take out now").click();
    cook(&mut harness, 3.0);
    steps(&mut harness, 24);
    let session = harness.state().session();
    assert!(!session.shown_piece().expect("steak").in_pan());
    let foreseen = |question| session.foreseen(question).is_some();
    assert_eq!(Question::ALL.map(foreseen), [true, false, false, false], "only resting is left");
    save(&mut harness, "forecast-resting");
}

#[test]
fn rounds_are_half_a_second_apart_and_there_is_none_where_nothing_is_ahead() {
    let (mut harness, agency) = usual();
    let asked = |agency: &AtOnce| agency.orders.borrow().len();
    let before = asked(&agency);
    // Frames are a twentieth of a second apart.
    steps(&mut harness, 100);
    let rounds = asked(&agency) - before;
    assert!((8..=10).contains(&rounds), "{rounds} in 5 s");
    harness.state_mut().act(Act::App(AppAct::Open(Card::Goals)), &egui::Context::default());
    steps(&mut harness, 12);
    save(&mut harness, "forecast-switch");
    harness.get_by_label("Forecasts: off").click();
    steps(&mut harness, 2);
    assert!(agency.orders.borrow().last().expect("an order").is_empty(), "the work is ended");
    let before = asked(&agency);
    harness.key_press(egui::Key::Escape);
    steps(&mut harness, 40);
    assert_eq!(asked(&agency), before);
    assert!(harness.query_by_label_contains("In 2 min").is_none());
    // Food in its packet has nothing ahead.
    let mut harness = window_with(vec2(1280.0, 720.0), Start::default());
    let agency = AtOnce::default();
    harness.state_mut().employ(Box::new(agency.clone()));
    steps(&mut harness, 20);
    assert_eq!(asked(&agency), 0);
}

#[test]
fn while_time_is_turned_nothing_is_foreseen() {
    let (mut harness, _) = usual();
    harness.state_mut().session_mut().hold_time(true);
    steps(&mut harness, 2);
    assert!(harness.state().session().foreseen(Question::AsItIs).is_none());
    harness.state_mut().session_mut().hold_time(false);
    steps(&mut harness, 24);
    assert!(harness.state().session().foreseen(Question::AsItIs).is_some());
}

#[test]
fn nothing_jumps_when_answers_come_and_the_scene_keeps_its_room() {
    let mut harness = window_with(vec2(1280.0, 720.0), Start::default());
    harness.state_mut().employ(Box::new(AtOnce::default()));
    steps(&mut harness, 2);
    let place = |harness: &Harness<'static, SauteApp>| harness.get_by_label_contains("More: curves").rect();
    let before = place(&harness);
    let (harness, _) = usual();
    assert_eq!(place(&harness), before);
    let layout = Layout::new(WINDOW, harness.state().settings());
    assert!(layout.right.contains_rect(before), "{before} in {}", layout.right);
}

#[test]
fn as_it_is_is_the_later_state_bit_for_bit() {
    let (mut harness, _) = usual();
    let session = harness.state_mut().session_mut();
    let exact = session.foreseen_exactly().expect("is foreseen").outlook.clone();
    let first = exact.frame;
    assert!((exact.samples.last().expect("samples").after_s - EXACT_S).abs() < 1e-9);
    let mut compared = 0;
    for sample in &exact.samples {
        let frame = first + (sample.after_s * 60.0).round() as u64;
        if frame <= session.kitchen.frame() {
            continue;
        }
        while session.kitchen.frame() < frame {
            session.tick().expect("ticks");
        }
        let steak = session.shown_piece().expect("steak");
        let faces = [steak.up(), steak.up().map(|v| -v)].map(|up| steak.model.face_reading(&steak.state, up));
        assert_eq!(
            (sample.core.to_bits(), sample.faces),
            (steak.core().to_bits(), faces),
            "after {} s",
            sample.after_s
        );
        compared += 1;
    }
    assert!(compared >= 8, "{compared}");
}

/// The answers to the last present, once the work is done.
fn answers_of(mut helper: Box<dyn Helper>, order: &[u8]) -> Vec<u8> {
    helper.ask(order.to_vec());
    let mut last = Vec::new();
    for _ in 0..120_000 {
        let answers = helper.answers().expect("somebody works");
        last = answers.into_iter().last().unwrap_or(last);
        // Four questions and "as it is" with the full model: all answers are there.
        if saute_session::forecasts::is_whole(&last) {
            return last;
        }
        std::thread::sleep(Duration::from_millis(1));
    }
    panic!("no answer");
}

#[test]
fn a_thread_answers_what_the_same_thread_answers() {
    let (mut harness, agency) = usual();
    // The table has all questions.
    harness.key_press(egui::Key::G);
    steps(&mut harness, 12);
    let library = Arc::clone(&harness.state().session().library);
    let order = agency.orders.borrow().last().expect("an order").clone();
    let here = answers_of(AtOnce::default().hire(WorkKind::Forecast, &library), &order);
    let threads = Threads::new(Arc::new(|| {}), || {});
    assert_eq!(answers_of(threads.hire(WorkKind::Forecast, &library), &order), here);
    let frames = saute_session::work::in_frames::Frames;
    assert_eq!(answers_of(frames.hire(WorkKind::Forecast, &library), &order), here);
}

#[test]
fn a_phone_shows_forecasts_in_its_drawer_and_japanese_has_room() {
    let (mut harness, _) = frying(vec2(390.0, 844.0), Language::ENGLISH);
    harness.get_by_label("Inside").click();
    steps(&mut harness, 12);
    save(&mut harness, "forecast-phone");
    let line: Rect = harness.get_by_label_contains("In 2 min").rect();
    assert!(line.right() <= 390.0);
    harness.key_press(egui::Key::G);
    steps(&mut harness, 12);
    save(&mut harness, "forecast-phone-more");
    let (mut harness, _) = frying(vec2(1280.0, 720.0), crate::harness::japanese());
    save(&mut harness, "forecast-line-ja");
    harness.key_press(egui::Key::G);
    steps(&mut harness, 12);
    save(&mut harness, "forecast-table-ja");
}

#[test]
fn in_skill_mode_nothing_is_foreseen() {
    let (mut harness, agency) = usual();
    harness.state_mut().act(Act::App(AppAct::Set(Setting::SkillMode(true))), &egui::Context::default());
    steps(&mut harness, 12);
    assert!(harness.state().session().foreseen(Question::AsItIs).is_none());
    assert!(agency.orders.borrow().last().expect("an order").is_empty(), "the work is ended");
    assert!(harness.query_by_label_contains("In 2 min").is_none());
}
