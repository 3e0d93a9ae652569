//! A recorded session by the path of its file, and what takes a session in the place of a recipe.

use std::fs::File;
use std::io::Read;
use std::path::Path;
use std::sync::Arc;

use saute_recipe::session::{ReplayError, session_file};
use saute_recipe::{Cook, Recipe, Recording};

use crate::error::CliError;
use crate::input::data_library::DataLibrary;
use crate::input::{recipe_source, text_file};
use crate::output::stderr;

/// A recipe, or a session that was recorded.
#[derive(Debug)]
pub enum Source {
    /// A recipe.
    Recipe(Box<Recipe>),
    /// A session.
    Session(Box<Recording>),
}

/// Reads the session with a path, or the recipe with a path or an id.
pub fn load(name: &str, data: &DataLibrary) -> Result<Source, CliError> {
    if is_session(Path::new(name)) {
        return Ok(Source::Session(Box::new(load_session(Path::new(name))?)));
    }
    recipe_source::load(name, data).map(|recipe| Source::Recipe(Box::new(recipe)))
}

/// Returns true for a file that begins as a session.
pub fn is_session(path: &Path) -> bool {
    let mut start = Vec::new();
    let read = path.is_file() && File::open(path).and_then(|file| file.take(64).read_to_end(&mut start)).is_ok();
    read && session_file::is_session(&start)
}

/// Reads a session. An end that is not read is reported on stderr, and the rest is returned.
pub fn load_session(path: &Path) -> Result<Recording, CliError> {
    let bytes = text_file::bytes(path, session_file::LARGEST_MIB, ".saute", "a session file")?;
    let opened = Recording::from_file(&bytes).map_err(|error| {
        let text = error.to_string();
        let (message, remedy) = text.split_once("; ").unwrap_or((&text, "name another file"));
        CliError::place(path.display(), message, remedy)
    })?;
    if let Some(damage) = opened.damage {
        let reached_s = opened.recording.moment().time_s();
        stderr::say(format!("warning: {}: {damage}; the session opens up to {reached_s:.1} s", path.display()));
    }
    Ok(opened.recording)
}

/// Returns the cook of a recipe, or of a session that is played again.
pub fn cook(source: Source, data: &DataLibrary) -> Result<Cook, CliError> {
    match source {
        Source::Recipe(recipe) => {
            let file = recipe.file.clone();
            Cook::new(*recipe, &data.library).map_err(|source| CliError::Setup { file, source })
        }
        Source::Session(recording) => play_again(*recording, data),
    }
}

/// Returns the cook that plays a session again; what may make it depart is reported on stderr.
pub fn play_again(recording: Recording, data: &DataLibrary) -> Result<Cook, CliError> {
    let file = recording.beginning().file.clone();
    let difference = recording.beginning().clone();
    let cook = Cook::again(recording, Arc::new(data.library.clone())).map_err(|error| match error {
        ReplayError::Recipe(error) => CliError::Input(error),
        ReplayError::Setup(source) => CliError::Setup { file, source },
        ReplayError::Home(source) => CliError::Setup { file, source: source.into() },
    })?;
    if let Some(words) = difference.difference(cook.runner.recipe(), &data.library) {
        stderr::say(format!("warning: {words}: the replay may depart"));
    }
    Ok(cook)
}
