//! The result: opens once by itself, states why with numbers that add up, names one thing to do better, and is shared as a picture.

use std::path::PathBuf;

use egui::Key;
use egui_kittest::kittest::Queryable;
use saute_controls::act::{Act, AppAct, Card, CookAct, Setting};
use saute_controls::goal_choice::goal_of;
use saute_kitchen::{Command, Place, RestOn};
use saute_plan::goal::{Better, Goal, GoalVerdict, Judgement, Shortfall};
use saute_window::{DesktopOptions, SauteApp, Start};
use saute_words::judgement_words::ResultWords;
use saute_words::language::Language;

use super::{PHONE, WIDE, act, command, core_c, fry, put_in, rested, says, set, small_steak, until};
use crate::harness::{press, save, steps, window_with};

fn goal(app: &SauteApp) -> Goal {
    goal_of(app.session(), app.settings()).expect("a goal")
}

fn judged(app: &SauteApp) -> Judgement {
    app.session().judgement(&goal(app)).expect("there is food")
}

#[test]
fn the_result_opens_once_when_the_food_has_rested_and_time_waits_behind_it() {
    let mut harness = rested(WIDE, 52.0, |_| {});
    assert!(says(&harness, "One thing to do better") && says(&harness, "Grey band"));
    let time_s = harness.state().session().kitchen.time_s();
    steps(&mut harness, 10);
    assert_eq!(harness.state().session().kitchen.time_s(), time_s, "time waits");
    press(&mut harness, Key::Escape);
    steps(&mut harness, 20);
    assert!(!says(&harness, "One thing to do better"), "it opens once");
    assert!(harness.state().session().kitchen.time_s() > time_s);
    harness.get_by_label("Result").click();
    steps(&mut harness, 3);
    assert!(says(&harness, "One thing to do better"), "and at any time by its button");
}

#[test]
fn the_result_that_is_switched_off_stays_away_and_one_of_rare_medium_and_overcooked_says_which() {
    let quiet = |harness: &mut egui_kittest::Harness<'static, SauteApp>| set(harness, Setting::ResultOpens(false));
    let mut better = Vec::new();
    for (pull_c, name) in [(44.0, "rare"), (54.0, "medium"), (76.0, "overcooked")] {
        let mut harness = rested(WIDE, pull_c, quiet);
        assert!(!says(&harness, "One thing to do better"), "{name}: it is switched off");
        act(&mut harness, Act::App(AppAct::Open(Card::Result)));
        steps(&mut harness, 3);
        save(&mut harness, &format!("result-{name}"));
        let judgement = judged(harness.state());
        let mark = judgement.mark;
        let grade = if mark.points() >= 80.0 {
            "Just right"
        } else if mark.points() >= 60.0 {
            "Nearly"
        } else {
            "Not yet"
        };
        let words = format!("{grade} · {:.0} of 100", mark.points());
        assert!(says(&harness, &words) && says(&harness, "How is this counted?"), "{name}: {words}");
        let expected = match name {
            "rare" => Some(Shortfall::Undercooked),
            "overcooked" => Some(Shortfall::Overcooked),
            _ => None,
        };
        let is_met = judgement.verdict == GoalVerdict::Met;
        assert!(says(&harness, if is_met { "Goal met: Medium" } else { "Goal missed: Medium" }), "{name}");
        if let (Some(shortfall), GoalVerdict::Missed(missed)) = (expected, &judgement.verdict) {
            assert!(missed.contains(&shortfall), "{name}: {judgement:?}");
        }
        assert_eq!(is_met, expected.is_none(), "{name}: {judgement:?}");
        better.push(judgement.better);
    }
    assert!(matches!(better[0], Some(Better::PullLater { .. })), "{better:?}");
    assert!(matches!(better[2], Some(Better::PullEarlier { .. } | Better::LessPower { .. })), "{better:?}");
}

