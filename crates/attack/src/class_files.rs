//! Files of classes and studies: protocols, scenarios, goals, and logs of participants.

use std::sync::{Arc, LazyLock};

use saute_plan::Aimed;
use saute_schema::InputError;
use saute_study::class::{Lesson, Scenario};
use saute_study::{Event, LogRow, Participant, Protocol, Study, from_csv, shipped, to_csv};

use crate::kitchen_files::{LIBRARY, library_with};
use crate::text;

/// The shipped protocol, whose logs are attacked.
static SHIPPED: LazyLock<Arc<Protocol>> = LazyLock::new(|| {
    let text = shipped::text("2013").expect("it is shipped");
    Arc::new(Protocol::parse(text, "2013.toml", &LIBRARY).expect("the shipped files are sound"))
});

fn participant() -> Participant {
    "P01".parse().expect("a code")
}

/// Every refusal states where, what and what to write instead.
fn check(refused: &InputError, file: &str) {
    let InputError { file: named, line, message, remedy } = refused;
    assert!(named == file && *line > 0 && !message.is_empty() && !remedy.is_empty(), "{refused:?}");
}

/// A protocol of a study, begun by a participant.
pub fn protocol(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    match Protocol::parse(text, "protocol.toml", &LIBRARY) {
        Ok(protocol) => {
            let mut study = Study::begin(Arc::new(protocol), participant());
            let rows = study.take(Event::Agreed, 1.0).expect("it begins with the consent");
            let _ = (study.condition(), study.stage(), study.phase(), study.information(), to_csv(&rows, true));
        }
        Err(refused) => check(&refused, "protocol.toml"),
    }
}

/// A scenario of a lesson, begun.
pub fn scenario(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    match Scenario::parse(text, "scenario.toml", &LIBRARY) {
        Ok(scenario) => {
            let mut lesson = Lesson::begin(Arc::new(scenario), None);
            let _ = (lesson.asked().len(), lesson.waiting(), lesson.answer(1.0));
        }
        Err(refused) => check(&refused, "scenario.toml"),
    }
}

/// Goals in the place of the shipped ones, each with its scale.
pub fn goals(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    let Some(library) = library_with("goals.toml", text, None) else { return };
    for goal in &library.goals {
        let aimed = Aimed::of(&library, &goal.id);
        assert!(aimed.is_none_or(|aimed| !aimed.classes().is_empty()), "{}", goal.id);
    }
}

/// A log of a participant, from which the shipped study goes on.
pub fn study_log(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    match from_csv("log.csv", text) {
        Ok(rows) => go_on(&rows),
        Err(refused) => assert!(refused.file == "log.csv" && !refused.message.is_empty(), "{refused:?}"),
    }
}

fn go_on(rows: &[LogRow]) {
    let written = to_csv(rows, true);
    let again = from_csv("log.csv", &written).expect("what was written can be read");
    assert_eq!(to_csv(&again, true), written, "and is the same");
    let study = Study::begin(Arc::clone(&SHIPPED), participant());
    if let Ok(study) = study.resume(rows) {
        let _ = study.stage();
    }
}
