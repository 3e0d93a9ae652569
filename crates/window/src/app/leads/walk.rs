//! Every act is tried in a cook that a study or a lesson leads: what is locked changes nothing.

use std::sync::Arc;

use saute_kitchen::Library;
use saute_study::Protocol;
use saute_study::class::{Scenario, shipped};

use crate::app::SauteApp;
use crate::start::Start;
use saute_controls::act::GuidedAct;
use saute_controls::act::samples::samples;
use saute_controls::act::{Act, LearnAct};
use saute_session::guided::{LessonStart, StudyStart};
use saute_session::permits::Permit;

const PROTOCOL: &str = r#"id = "walk"
title = "Walked through"
consent = "You will cook once."
[[condition]]
id = "A"
information = "INFORMATION"
[[phase]]
title = "Only"
[phase.simulate]
recipe = "medium"
goal = "study-2013"
trials = 1
speed = 5
max_s = 600
"#;

/// A window in which a trial runs, with or without what cannot be perceived in a kitchen.
fn trial(information: &str) -> (SauteApp, egui::Context) {
    let library = Library::embedded().expect("embedded data");
    let text = PROTOCOL.replace("INFORMATION", information);
    let protocol = Arc::new(Protocol::parse(&text, "walk.toml", &library).expect("parses"));
    let study = StudyStart::in_memory(protocol, "P01".parse().expect("a code"));
    led(Start { study: Some(study), ..Start::default() }, [GuidedAct::Agree, GuidedAct::BeginTrial])
}

fn lesson(is_locked: bool) -> (SauteApp, egui::Context) {
    let library = Library::embedded().expect("embedded data");
    let id = "when-to-flip";
    let scenario = Scenario::parse(shipped::text(id).expect("is shipped"), id, &library).expect("parses");
    let lesson = LessonStart { scenario: Arc::new(scenario), student: None, is_locked };
    led(Start { lesson: Some(lesson), ..Start::default() }, [GuidedAct::BeginLesson])
}

fn led<const N: usize>(start: Start, begins: [GuidedAct; N]) -> (SauteApp, egui::Context) {
    let ctx = egui::Context::default();
    let mut app = SauteApp::start(&ctx, None, None, start).expect("starts");
    begins.into_iter().for_each(|act| app.act(Act::Learn(LearnAct::Guided(act)), &ctx));
    assert!(!app.leads.guided.as_ref().expect("is led").asks(), "it runs");
    (app, ctx)
}

/// All that an act could change, in words.
fn state(app: &SauteApp) -> String {
    let session = app.session();
    let cook = (session.kitchen.state_hash(), session.recording().entries().len(), session.generation, session.paused);
    let time = (session.shown_s(), session.speed, session.is_travelling(), session.kitchen.pieces().len());
    let seen = (
        app.sights.slice,
        app.desk.card,
        app.sights.scene.placing,
        app.photo_is_open(),
        app.leads.planning.is_searching(),
    );
    let settings = serde_json::to_string(&app.settings).expect("is written");
    format!("{cook:?} {time:?} {seen:?} {} {settings}", app.leads.guided.is_some())
}

#[test]
fn what_a_study_or_a_lesson_locks_changes_nothing_whichever_act_it_is() {
    let mut locked = 0;
    for begin in [|| trial("hidden"), || trial("shown"), || lesson(true), || lesson(false)] {
        let (mut app, ctx) = begin();
        let before = state(&app);
        for act in samples() {
            if app.permits().allow(act.traits().needs) {
                continue;
            }
            locked += 1;
            app.act(act.clone(), &ctx);
            assert_eq!(state(&app), before, "{act:?}");
            assert!(app.said().iter().any(|said| said == "This is locked here."), "{act:?}");
        }
    }
    // A walk that found nothing locked would pass.
    assert!(locked > 100, "{locked}");
}

#[test]
fn an_act_of_a_trial_is_cooking_looking_comfort_help_or_the_study_s_own() {
    let (app, _) = trial("hidden");
    for act in samples() {
        let needs = act.traits().needs;
        let is_for_a_trial = needs.iter().all(|permit| Permit::ALWAYS.contains(permit));
        assert_eq!(app.permits().allow(needs), is_for_a_trial, "{act:?}");
        assert!(!(act.traits().reads && is_for_a_trial), "{act:?} shows what is hidden");
    }
}

#[test]
fn whoever_gives_a_command_it_passes_the_same_list() {
    use saute_kitchen::Command;

    use saute_session::permits::{NotDone, Permits};

    let (mut app, _) = trial("hidden");
    assert_eq!(app.session.command(&Command::Hob(900.0)), Ok(()));
    app.session.permits = Permits::only(&[Permit::Eye]);
    let before = state(&app);
    for command in [
        Command::Hob(0.0),
        Command::HobHold { temperature: 450.0, power: 1000.0 },
        Command::Put { food: "steak".into(), at: [0.0; 2], heap: false },
        Command::Oil { kind: None, mass: 0.01 },
        Command::Lid(true),
        Command::Cool { for_s: 5.0 },
        Command::Tilt { angle: 0.1, towards: 0.0 },
        Command::LetGo,
    ] {
        assert_eq!(app.session.command(&command), Err(NotDone::Locked), "{command:?}");
    }
    assert_eq!(state(&app), before);
}
