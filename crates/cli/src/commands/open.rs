//! `saute` and `saute open`: the window.

use std::path::Path;
use std::process::ExitCode;
use std::sync::Arc;

use saute_controls::hands::HandsStart;
use saute_kitchen::data::library::DEFAULT_SCALE;
use saute_session::guided::{LessonStart, StudyStart};
use saute_study::class::{Scenario, shipped};
use saute_study::{NoCode, Participant};
use saute_window::{DesktopOptions, Start};

use crate::args::{HandArgs, OpenArgs};
use crate::error::CliError;
use crate::input::data_library::DataLibrary;
use crate::input::session_source::{self, Source};
use crate::input::text_file;

/// Opens the window with what is named: a recipe, a session or a lesson.
pub fn run_named(args: &OpenArgs, data: DataLibrary, hands: HandArgs) -> Result<ExitCode, CliError> {
    if let Some(name) = &args.scenario {
        let lesson = lesson(name, args, &data)?;
        return open(data, hands, Start { lesson: Some(lesson), ..Start::default() });
    }
    let source = args.recipe.as_deref().map(|recipe| session_source::load(recipe, &data)).transpose()?;
    run(data, source, hands)
}

/// Opens the window, and plays a recipe or goes on with a session if there is one.
pub fn run(data: DataLibrary, source: Option<Source>, hands: HandArgs) -> Result<ExitCode, CliError> {
    let (recipe, recorded) = match source {
        Some(Source::Recipe(recipe)) => (Some(*recipe), None),
        Some(Source::Session(recording)) => (None, Some(*recording)),
        None => (None, None),
    };
    open(data, hands, Start { recipe, recorded, ..Start::default() })
}

/// Opens the window in study mode.
pub fn run_study(data: DataLibrary, study: StudyStart, hands: HandArgs) -> Result<ExitCode, CliError> {
    open(data, hands, Start { study: Some(study), ..Start::default() })
}

fn open(data: DataLibrary, hands: HandArgs, start: Start) -> Result<ExitCode, CliError> {
    // The window states doneness in the words of a scale.
    data.scales(DEFAULT_SCALE)?;
    for device in [&hands.device, &hands.turner].into_iter().flatten() {
        saute_haptics::Named::parse(device)?;
    }
    if !has_display() {
        return Err(CliError::NoDisplay(NO_DISPLAY.to_owned()));
    }
    let HandArgs { device, turner, pairing, calibration } = hands;
    let host = HandsStart { pan: device, turner, pairing, calibration };
    let desktop = DesktopOptions { threads: true, speaker: true, pictures: None };
    let start = Start { library: Some(Arc::new(data.library)), host, desktop, ..start };
    saute_window::desktop::window::run(start)
        .map_err(|e| CliError::NoDisplay(format!("the window cannot be opened: {e}\n{NO_DISPLAY}")))?;
    Ok(ExitCode::SUCCESS)
}

/// The lesson of a scenario's file or id.
fn lesson(name: &str, args: &OpenArgs, data: &DataLibrary) -> Result<LessonStart, CliError> {
    let scenario = scenario(name, data)?;
    let student = args.student.as_deref().map(|code| participant("--student", code)).transpose()?;
    Ok(LessonStart { scenario, student, is_locked: args.lock })
}

/// A scenario by its file or id.
pub fn scenario(name: &str, data: &DataLibrary) -> Result<Arc<Scenario>, CliError> {
    let path = Path::new(name);
    let text = match shipped::text(name) {
        Some(text) if !path.is_file() => text.to_owned(),
        _ if path.exists() => text_file::read(path)?,
        _ => {
            let remedy = format!("name a .toml file or a shipped scenario: {}", shipped::names());
            return Err(CliError::place(name, "there is no such file and no scenario with this id", remedy));
        }
    };
    Ok(Arc::new(Scenario::parse(&text, name, &data.library)?))
}

/// The code that an option names.
pub fn participant(option: &str, code: &str) -> Result<Participant, CliError> {
    code.parse().map_err(|error: NoCode| {
        let text = error.to_string();
        let (message, remedy) = text.split_once(": ").unwrap_or((&text, "use letters and digits"));
        CliError::place(option, message, remedy)
    })
}

const NO_DISPLAY: &str = "there is no display; commands that need none:\n  \
    saute cook RECIPE.toml                            cook and print the numbers\n  \
    saute shot RECIPE.toml --at 300 --out steak.png   render a picture";

/// Returns false if the environment names no display. Only X11 and Wayland systems can be queried.
fn has_display() -> bool {
    if !cfg!(all(unix, not(target_os = "macos"))) {
        return true;
    }
    ["WAYLAND_DISPLAY", "WAYLAND_SOCKET", "DISPLAY"]
        .iter()
        .any(|key| std::env::var_os(key).is_some_and(|v| !v.is_empty()))
}
