//! A recipe by the path of its file or by its id in the library.

use std::path::Path;

use saute_kitchen::Library;
use saute_recipe::Recipe;

use crate::error::CliError;
use crate::input::data_library::{DataLibrary, MEND};
use crate::input::{session_source, text_file};

/// Reads and checks the recipe with a path or an id. A file takes precedence over an id of the same name.
pub fn load(name: &str, data: &DataLibrary) -> Result<Recipe, CliError> {
    let (text, place) = text(name, data)?;
    Ok(Recipe::parse(&text, &place, &data.library)?)
}

/// Returns the text of the recipe with a path or an id, and its place for messages.
pub fn text(name: &str, data: &DataLibrary) -> Result<(String, String), CliError> {
    let path = Path::new(name);
    if session_source::is_session(path) {
        return Err(CliError::place(name, "is a recorded session, not a recipe", "play it again with: saute replay"));
    }
    match data.library.recipes.get(name) {
        Some(text) if !path.is_file() => Ok((text.clone(), data.recipe_place(name))),
        _ if path.exists() => Ok((text_file::read(path)?, name.to_owned())),
        _ => Err(not_found(name, data)),
    }
}

fn not_found(name: &str, data: &DataLibrary) -> CliError {
    if let Some(cause) = data.library.set_aside(&format!("recipes/{name}.toml")) {
        return CliError::place(name, format!("cannot be used: {cause}"), MEND);
    }
    let remedy = format!("name a .toml file or one of the shipped recipes: {}", Library::names(&data.library.recipes));
    CliError::place(name, "there is no such file and no recipe with this id", remedy)
}
