//! Promise: a plan is found and shown in the window, and a cook that does each step when the guide requests it gets what was promised.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex};

use egui::{accesskit::Role, vec2};
use egui_kittest::{Harness, kittest::Queryable};
use saute_controls::act::{Act, AppAct, Card, LearnAct, Setting};
use saute_controls::plan::{PlanAct, PlanFile};
use saute_controls::settings::plan_choice::PlanChoice;
use saute_kitchen::{Command, Library};
use saute_plan::goal::{Goal, Outcome, Shortfall};
use saute_plan::schedule::asked::Asked;
use saute_plan::schedule::search::PlanData;
use saute_plan::schedule::{Change, Job, Mesh, Order, Plan, Pull, Schedule, Sensitivity, Setting as Power};
use saute_session::FoodChoice;
use saute_session::plan::job::{PlanAnswer, PlanOrder, Reply};
use saute_session::work::{Agency, Helper, WorkKind};
use saute_window::SauteApp;

use crate::harness::{save, steps, window};

pub(super) const WIDE: egui::Vec2 = vec2(1280.0, 720.0);
pub(super) const PHONE: egui::Vec2 = vec2(390.0, 844.0);

/// A plan for a small steak: its times are chosen, its promise is what its cook gives.
pub(super) fn plan(library: &Library) -> Plan {
    plan_for(library, "medium", 60.0)
}

/// As [`plan`], for another target and crust [%]; each is cooked once.
pub(super) fn plan_for(library: &Library, target: &str, crust_pct: f64) -> Plan {
    static COOKED: Mutex<BTreeMap<String, Plan>> = Mutex::new(BTreeMap::new());
    let mut cooked = COOKED.lock().expect("no test panicked while it cooked");
    cooked.entry(format!("{target} {crust_pct}")).or_insert_with(|| cook_plan(library, target, crust_pct)).clone()
}

fn cook_plan(library: &Library, target: &str, crust_pct: f64) -> Plan {
    let power = |at_s, hob_w| Power { at_s, hob_w };
    let order = Order {
        food: "beef-lean".into(),
        size_mm: vec![60.0, 50.0, 15.0],
        initial_c: 5.0,
        count: None,
        hob: None,
        pan: "carbon-steel-26".into(),
        hob_w: vec![400.0, 1100.0, 2000.0],
        most_flips: 2,
        most_rest_s: None,
        pan_c: None,
        plain: false,
        goal: Goal::new(&target.parse().expect("a target"), library.scale("chefs").expect("a scale"), crust_pct)
            .expect("a class"),
    };
    let schedule = Schedule {
        powers: vec![power(0, 2000.0), power(45, 1100.0), power(90, 400.0)],
        put_s: 45,
        flips_s: vec![105, 165],
        pull_s: 200,
        rest_s: 60,
    };
    let job = Job { order: order.clone(), schedule, pull: Pull::AtItsTime, mesh: Mesh::Spaced(1.0) };
    let result = job.run(library).expect("cooks");
    let change = |change, core_peak_c, missing| Sensitivity {
        change,
        core_peak_c,
        target_share_pct: 31.0,
        crust_pct: 70.0,
        missing,
    };
    let sensitivity = Change::ALL
        .map(|c| change(c, result.outcome.core_peak_c + 3.0, (c != Change::ALL[3]).then_some(Shortfall::Share)))
        .to_vec();
    let (schedule, promised, score, cues) = (result.schedule, result.outcome, result.score, result.cues);
    Plan { order, schedule, promised, score, cues, sensitivity, candidates: 31, is_stopped: false, is_rough: false }
}

/// An agency that has one plan for every request.
struct Canned(Plan);

struct CannedHelper(Plan, Option<u64>);

impl Agency for Canned {
    fn hire(&self, kind: WorkKind, library: &Arc<Library>) -> Box<dyn Helper> {
        match kind {
            WorkKind::Plan => Box::new(CannedHelper(self.0.clone(), None)),
            _ => saute_session::work::in_frames::Frames.hire(kind, library),
        }
    }
}

impl Helper for CannedHelper {
    fn ask(&mut self, order: Vec<u8>) {
        self.1 = postcard::from_bytes::<PlanOrder>(&order).ok().map(|order| order.number);
    }

    fn answers(&mut self) -> Option<Vec<Vec<u8>>> {
        let answer = |number| PlanAnswer { number, reply: Reply::Found(Box::new(PlanData::from(&self.0))) };
        Some(self.1.take().map(|number| postcard::to_allocvec(&answer(number)).expect("bytes")).into_iter().collect())
    }
}

pub(super) fn act(harness: &mut Harness<'static, SauteApp>, act: Act) {
    let ctx = harness.ctx.clone();
    harness.state_mut().act(act, &ctx);
    steps(harness, 3);
}

