//! Promise: "what if I had done it otherwise?" All ways are seen side by side at the same time of the cook.

use egui::Key;
use egui::accesskit::Role;
use egui_kittest::{Harness, kittest::Queryable};
use saute_controls::act::{Act, AppAct, CookAct, Setting, TimeAct, ViewAct};
use saute_controls::settings::theme::Theme;
use saute_kitchen::Command;
use saute_session::timeline::Stand;
use saute_window::SauteApp;
use saute_window::ui::theme::TOUCH;
use saute_words::language::Language;

use crate::harness::{cook, press, save, steps, window};

const WIDE: egui::Vec2 = egui::vec2(1280.0, 720.0);
const PHONE: egui::Vec2 = egui::vec2(390.0, 844.0);

fn act(harness: &mut Harness<'static, SauteApp>, act: Act) {
    let ctx = harness.ctx.clone();
    harness.state_mut().act(act, &ctx);
    steps(harness, 3);
}

/// Draws frames until every way is where it should be.
fn settle(harness: &mut Harness<'static, SauteApp>) {
    for _ in 0..2000 {
        harness.step();
        let session = harness.state().session();
        let waits = session.ways().iter().any(|way| matches!(way.stand, Stand::CatchingUp(_)));
        if !waits && !session.is_travelling() {
            return steps(harness, 10);
        }
    }
    panic!("no end");
}

fn turn_to(harness: &mut Harness<'static, SauteApp>, time_s: f64) {
    act(harness, Act::Time(TimeAct::Scrub(time_s)));
    harness.state_mut().session_mut().finish_travel();
}

/// Three ways from 1:00 on: turned over at 1:00 and cooked until 2:30; hob off at 1:00, until 1:50; and turned over at 2:00, until 3:00.
fn three_ways(size: egui::Vec2) -> Harness<'static, SauteApp> {
    let mut harness = window(size);
    let session = harness.state_mut().session_mut();
    session.set_paused(true);
    session.command(&Command::Hob(1400.0)).expect("hob");
    cook(&mut harness, 30.0);
    press(&mut harness, Key::A);
    cook(&mut harness, 30.0);
    press(&mut harness, Key::F);
    cook(&mut harness, 90.0);
    turn_to(&mut harness, 60.0);
    act(&mut harness, Act::Cook(CookAct::HobSet(0.0)));
    cook(&mut harness, 50.0);
    turn_to(&mut harness, 60.0);
    act(&mut harness, Act::Cook(CookAct::HobSet(1000.0)));
    cook(&mut harness, 60.0);
    press(&mut harness, Key::F);
    cook(&mut harness, 60.0);
    harness
}

fn stands(harness: &Harness<'static, SauteApp>) -> Vec<Stand> {
    harness.state().session().ways().iter().map(|way| way.stand).collect()
}

#[test]
fn ways_are_seen_side_by_side_and_turned_together() {
    let mut harness = three_ways(WIDE);
    press(&mut harness, Key::F4);
    save(&mut harness, "ways-catching-up");
    settle(&mut harness);
    save(&mut harness, "ways");
    let [first, second, third] = stands(&harness)[..] else { panic!("three ways") };
    assert!(matches!(first, Stand::Ended(t) if (t - 150.0).abs() < 1.0), "{first:?}");
    assert!(matches!(second, Stand::Ended(t) if (t - 110.0).abs() < 1.0), "{second:?}");
    assert_eq!(third, Stand::Live);
    for said in ["ended at 2:30, shown as it was then", "ended at 1:50, shown as it was then", "you cook here"] {
        assert!(harness.query_by_label(said).is_some(), "{said}");
    }
    for name in ["flip at 1:00", "0 W at 1:00", "1000 W at 1:00"] {
        assert!(harness.query_all_by_label(name).count() >= 1, "{name}");
    }
    // The strip turns all of them.
    act(&mut harness, Act::Time(TimeAct::Scrub(100.0)));
    settle(&mut harness);
    assert_eq!(stands(&harness), [Stand::Here, Stand::Here, Stand::Live]);
    let session = harness.state().session();
    let ways = session.ways();
    assert!(ways.iter().all(|way| (way.kitchen.time_s() - 100.0).abs() < 0.06));
    assert!(ways[0].kitchen.pieces()[0].flipped_at().is_some() && ways[2].kitchen.pieces()[0].flipped_at().is_none());
    save(&mut harness, "ways-turned");
    act(&mut harness, Act::Time(TimeAct::Scrub(45.0)));
    settle(&mut harness);
    assert!(harness.query_all_by_label("the same until 1:00").count() == 2);
    // A way whose kitchen is not computed yet states that, and no frame waits for it.
    turn_to(&mut harness, 97.3);
    let session = harness.state_mut().session_mut();
    session.forget_beside();
    assert!(session.keep_beside(std::time::Duration::ZERO));
    let stands = stands(&harness);
    assert!(matches!(stands[..], [Stand::CatchingUp(_), Stand::CatchingUp(_), Stand::Live]), "{stands:?}");
    settle(&mut harness);
    turn_to(&mut harness, 45.0);
    settle(&mut harness);
    let hashes: Vec<u64> = harness.state().session().ways().iter().map(|way| way.kitchen.state_hash()).collect();
    assert!(hashes.iter().all(|hash| *hash == hashes[0]));
    act(&mut harness, Act::App(AppAct::Set(Setting::Theme(Theme::Light))));
    act(&mut harness, Act::View(ViewAct::View(saute_picture::view::View::Temperature)));
    act(&mut harness, Act::Time(TimeAct::Scrub(130.0)));
    settle(&mut harness);
    save(&mut harness, "ways-light-temperature");
}

