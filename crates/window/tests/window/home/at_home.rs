//! Promise: a log and values by hand give the kitchen at home with its intervals; it is kept, used and left again, and cooks that were
//! recorded in it stay exact wherever they are opened.

use std::fmt::Write;
use std::path::PathBuf;
use std::sync::Arc;

use egui::vec2;
use egui_kittest::{Harness, kittest::Queryable};
use saute_controls::act::{Act, AppAct, Card, HostAct, LearnAct, Setting, ViewAct};
use saute_controls::at_home::AtHomeAct;
use saute_controls::session::Session;
use saute_kitchen::{Command, Library, celsius};
use saute_plan::fit::parameters::Parameters;
use saute_recipe::{Cook, Recipe, Recording};
use saute_session::FoodChoice;
use saute_session::at_home::entered::{Row, Seen};
use saute_session::at_home::fitting::FitStatus;
use saute_session::at_home::kept::KeptKitchen;
use saute_session::kept::link;
use saute_session::work::executor::Executor;
use saute_session::work::{Agency, Helper, WorkKind};
use saute_window::SauteApp;
use saute_words::language::Language;

use crate::harness::{save, steps, window};

const WIDE: egui::Vec2 = vec2(1280.0, 720.0);
const PHONE: egui::Vec2 = vec2(390.0, 844.0);

/// A small steak that was fried by the clock.
const RECIPE: &str = "[pan]\nkind = \"carbon-steel-26\"\ninitial_c = 20\n[[food]]\nid = \"steak\"\nkind = \"beef-lean\"\n\
size_mm = [40, 30, 14]\ninitial_c = 6\n[[step]]\nat_s = 0\nhob_w = 1500\n[[step]]\nat_s = 60\nput = \"steak\"\n[[step]]\nat_s = 62\n\
hob_w = 700\n[[step]]\nat_s = 110\nflip = \"steak\"\n[[step]]\nat_s = 150\nrest = \"steak\"\n[[step]]\nat_s = 190\nend = true\n";

/// What the hob and the pan at home have.
const TRUTH: Parameters = Parameters { hob_efficiency: 0.78, contact: 1.2, thickness: 0.014 };

/// What a thermometer in that kitchen has written: °F, a clock, the beginning 10 s before the cook.
fn log(library: &Library) -> String {
    let mut there = library.clone();
    TRUTH.set_in(&mut there);
    let recipe = Recipe::parse(RECIPE, "steak.toml", &there).expect("a recipe");
    let mut cook = Cook::new(recipe, &there).expect("a kitchen");
    let mut text = "Time,Probe 1 (°F),Pan (°F)\n0:00,,\n".to_owned();
    let fahrenheit = |kelvin: f64| 1.8 * celsius(kelvin) + 32.0;
    while cook.kitchen.time_s() < 185.0 {
        let now = cook.kitchen.time_s();
        if cook.kitchen.tick().is_multiple_of(50) {
            let [core, pan] = [cook.kitchen.pieces()[0].core(), cook.kitchen.pan_temperature()].map(fahrenheit);
            let at = now.round() as u32 + 10;
            writeln!(text, "{}:{:02},{core:.1},{pan:.1}", at / 60, at % 60).expect("a string");
        }
        cook.advance().expect("a step");
    }
    text
}

/// An agency whose helper works a good while whenever it is polled for answers.
struct Patient;

struct PatientHelper(Executor);

impl Agency for Patient {
    fn hire(&self, kind: WorkKind, library: &Arc<Library>) -> Box<dyn Helper> {
        Box::new(PatientHelper(Executor::new(kind, Arc::clone(library))))
    }
}

impl Helper for PatientHelper {
    fn ask(&mut self, order: Vec<u8>) {
        self.0.take(&order);
    }

    fn answers(&mut self) -> Option<Vec<Vec<u8>>> {
        let answer = if self.0.is_busy() { self.0.go_on(std::time::Duration::from_millis(400)) } else { None };
        Some(answer.into_iter().collect())
    }

    fn needs_frames(&self) -> bool {
        self.0.is_busy()
    }
}

fn act(harness: &mut Harness<'static, SauteApp>, act: Act) {
    let ctx = harness.ctx.clone();
    harness.state_mut().act(act, &ctx);
    steps(harness, 3);
}

fn file(name: &str, text: &str) -> PathBuf {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("at-home");
    std::fs::create_dir_all(&folder).expect("a folder");
    let path = folder.join(name);
    std::fs::write(&path, text).expect("writes");
    path
}

