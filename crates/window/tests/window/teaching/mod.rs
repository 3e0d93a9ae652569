//! Promise: the window teaches: goals, a result that shows why, a coach, skill mode, and a tutorial under three minutes.

mod coach;
pub mod lesson;
mod result;
mod skill;
pub mod turned;
mod tutorial;

use egui::vec2;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use saute_controls::act::{Act, AppAct, CookAct, Setting};
use saute_kitchen::{Command, RestOn, celsius};
use saute_session::FoodChoice;
use saute_window::SauteApp;

use crate::harness::{steps, window};

/// Power for browning and for frying on [W].
const HEAT_W: f64 = 1100.0;
const FRY_W: f64 = 600.0;

fn says(harness: &Harness<'static, SauteApp>, words: &str) -> bool {
    harness.query_all_by_label_contains(words).next().is_some()
}

/// Carries out an act as a panel would.
fn act(harness: &mut Harness<'static, SauteApp>, act: Act) {
    let context = harness.ctx.clone();
    harness.state_mut().act(act, &context);
    steps(harness, 3);
}

fn set(harness: &mut Harness<'static, SauteApp>, setting: Setting) {
    act(harness, Act::App(AppAct::Set(setting)));
}

/// A window with a small raw steak; time is stopped unless it is let on.
fn small_steak(size: egui::Vec2) -> Harness<'static, SauteApp> {
    let mut harness = window(size);
    let choice = FoodChoice { size_mm: vec![60.0, 50.0, 16.0], ..FoodChoice::default() };
    set(&mut harness, Setting::Choice(choice));
    act(&mut harness, Act::Cook(CookAct::SetOut(1)));
    harness.state_mut().session_mut().set_paused(true);
    harness
}

/// Lets ticks pass until something is true of the kitchen, an hour at most.
fn until(harness: &mut Harness<'static, SauteApp>, is_true: impl Fn(&saute_controls::session::Session) -> bool) {
    let session = harness.state_mut().session_mut();
    let begun = session.kitchen.time_s();
    while !is_true(session) {
        session.tick().expect("ticks");
        assert!(session.kitchen.time_s() < begun + 3600.0, "it never comes");
    }
}

fn command(harness: &mut Harness<'static, SauteApp>, command: &Command) {
    harness.state_mut().session_mut().command(command).expect("is done");
}

fn core_c(session: &saute_controls::session::Session) -> f64 {
    session.shown_piece().map_or(0.0, |steak| celsius(steak.core()))
}

/// Heats the pan and puts the steak in.
fn put_in(harness: &mut Harness<'static, SauteApp>) {
    command(harness, &Command::Hob(HEAT_W));
    until(harness, |session| celsius(session.kitchen.pan_temperature()) > 200.0);
    command(harness, &Command::Put { food: "steak".into(), at: [0.0; 2], heap: false });
    command(harness, &Command::Hob(FRY_W));
}

/// Fries the steak on both sides until its core has a temperature, and rests it until the core cools.
fn fry(harness: &mut Harness<'static, SauteApp>, pull_c: f64) {
    put_in(harness);
    until(harness, |session| core_c(session) > 5.0 + 0.5 * (pull_c - 5.0));
    command(harness, &Command::Flip { food: "steak".into() });
    until(harness, |session| core_c(session) > pull_c);
    command(harness, &Command::Rest { food: "steak".into(), on: RestOn::Board });
    command(harness, &Command::Hob(0.0));
    until(harness, |session| session.shown_piece().is_some_and(|steak| steak.core() < steak.core_peak.0 - 0.5));
}

/// A wide window with a steak that has rested, and time that goes on.
fn rested(
    size: egui::Vec2,
    pull_c: f64,
    prepare: impl Fn(&mut Harness<'static, SauteApp>),
) -> Harness<'static, SauteApp> {
    let mut harness = small_steak(size);
    prepare(&mut harness);
    fry(&mut harness, pull_c);
    harness.state_mut().session_mut().set_paused(false);
    steps(&mut harness, 8);
    harness
}

/// The usual size, and that of a phone.
const WIDE: egui::Vec2 = vec2(1280.0, 720.0);
const PHONE: egui::Vec2 = vec2(390.0, 844.0);
