//! Promise: the window serves every food: its own name, its own sizes, and doneness by the scale that was chosen.

use egui::Key;
use egui_kittest::{Harness, kittest::Queryable};
use saute_controls::act::{Act, CookAct, TimeAct};
use saute_kitchen::Command;
use saute_picture::View;
use saute_session::kept::link::fragment;
use saute_window::{SauteApp, Start};
use saute_words::language::Language;

use crate::harness::{cook, press, save, steps, window};

const WIDE: egui::Vec2 = egui::vec2(1280.0, 720.0);
const PHONE: egui::Vec2 = egui::vec2(390.0, 844.0);

/// A window that plays a recipe, some seconds on.
fn playing(size: egui::Vec2, recipe: &str, seconds: f64) -> Harness<'static, SauteApp> {
    let mut harness = window(size);
    harness.state_mut().open_recipe(recipe, "own.toml");
    cook(&mut harness, seconds);
    harness
}

fn frying(kind: &str, id: &str, more: &str) -> String {
    format!(
        "{more}[pan]\ninitial_c = 190\n[[food]]\nid = \"{id}\"\nkind = \"{kind}\"\n[[step]]\nhob_w = 800\n\
         [[step]]\nput = \"{id}\"\n[[step]]\nafter_s = 900\nend = true\n"
    )
}

#[test]
fn the_scale_of_doneness_is_cycled_by_key_and_always_labelled() {
    let mut harness = playing(WIDE, &frying("beef-lean", "steak", ""), 240.0);
    for (id, label) in [("chefs", "Chefs"), ("academic", "AMSA / USDA"), ("paper-2013", "Kato & Hasegawa 2013")] {
        press(&mut harness, Key::D);
        steps(&mut harness, 10);
        assert_eq!(harness.state().settings().scale, id);
        harness.get_by_label(&format!("Scale of doneness: {label}"));
        harness.get_by_label_contains(&format!("Cross-section by {label}: raw"));
        press(&mut harness, Key::Num4);
        harness.get_by_label(&format!("Doneness by {label}"));
        save(&mut harness, &format!("scale-{id}"));
        let right = harness.get_by_label("Goal for the core").rect().right();
        let whole = egui::Rect::from_min_size(egui::Pos2::ZERO, WIDE);
        let panel = saute_window::ui::layout::Layout::new(whole, harness.state().settings()).right;
        assert!(right <= panel.right() - 10.0, "the goals stay in their panel: {right}");
        press(&mut harness, Key::Num1);
    }
}

#[test]
fn the_scale_of_doneness_is_chosen_at_the_bar_and_remembered() {
    let mut harness = window(WIDE);
    harness.get_by_label("Scale of doneness: Kato & Hasegawa 2013").click();
    steps(&mut harness, 3);
    harness.get_by_label("Chefs").click();
    steps(&mut harness, 3);
    assert_eq!(harness.state().settings().scale, "chefs");
    harness.get_by_label_contains("medium-rare 0 %");
    let stored = serde_json::to_string(harness.state().settings()).expect("settings");
    let again = SauteApp::start(&egui::Context::default(), None, Some(stored), Start::default()).expect("starts");
    assert_eq!(again.scale().expect("a scale").id, "chefs");
}

#[test]
fn a_scale_that_is_no_longer_there_gives_way_to_the_first() {
    let stored = Some("{\"scale\": \"of-old\"}".to_owned());
    let app = SauteApp::start(&egui::Context::default(), None, stored, Start::default()).expect("starts");
    assert_eq!(app.scale().expect("a scale").id, "paper-2013");
}

#[test]
fn the_view_of_doneness_is_labelled_without_panels_and_on_a_phone() {
    let mut harness = window(WIDE);
    press(&mut harness, Key::Num4);
    press(&mut harness, Key::H);
    harness.get_by_label("Doneness by Kato & Hasegawa 2013");
    let mut phone = playing(PHONE, &frying("beef-lean", "steak", ""), 200.0);
    press(&mut phone, Key::D);
    press(&mut phone, Key::Num4);
    steps(&mut phone, 60);
    phone.get_by_label("Doneness by Chefs");
    save(&mut phone, "phone-doneness");
    phone.get_by_label("Inside").click();
    steps(&mut phone, 12);
    save(&mut phone, "phone-chefs");
}