#[test]
fn the_result_is_shared_as_a_picture_of_its_own_and_fits_a_phone_and_japanese() {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("shared-results");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("folder");
    let mut harness = window_with(
        PHONE,
        Start {
            desktop: DesktopOptions { pictures: Some(folder.clone()), ..DesktopOptions::default() },
            ..Start::default()
        },
    );
    act(&mut harness, Act::Cook(CookAct::SetOut(1)));
    let mut small = small_steak(PHONE);
    fry(&mut small, 54.0);
    std::mem::swap(harness.state_mut().session_mut(), small.state_mut().session_mut());
    harness.state_mut().session_mut().set_paused(false);
    steps(&mut harness, 10);
    save(&mut harness, "result-phone");
    harness.get_by_label("Share as picture").click();
    steps(&mut harness, 3);
    let shared = image::open(folder.join("saute-1.png")).expect("a picture").to_rgb8();
    assert!(shared.width() > 1000 && shared.height() > 600, "{:?}", shared.dimensions());
    let ground = shared.get_pixel(2, 2);
    let inked = shared.pixels().filter(|pixel| *pixel != ground).count();
    assert!(inked > 40_000, "{inked} pixels are painted");
    harness.state_mut().set_language(crate::harness::japanese());
    steps(&mut harness, 10);
    save(&mut harness, "result-phone-ja");
    harness.get_by_label("画像で共有").click();
    steps(&mut harness, 3);
    assert!(folder.join("saute-2.png").exists());
}

#[test]
fn a_goal_is_chosen_from_its_card_and_the_advice_leads_there() {
    let mut harness = small_steak(WIDE);
    harness.get_by_label("Learn").click();
    steps(&mut harness, 3);
    harness.get_by_label("Goals").click();
    steps(&mut harness, 3);
    save(&mut harness, "goals");
    assert!(harness.query_by_label("Goal: Shrimps, just opaque").is_none(), "it fits no steak");
    harness.get_by_label("Goal: Rare, with a crust").click();
    steps(&mut harness, 2);
    let app = harness.state();
    let scale = app.scale().expect("a scale");
    let goal = app.settings().goal(&scale);
    assert_eq!(scale.name_of(scale.of_nodes(goal)), "rare");
    assert_eq!(goal_of(app.session(), app.settings()).expect("a goal").name, "Rare, with a crust");
    harness.get_by_label("Goal: More than 40 % medium").click();
    steps(&mut harness, 2);
    let app = harness.state();
    let goal = goal_of(app.session(), app.settings()).expect("a goal");
    assert_eq!((goal.scale.id.as_str(), goal.least_share_pct), ("paper-2013", 40.0));
    set(&mut harness, Setting::Goal(51.0));
    let app = harness.state();
    assert_eq!(
        goal_of(app.session(), app.settings()).expect("a goal").name,
        "Rare, with a crust",
        "the row holds again"
    );
}

/// Tongs carry food out without a command that makes a mark.
#[test]
fn food_that_no_button_took_out_has_its_result_too_and_nearly_raw_food_is_told_no_seconds() {
    let mut harness = small_steak(WIDE);
    put_in(&mut harness);
    until(&mut harness, |session| core_c(session) > 8.0);
    let rest = Command::Rest { food: "steak".into(), on: RestOn::Board };
    harness.state_mut().session_mut().kitchen.apply(&rest).expect("comes out");
    command(&mut harness, &Command::Hob(0.0));
    until(&mut harness, |session| session.shown_piece().is_some_and(|steak| matches!(steak.place, Place::Rest(_))));
    // Who asks before it has rested is told neither that it is missed nor that it is met.
    act(&mut harness, Act::App(AppAct::Open(Card::Result)));
    assert!(says(&harness, "Still resting: the core rises to about ") && !says(&harness, "Goal missed"));
    assert!(!says(&harness, "How is this counted?"), "no points yet");
    act(&mut harness, Act::App(AppAct::Shut(Card::Result)));
    until(&mut harness, |session| session.shown_piece().is_some_and(|steak| steak.core() < steak.core_peak.0 - 0.5));
    harness.state_mut().session_mut().set_paused(false);
    steps(&mut harness, 8);
    assert!(says(&harness, "One thing to do better") && says(&harness, "Goal missed"), "it opens by itself");
    save(&mut harness, "result-raw");
    let better = ResultWords::of(
        &judged(harness.state()),
        &goal(harness.state()),
        &harness.state().session().noun(Language::ENGLISH),
        harness.state().settings().speech(),
    );
    println!("{}", better.better[1]);
    let is_in_words = better.better[1].contains("It was far from done") || better.better[1].contains(" min longer");
    assert!(is_in_words, "{}", better.better[1]);
}