/// The card, with the food of the plan chosen.
fn opened(size: egui::Vec2, plan: Plan) -> Harness<'static, SauteApp> {
    let mut harness = window(size);
    harness.state_mut().employ(Box::new(Canned(plan.clone())));
    let Order { food: kind, size_mm, initial_c, pan, goal, .. } = plan.order;
    let by_core = goal.scale.id == "core";
    let usual = PlanChoice::default();
    let core_c = if by_core { goal.aim.round() } else { usual.core_c };
    let asked = PlanChoice { by_core, core_c, crust_pct: Some(goal.crust_pct), ..usual };
    act(&mut harness, Act::Learn(LearnAct::Plan(PlanAct::Choose(asked))));
    let choice = FoodChoice { kind, size_mm, initial_c, pan, ..FoodChoice::default() };
    act(&mut harness, Act::App(AppAct::Set(Setting::Choice(choice))));
    act(&mut harness, Act::App(AppAct::Open(Card::Learn)));
    harness.get_by_label("Plan my steak").click();
    steps(&mut harness, 4);
    harness
}

pub(super) fn found(size: egui::Vec2, plan: Plan) -> Harness<'static, SauteApp> {
    let mut harness = opened(size, plan);
    harness.get_by_label("Find a plan").scroll_to_me();
    steps(&mut harness, 3);
    harness.get_by_label("Find a plan").click();
    steps(&mut harness, 5);
    harness
}

#[test]
fn a_plan_is_asked_for_found_and_shown_with_its_steps_promise_and_sensitivity() {
    let library = Library::embedded().expect("embedded data");
    let plan = plan(&library);
    for (size, name) in [(WIDE, "wide"), (PHONE, "phone")] {
        let mut harness = opened(size, plan.clone());
        harness.get_by_label("Food: Lean beef steak");
        save(&mut harness, &format!("plan-ask-{name}"));
        let mut harness = found(size, plan.clone());
        save(&mut harness, &format!("plan-found-{name}"));
        for words in ["Cook it live", "Let it cook itself", "Kitchen card", "Save recipe", "Promised", "into the pan"] {
            harness.get_by_label(words);
        }
        let core = format!("{:.1}", plan.promised.core_peak_c);
        harness.get_by_label_contains(&format!("Middle {core}"));
        harness.get_by_label_contains("Time line: 0:00 hob to 2000 W");
        harness.get_by_label_contains("3 mm thicker");
        harness.get_by_label_contains("the oil shimmers");
    }
}

#[test]
fn what_is_chosen_on_the_card_is_what_is_asked() {
    let library = Library::embedded().expect("embedded data");
    let mut harness = opened(WIDE, plan(&library));
    harness.get_by_role_and_label(Role::RadioButton, "rare").click();
    steps(&mut harness, 3);
    assert_eq!(harness.state().settings().plan.class, "rare");
    harness.get_by_role_and_label(Role::RadioButton, "by temperature").scroll_to_me();
    steps(&mut harness, 4);
    harness.get_by_role_and_label(Role::RadioButton, "by temperature").click();
    steps(&mut harness, 3);
    assert!(harness.state().settings().plan.by_core);
    harness.get_by_role_and_label(Role::SpinButton, "Core at its highest");
    let settings = harness.state().settings();
    let asked: Asked = settings.wanted_plan(&library);
    assert_eq!((asked.target.as_str(), asked.size_mm.as_slice()), ("core=57", &[60.0, 50.0, 15.0][..]));
}

/// The hand does a step when the bell rings, by the line's button.
#[test]
fn a_cook_by_the_guide_gives_what_was_promised() {
    let library = Library::embedded().expect("embedded data");
    let plan = plan(&library);
    let mut harness = found(WIDE, plan.clone());
    harness.get_by_label("Cook it live").click();
    steps(&mut harness, 3);
    save(&mut harness, "plan-live-begins");
    let mut pictures = ["plan-live-waits", "plan-live-rings"].into_iter();
    for second in 0..600 {
        if harness.query_by_label("The bell rings").is_some() {
            if second > 60 {
                pictures.next_back().into_iter().for_each(|name| save(&mut harness, name));
            }
            let button = harness.query_by_label_contains("Do it: ");
            if let Some(button) = button {
                button.click();
            }
            steps(&mut harness, 2);
        }
        if harness.query_by_label_contains("Rested: serve. You reached").is_some() {
            break;
        }
        for _ in 0..10 {
            harness.state_mut().session_mut().tick().expect("ticks");
            if due(&harness) {
                break;
            }
        }
        harness.step();
        if second == 70 {
            pictures.next().into_iter().for_each(|name| save(&mut harness, name));
        }
    }
    save(&mut harness, "plan-live-over");
    let masses = [harness.state().session().start_mass_g() * 1e-3];
    let gave = Outcome::read(&harness.state().session().kitchen, &masses, &plan.order.goal);
    let promised = &plan.promised;
    println!("core {:.2} → {:.2}", promised.core_peak_c, gave.core_peak_c);
    println!("share {:.2} → {:.2}", promised.target_share_pct, gave.target_share_pct);
    assert!((gave.core_peak_c - promised.core_peak_c).abs() < 1.0);
    assert!((gave.target_share_pct - promised.target_share_pct).abs() < 3.0);
    harness.get_by_label_contains(&format!("You reached: middle {:.1}", gave.core_peak_c));
}