#[test]
fn every_food_is_set_out_with_its_own_name_and_size_and_many_over_frames() {
    let mut harness = window(WIDE);
    press(&mut harness, Key::N);
    let library = harness.state().session().library.clone();
    for (id, food) in &library.foods {
        harness.get_by_label(&food.name).click();
        steps(&mut harness, 2);
        let choice = &harness.state().settings().choice;
        assert_eq!((&choice.kind, &choice.size_mm), (id, &food.size.default_mm));
        harness.get_by_label("Set out").click();
        steps(&mut harness, 3);
        let piece = harness.state().session().shown_piece().expect("a piece");
        assert_eq!(&piece.kind, id);
        let noun = harness.state().session().noun(Language::ENGLISH);
        harness.get_by_label_contains(&format!("a raw {noun}"));
        harness.get_by_label("In the pan").click();
        steps(&mut harness, 14);
        assert!(harness.state().session().shown_piece().expect("a piece").in_pan(), "{id}");
        save(&mut harness, &format!("food-{id}"));
    }
    many_are_set_out_over_frames_which_can_be_stopped(&mut harness);
    many_are_added_over_frames_and_taken_back(&mut harness);
    recipes_and_links_with_many_are_opened_over_frames(&mut harness);
}

#[test]
fn the_goal_of_a_shrimp_is_its_own_and_a_steak_keeps_the_goal_that_was_set() {
    let mut harness = playing(WIDE, &frying("shrimp", "shrimp", ""), 10.0);
    let app = harness.state();
    let (shrimp, steak) = (app.scale().expect("a scale"), app.session().library.scale("chefs").expect("chefs").clone());
    assert_eq!((shrimp.id.as_str(), app.settings().goal(&shrimp), app.settings().goal(&steak)), ("shrimp", 63.0, 62.0));
    harness.get_by_role_and_label(egui::accesskit::Role::Button, "firm").click();
    steps(&mut harness, 3);
    let settings = harness.state().settings();
    assert_eq!((settings.goal(&shrimp), settings.goal(&steak)), (72.0, 62.0));
    let stored = serde_json::to_string(settings).expect("settings");
    let again = SauteApp::start(&egui::Context::default(), None, Some(stored), Start::default()).expect("starts");
    assert_eq!(again.settings().goal(&shrimp), 72.0);
}

#[test]
fn a_vegetable_is_crisp_tender_or_soft_and_keeps_its_words_whatever_scale_is_chosen_for_meat() {
    let mut harness = playing(WIDE, &frying("carrot-coin", "coin", ""), 240.0);
    harness.get_by_label_contains("Cross-section by Tenderness: crisp");
    press(&mut harness, Key::G);
    harness.get_by_label("Juiciness");
    press(&mut harness, Key::D);
    steps(&mut harness, 10);
    assert_eq!(harness.state().settings().scale, "paper-2013");
    assert_eq!(harness.state().scale().expect("a scale").id, "vegetables");
    harness.get_by_label("Scale of doneness: Tenderness");
    press(&mut harness, Key::Num4);
    steps(&mut harness, 10);
    assert_eq!(harness.state().settings().view, View::Doneness);
    harness.get_by_label("Doneness by Tenderness");
    assert!(harness.query_all_by_label("crisp").count() > 1, "the legend and the shares");
    save(&mut harness, "carrot-doneness");
    press(&mut harness, Key::Num1);
    press(&mut harness, Key::V);
    press(&mut harness, Key::V);
    press(&mut harness, Key::X);
    steps(&mut harness, 10);
    save(&mut harness, "carrot-close");
    let mut phone = playing(PHONE, &frying("leek-ring", "ring", ""), 120.0);
    phone.get_by_label("Inside").click();
    steps(&mut phone, 12);
    save(&mut phone, "phone-leek");
    phone.get_by_label("Food").click();
    steps(&mut phone, 3);
    save(&mut phone, "phone-food");
}