/// The card with log and recipe.
fn entered(size: egui::Vec2, library: &Library) -> Harness<'static, SauteApp> {
    let mut harness = window(size);
    harness.state_mut().employ(Box::new(Patient));
    act(&mut harness, Act::App(AppAct::Host(HostAct::OpenFile(file("log.csv", &log(library))))));
    harness.get_by_label("My kitchen");
    act(&mut harness, Act::App(AppAct::Host(HostAct::OpenFile(file("my-steak.toml", RECIPE)))));
    harness
}

fn kept() -> KeptKitchen {
    let text = "hob_factor = 0.9\ncontact_factor = 1.2\nsource = \"a test\"\nconfidence = \"low\"\n".to_owned();
    KeptKitchen { text, hob_efficiency: [0.78, 0.75, 0.81], contact: [1.2, 1.0, 1.4], is_used: true }
}

#[test]
fn a_log_gives_the_kitchen_which_is_kept_used_and_left_again() {
    let library = Library::embedded().expect("embedded data");
    let mut harness = entered(WIDE, &library);
    harness.get_by_label("Core: 2: Probe 1 (°F)");
    harness.get_by_label("Pan: 3: Pan (°F)");
    // The log began ten seconds before the hob was switched on.
    let log = harness.state().at_home().entered.log.as_ref().expect("a log");
    let columns = saute_session::at_home::open_log::Columns { shift_s: -10.0, ..*log.columns() };
    act(&mut harness, Act::Learn(LearnAct::AtHome(AtHomeAct::Columns(columns))));
    harness.get_by_label_contains("Read as minutes and seconds: ");
    save(&mut harness, "athome-entered");
    harness.get_by_label("Find my kitchen").click();
    steps(&mut harness, 2);
    harness.get_by_label_contains("Fit: ");
    save(&mut harness, "athome-fitting");
    while harness.state().at_home().is_fitting() {
        harness.step();
    }
    steps(&mut harness, 3);
    save(&mut harness, "athome-found");
    let FitStatus::Found(fitted) = harness.state().at_home().standing().clone() else {
        panic!("{:?}", harness.state().at_home().standing())
    };
    let found = fitted.found;
    println!("{found:?}");
    assert!(
        found.describes() && found.hob_efficiency.holds(TRUTH.hob_efficiency) && found.contact.holds(TRUTH.contact)
    );
    assert!((found.hob_efficiency.value - TRUTH.hob_efficiency).abs() < 0.02);
    assert!(fitted.curves.core.len() > 30 && harness.query_by_label_contains("Misfit").is_some());

    harness.get_by_label("Use this kitchen").scroll_to_me();
    steps(&mut harness, 3);
    harness.get_by_label("Use this kitchen").click();
    steps(&mut harness, 3);
    let efficiency = |h: &Harness<'static, SauteApp>| h.state().session().kitchen.hob().efficiency();
    assert!((efficiency(&harness) - found.hob_efficiency.value).abs() < 1e-3, "the untouched cook is in it at once");
    assert!(harness.state().settings().kitchen.as_ref().is_some_and(|kept| kept.is_used));
    act(&mut harness, Act::App(AppAct::Shut(Card::AtHome)));
    act(&mut harness, Act::View(ViewAct::Pantry));
    harness.get_by_label("Typical kitchen").scroll_to_me();
    steps(&mut harness, 3);
    save(&mut harness, "athome-pantry");
    harness.get_by_label("Typical kitchen").click();
    steps(&mut harness, 3);
    assert_eq!(efficiency(&harness), library.hob.efficiency());
    assert!(harness.state().settings().kitchen.as_ref().is_some_and(|kept| !kept.is_used), "it is not forgotten");
}

#[test]
fn values_by_hand_are_entered_row_by_row_and_a_wrong_one_is_named() {
    let mut harness = window(PHONE);
    act(&mut harness, Act::App(AppAct::Open(Card::AtHome)));
    harness.get_by_label("+ Core").scroll_to_me();
    steps(&mut harness, 3);
    harness.get_by_label("+ Core").click();
    steps(&mut harness, 3);
    harness.get_by_label("+ Cut at the end").click();
    steps(&mut harness, 3);
    let rows = harness.state().at_home().entered.rows.clone();
    assert_eq!(rows.iter().map(|row| row.seen).collect::<Vec<_>>(), [Seen::Core, Seen::Class]);
    assert_eq!(rows[1].value, "medium");
    let row = Row { seen: Seen::Core, time: "soon".into(), value: "40".into() };
    act(&mut harness, Act::Learn(LearnAct::AtHome(AtHomeAct::Rows(vec![row]))));
    save(&mut harness, "athome-rows-phone");
    act(&mut harness, Act::Learn(LearnAct::AtHome(AtHomeAct::Fit)));
    harness.get_by_label_contains("row 1 cannot be read");
}