/// The turner in a hand and the button count alike, and the button's flip does not count twice.
#[test]
fn a_flip_by_the_turner_in_the_hand_is_a_step_of_the_guide() {
    use saute_plan::schedule::Deed;
    use saute_plan::schedule::follow::StepStatus;
    let library = Library::embedded().expect("embedded data");
    let mut harness = found(WIDE, plan(&library));
    harness.get_by_label("Cook it live").click();
    steps(&mut harness, 3);
    let flips = |harness: &Harness<'static, SauteApp>| -> Vec<StepStatus> {
        let followed = harness.state().guidance().expect("a guide").steps;
        followed.iter().filter(|f| matches!(f.step.deed, Deed::Flip(_))).map(|f| f.standing).collect()
    };
    let session = harness.state_mut().session_mut();
    let food = session.kitchen.pieces()[0].id.clone();
    session.command(&Command::Put { food: food.clone(), at: [0.0; 2], heap: false }).expect("puts");
    (0..30).for_each(|_| session.tick().map(drop).expect("ticks"));
    crate::teaching::turned::turn_by_hand(&mut harness);
    assert!(matches!(flips(&harness)[..], [StepStatus::Done(_), StepStatus::Open(_)]), "{:?}", flips(&harness));
    let session = harness.state_mut().session_mut();
    session.command(&Command::Flip { food }).expect("flips");
    assert!(matches!(flips(&harness)[..], [_, StepStatus::Done(_)]), "at once: {:?}", flips(&harness));
    let session = harness.state_mut().session_mut();
    let before = session.recorder.turns().count();
    (0..40).for_each(|_| session.tick().map(drop).expect("ticks"));
    assert_eq!((before, session.recorder.turns().count()), (1, 2), "it was turned");
    let [StepStatus::Done(first_s), StepStatus::Done(second_s)] = flips(&harness)[..] else { panic!("both are done") };
    assert!(second_s + 60.0 > first_s + 1.0, "the second is the command, {first_s} s and {second_s} s");
}

/// True if the next step of the cook is due.
pub(super) fn due(harness: &Harness<'static, SauteApp>) -> bool {
    harness.state().guidance().and_then(|guidance| guidance.due_in_s()).is_some_and(|in_s| in_s <= 1e-6)
}

#[test]
fn a_late_step_is_said_to_be_late_and_moves_no_other() {
    let library = Library::embedded().expect("embedded data");
    let plan = plan(&library);
    let mut harness = found(PHONE, plan);
    harness.get_by_label("Cook it live").click();
    // A button that has just become another one takes no click.
    steps(&mut harness, 26);
    harness.get_by_label_contains("Do it: hob to 2000 W").click();
    steps(&mut harness, 3);
    (0..557).for_each(|_| harness.state_mut().session_mut().tick().expect("ticks"));
    steps(&mut harness, 26);
    harness.get_by_label_contains("12 s late");
    save(&mut harness, "plan-live-late-phone");
    harness.get_by_label_contains("Do it: into the pan").click();
    steps(&mut harness, 4);
    harness.get_by_label_contains("12 s late. The other times stay.");
    let guidance = harness.state().guidance().expect("a guide");
    assert!(guidance.steps.iter().any(|followed| followed.step.at_s == 105), "the first flip stays where it was");
    harness.get_by_label("End the guide").click();
    steps(&mut harness, 3);
    assert!(harness.query_by_label("End the guide").is_none() && harness.state().guidance().is_none());
}

#[test]
fn the_plan_cooks_itself_and_is_saved_as_a_card_and_as_a_recipe_that_is_the_plan() {
    let library = Library::embedded().expect("embedded data");
    let plan = plan(&library);
    let mut harness = found(WIDE, plan.clone());
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("plan");
    std::fs::create_dir_all(&folder).expect("a folder");
    let saved = |harness: &mut Harness<'static, SauteApp>, file: PlanFile| {
        let path = folder.join(format!("my-plan.{}", file.ending()));
        harness.state_mut().save_plan_at(file, &path);
        std::fs::read_to_string(path).expect("is saved")
    };
    assert!(saved(&mut harness, PlanFile::Recipe).ends_with(&plan.recipe_text()));
    let card = saved(&mut harness, PlanFile::Card);
    for part in ["@page", "into the pan", "shimmers", "thickness +3 mm", "medium"] {
        assert!(card.contains(part), "{part}");
    }
    harness.get_by_label("Let it cook itself").click();
    steps(&mut harness, 3);
    let session = harness.state().session();
    assert!(session.runner.is_some() && session.recording().beginning().text == plan.recipe_text());
}

#[test]
fn a_plan_reads_in_japanese() {
    let library = Library::embedded().expect("embedded data");
    let mut harness = found(WIDE, plan(&library));
    act(&mut harness, Act::App(AppAct::Set(Setting::Language(crate::harness::japanese()))));
    harness.get_by_label("自分で焼く");
    save(&mut harness, "plan-found-japanese");
    harness.get_by_label("自分で焼く").click();
    steps(&mut harness, 3);
    save(&mut harness, "plan-live-japanese");
}