#[test]
fn the_rules_of_2013_are_labelled_at_all_times() {
    let mut harness = playing(WIDE, &frying("beef-lean", "steak", "preset = \"2013\"\n"), 30.0);
    harness.get_by_label("rules of 2013");
    save(&mut harness, "rules-2013");
    press(&mut harness, Key::H);
    harness.get_by_label("rules of 2013");
    assert!(window(WIDE).query_by_label("rules of 2013").is_none());
}

/// From a cold pan: a bell once the dial is reached; where water boils that it is reached only without it.
fn the_hob_says_where_it_stands(harness: &mut Harness<'static, SauteApp>) {
    const REACHED: &str = "the pan is as hot as it is held";
    let command = |h: &mut Harness<'static, SauteApp>, c| h.state_mut().session_mut().command(&c).expect("is done");
    command(harness, Command::HobHold { temperature: saute_kitchen::kelvin(180.0), power: 2000.0 });
    cook(harness, 20.0);
    assert!(harness.query_by_label(REACHED).is_none(), "the pan is not hot yet");
    cook(harness, 160.0);
    harness.get_by_label(REACHED);
    save(harness, "dial-reached");
    command(harness, Command::Water(0.3));
    cook(harness, 90.0);
    assert!(harness.query_by_label(REACHED).is_none());
    harness.get_by_label("water boils in the pan: it gets as hot as it is set only without it");
    save(harness, "boils-below-dial");
}

/// The stove is chosen beside the pan, takes effect with "Set out", and offers what it can.
fn another_stove_is_chosen_and_fried_on(harness: &mut Harness<'static, SauteApp>) {
    press(harness, Key::N);
    let mut now = "Induction hob";
    for (stove, power, picture) in [
        ("Gas burner", "2000 W", "stove-gas"),
        ("Iron hot plate", "1150 W", "stove-plate"),
        ("Glass-ceramic hob, radiant", "1800 W", "stove-radiant"),
    ] {
        harness.get_by_label(&format!("Stove: {now}")).scroll_to_me();
        harness.run_steps(3);
        harness.get_by_label(&format!("Stove: {now}")).click();
        harness.run_steps(3);
        harness.get_by_label(stove).click();
        harness.run_steps(3);
        harness.get_by_label(&format!("Stove: {stove}"));
        save(harness, "stoves");
        harness.get_by_label("Set out").scroll_to_me();
        harness.run_steps(3);
        harness.get_by_label("Set out").click();
        harness.run_steps(3);
        let of_kitchen = |h: &Harness<'static, SauteApp>| h.state().session().kitchen.hob().name.clone();
        assert_eq!(of_kitchen(harness), stove);
        assert!(harness.query_by_label_contains("Hold pan at").is_none(), "{stove} has no sensor");
        harness.get_by_label(power).click();
        harness.run_steps(3);
        let watts = harness.state().session().kitchen.hob_w();
        assert_eq!(format!("{watts:.0} W"), power);
        cook(harness, 60.0);
        assert!(harness.state().session().kitchen.pan_temperature() > saute_kitchen::kelvin(35.0), "{stove} heats");
        save(harness, picture);
        now = stove;
    }
}

#[test]
fn the_hob_says_why_it_gives_no_power() {
    let mut harness = window(WIDE);
    let command = |h: &mut Harness<'static, SauteApp>, c: Command| {
        h.state_mut().session_mut().command(&c).expect("is done");
        cook(h, 1.0);
    };
    command(&mut harness, Command::Hob(1100.0));
    assert!(harness.query_by_label_contains("No power").is_none());
    command(&mut harness, Command::MovePan { at: [0.0; 2], lift: 0.1 });
    harness.get_by_label("No power: the pan is lifted");
    command(&mut harness, Command::MovePan { at: [0.3, 0.0], lift: 0.0 });
    harness.get_by_label("No power: the pan is off its ring");
    command(&mut harness, Command::MovePan { at: [0.0; 2], lift: 0.0 });
    command(&mut harness, Command::Cool { for_s: 3.0 });
    harness.get_by_label("No power: the pan is on the cloth");
    cook(&mut harness, 3.0);
    the_hob_says_where_it_stands(&mut harness);
    another_stove_is_chosen_and_fried_on(&mut harness);
    let empty = "[pan]\ninitial_c = 290\n[[step]]\nhob_w = 3500\n[[step]]\nafter_s = 900\nend = true\n";
    let mut hot = playing(WIDE, empty, 0.0);
    cook(&mut hot, 90.0);
    hot.get_by_label("Less power: overheat protection");
    save(&mut hot, "limit");
}