/// In one window: the card in Japanese; then a question has its answers beside it, and what is no log is named as such.
#[test]
fn my_kitchen_reads_in_japanese_and_asks_about_a_log_that_can_be_read_in_two_ways() {
    let library = Library::embedded().expect("embedded data");
    let mut harness = entered(WIDE, &library);
    act(&mut harness, Act::App(AppAct::Set(Setting::Language(crate::harness::japanese()))));
    harness.get_by_label("わたしの台所を求める");
    save(&mut harness, "athome-japanese");
    act(&mut harness, Act::App(AppAct::Set(Setting::Language(Language::ENGLISH))));
    let text = "Time,Core\n1:00,6\n2:30,20\n4:00,40\n";
    act(&mut harness, Act::App(AppAct::Host(HostAct::OpenFile(file("two-ways.csv", text)))));
    harness.get_by_label("The times can be read in two ways: which are they?");
    save(&mut harness, "athome-question");
    harness.get_by_label("hours and minutes").click();
    steps(&mut harness, 3);
    harness.get_by_label_contains("Read as hours and minutes: 180:00 from 1:00.");
    act(
        &mut harness,
        Act::App(AppAct::Host(HostAct::OpenFile(file("unit.csv", "Time,Core\n0:00,43\n5:00,70\n14:00,115\n")))),
    );
    harness.get_by_label_contains("Nothing states the unit");
    harness.get_by_label("°F").click();
    steps(&mut harness, 3);
    harness.get_by_label_contains("3 values in °F");
    act(&mut harness, Act::App(AppAct::Host(HostAct::OpenFile(file("log.xlsx", "PK\u{3}\u{4}")))));
    harness.get_by_label_contains("is a spreadsheet");
}

/// A cook of some seconds by hand.
fn cooked(library: &Arc<Library>) -> Session {
    let mut session = Session::new(Arc::clone(library), &FoodChoice::default()).expect("sets out");
    session.command(&Command::Hob(2000.0)).expect("hob");
    (0..300).for_each(|_| session.tick().expect("ticks"));
    session
}

/// Resumes a recording in a window with a library; returns the state and the efficiency of its hob.
fn resumed(recording: Recording, library: &Arc<Library>) -> (u64, f64, Session) {
    let mut session = Session::new(Arc::clone(library), &FoodChoice::default()).expect("sets out");
    session.resume(recording).expect("opens");
    while session.is_travelling() {
        session.travel_on(std::time::Duration::from_millis(50));
    }
    (session.kitchen.state_hash(), session.kitchen.hob().efficiency(), session)
}

#[test]
fn a_cook_of_one_kitchen_is_played_exactly_in_the_window_of_another() {
    let typical = Arc::new(Library::embedded().expect("embedded data"));
    let fitted = KeptKitchen::library(Some(&kept()), Arc::clone(&typical));
    assert!(fitted.hob.efficiency() < typical.hob.efficiency());
    for (here, there) in [(&fitted, &typical), (&typical, &fitted)] {
        let session = cooked(here);
        let expected = session.kitchen.state_hash();
        let file = session.recording().to_file();
        let from_file = Recording::from_file(&file).expect("a session").recording;
        let from_link = link::read(&link::fragment(session.recording())).expect("a link").expect("a cook");
        for recording in [from_file, from_link] {
            let (state, efficiency, mut session) = resumed(recording, there);
            assert_eq!(state, expected);
            assert_eq!(efficiency, here.hob.efficiency());
            session.set_out(&FoodChoice::default(), 1).expect("sets out");
            assert_eq!(session.kitchen.hob().efficiency(), there.hob.efficiency(), "later cooks are at home");
        }
        // A kitchen as bytes, as it goes to a worker, finds its own kitchen at home too.
        let restored = saute_kitchen::Kitchen::from_bytes(&session.kitchen.to_bytes(), there).expect("restores");
        assert_eq!(restored.state_hash(), expected);
    }
}

#[test]
fn the_kitchen_is_remembered_from_one_start_to_the_next() {
    let settings = saute_controls::settings::Settings { kitchen: Some(kept()), ..Default::default() };
    let text = serde_json::to_string(&settings).expect("JSON");
    let app = SauteApp::start(&egui::Context::default(), None, Some(text), Default::default()).expect("starts");
    let typical = Library::embedded().expect("embedded data");
    let efficiency = app.session().kitchen.hob().efficiency();
    assert!((efficiency - 0.9 * typical.hob.efficiency()).abs() < 1e-9, "{efficiency}");
}
