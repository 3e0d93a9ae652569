//! Studies and lessons of a page, by the names in its address.

use std::sync::Arc;

use saute_kitchen::Library;
use saute_session::guided::{LessonStart, StudyStart};
use saute_study::class::{self, Scenario};
use saute_study::{Participant, Protocol};
use saute_window::browser::host::Host;
use saute_window::browser::page_log::study_in_page;

/// A shipped study with the code of its participant; a page without a script keeps its rows in memory.
pub(crate) fn study(library: &Library, (id, code): (&str, &str), host: Option<&Host>) -> Result<StudyStart, String> {
    let names = saute_study::shipped::names();
    let text =
        saute_study::shipped::text(id).ok_or_else(|| format!("study: there is no \"{id}\"; there are {names}"))?;
    let protocol = Protocol::parse(text, id, library).map_err(|e| e.to_string())?;
    let (protocol, participant) = (Arc::new(protocol), participant("participant", code)?);
    match host {
        Some(host) => study_in_page(protocol, participant, host),
        None => Ok(StudyStart::in_memory(protocol, participant)),
    }
}

/// A shipped lesson with the code of its student, which may be empty.
pub(crate) fn lesson(library: &Library, (id, code, is_locked): (String, String, bool)) -> Result<LessonStart, String> {
    let names = class::shipped::names();
    let text = class::shipped::text(&id).ok_or_else(|| format!("scenario: there is no \"{id}\"; there are {names}"))?;
    let scenario = Arc::new(Scenario::parse(text, &id, library).map_err(|e| e.to_string())?);
    let student = Some(code).filter(|code| !code.is_empty()).map(|code| participant("student", &code)).transpose()?;
    Ok(LessonStart { scenario, student, is_locked })
}

fn participant(key: &str, code: &str) -> Result<Participant, String> {
    code.parse().map_err(|error| format!("{key}: {error}"))
}