fn ask(harness: &mut Harness<'static, SauteApp>, act: Act) {
    let context = harness.ctx.clone();
    harness.state_mut().act(act, &context);
    steps(harness, 2);
}

fn builds(harness: &Harness<'static, SauteApp>) -> bool {
    harness.query_by_label_contains("Setting out the food").is_some()
}

/// Lets all foods be built.
fn build(harness: &mut Harness<'static, SauteApp>) {
    for _ in 0..300 {
        if !builds(harness) {
            return;
        }
        harness.step();
    }
}

fn pieces(harness: &Harness<'static, SauteApp>) -> usize {
    harness.state().session().kitchen.pieces().len()
}

/// A cook with one shrimp, which knows no other food.
fn one_shrimp(harness: &mut Harness<'static, SauteApp>) {
    harness.get_by_label("Shrimp").click();
    steps(harness, 2);
    ask(harness, Act::Cook(CookAct::SetOut(1)));
    assert_eq!(pieces(harness), 1);
}

/// The window goes on while many pieces are built, says how far it is, and lets go of them on Esc or by a button.
fn many_are_set_out_over_frames_which_can_be_stopped(harness: &mut Harness<'static, SauteApp>) {
    harness.get_by_label("Shrimp").click();
    steps(harness, 2);
    let set_out = Act::Cook(CookAct::SetOut(60));
    for stop in [true, false] {
        ask(harness, set_out.clone());
        harness.get_by_label_contains("Setting out the food: 0 of 60");
        save(harness, "building");
        // Whoever is impatient does not begin it again.
        steps(harness, 3);
        ask(harness, set_out.clone());
        assert!(harness.query_by_label_contains("Setting out the food: 0 of 60").is_none());
        if stop {
            press(harness, Key::Escape);
        } else {
            harness.get_by_label("Stop").click();
        }
        steps(harness, 3);
        assert!(!builds(harness) && pieces(harness) == 1, "the cook before goes on");
    }
    ask(harness, set_out);
    // What is chosen meanwhile is for the next time.
    harness.get_by_label("Carrot coin").click();
    build(harness);
    assert_eq!(pieces(harness), 60);
    assert!(harness.state().session().kitchen.pieces().iter().all(|piece| piece.kind == "shrimp"));
    // All are known now.
    ask(harness, Act::Cook(CookAct::Restart));
    assert!(!builds(harness) && pieces(harness) == 60);
}

/// Food that is added waits too; Undo takes it back, and what does not fit is refused before any of it is built.
fn many_are_added_over_frames_and_taken_back(harness: &mut Harness<'static, SauteApp>) {
    one_shrimp(harness);
    ask(harness, Act::Cook(CookAct::Add(60)));
    assert!(builds(harness));
    ask(harness, Act::Time(TimeAct::Undo));
    assert!(!builds(harness) && pieces(harness) == 1);
    ask(harness, Act::Cook(CookAct::Add(60)));
    build(harness);
    assert_eq!(pieces(harness), 61);
    ask(harness, Act::Cook(CookAct::Add(60)));
    assert!(!builds(harness) && pieces(harness) == 61);
}

/// A recipe and a link with many pieces are opened over frames.
fn recipes_and_links_with_many_are_opened_over_frames(harness: &mut Harness<'static, SauteApp>) {
    one_shrimp(harness);
    let recipe =
        "title = \"Many\"\n[[food]]\nid = \"x\"\nkind = \"shrimp\"\ncount = 60\n[[step]]\nat_s = 9\nend = true\n";
    harness.state_mut().open_recipe(recipe, "many.toml");
    steps(harness, 2);
    assert!(builds(harness) && pieces(harness) == 1);
    build(harness);
    assert_eq!(pieces(harness), 60);
    let link = fragment(&harness.state().session().whole_recording());
    one_shrimp(harness);
    harness.state_mut().open_link(&link);
    steps(harness, 2);
    assert!(builds(harness) && pieces(harness) == 1);
    build(harness);
    assert_eq!(pieces(harness), 60);
}