#[test]
fn another_way_is_cooked_on_at_the_same_time_and_keeps_its_column() {
    let mut harness = three_ways(WIDE);
    press(&mut harness, Key::F4);
    act(&mut harness, Act::Time(TimeAct::Scrub(100.0)));
    settle(&mut harness);
    let slots = |harness: &Harness<'static, SauteApp>| -> Vec<u64> {
        harness.state().session().ways().iter().map(|way| way.kitchen.state_hash()).collect()
    };
    let before = slots(&harness);
    let first = harness.query_all_by_label("Cook on here").next().expect("a button");
    first.click();
    settle(&mut harness);
    assert_eq!(slots(&harness), before);
    assert_eq!(stands(&harness), [Stand::Live, Stand::Here, Stand::Here]);
    // They go on together.
    harness.state_mut().session_mut().set_paused(false);
    steps(&mut harness, 60);
    let ways = harness.state().session().ways();
    assert!(ways.iter().all(|way| (way.kitchen.time_s() - ways[0].kitchen.time_s()).abs() < 0.2));
    assert!(ways[0].kitchen.time_s() > 101.0);
    drop(ways);
    // A fourth way; then the oldest makes room.
    harness.state_mut().session_mut().set_paused(true);
    act(&mut harness, Act::Time(TimeAct::Scrub(50.0)));
    harness.state_mut().session_mut().finish_travel();
    act(&mut harness, Act::Cook(CookAct::HobSet(600.0)));
    cook(&mut harness, 10.0);
    settle(&mut harness);
    assert_eq!(stands(&harness).len(), 4);
    save(&mut harness, "ways-four");
    press(&mut harness, Key::N);
    steps(&mut harness, 6);
    save(&mut harness, "ways-four-pantry");
}

#[test]
fn on_a_phone_two_ways_are_seen_at_a_time() {
    let mut harness = three_ways(PHONE);
    press(&mut harness, Key::F4);
    act(&mut harness, Act::Time(TimeAct::Scrub(100.0)));
    settle(&mut harness);
    save(&mut harness, "phone-ways");
    assert!(harness.query_all_by_label("flip at 1:00").count() == 2, "column and legend");
    harness.get_by_role_and_label(Role::Button, "The way after").click();
    steps(&mut harness, 4);
    assert!(harness.query_all_by_label("0 W at 1:00").count() == 2, "column and legend");
    act(&mut harness, Act::App(AppAct::Set(Setting::Theme(Theme::Light))));
    act(&mut harness, Act::App(AppAct::Set(Setting::Language(crate::harness::japanese()))));
    steps(&mut harness, 10);
    save(&mut harness, "ja-phone-ways-light");
    harness.set_size(WIDE);
    settle(&mut harness);
    save(&mut harness, "ja-ways-light");
    // Fingers.
    harness.set_size(PHONE);
    act(&mut harness, Act::App(AppAct::Set(Setting::Language(Language::ENGLISH))));
    let (device_id, id) = (egui::TouchDeviceId(1), egui::TouchId(1));
    for phase in [egui::TouchPhase::Start, egui::TouchPhase::End] {
        harness.event(egui::Event::Touch { device_id, id, phase, pos: egui::pos2(4.0, 4.0), force: None });
        steps(&mut harness, 4);
    }
    save(&mut harness, "phone-ways-touch");
    for label in ["The way before", "The way after", "Cook on here"] {
        let rect = harness.get_by_role_and_label(Role::Button, label).rect();
        assert!(rect.height() >= TOUCH && rect.right() <= PHONE.x, "{label}: {rect:?}");
    }
}

#[test]
fn one_way_alone_is_said() {
    let mut harness = window(WIDE);
    press(&mut harness, Key::F4);
    assert!(harness.query_by_label_contains("There is only one way so far.").is_some());
    assert!(!harness.state().shows_ways());
}
