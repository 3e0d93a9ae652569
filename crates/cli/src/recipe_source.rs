//! Finds a recipe: a file, or a shipped one by its id.

use std::path::Path;

use saute_kitchen::Library;
use saute_recipe::Recipe;

use crate::error::CliError;
use crate::shelf::Shelf;
use crate::text_file;

/// Reads and checks the recipe of that path or id. A file goes before an id of the same name.
pub fn load(name: &str, shelf: &Shelf) -> Result<Recipe, CliError> {
    let path = Path::new(name);
    let text = match shelf.library.recipes.get(name) {
        Some(text) if !path.is_file() => return parse(text, &shelf.recipe_place(name), shelf),
        _ if path.exists() => text_file::read(path)?,
        _ => return Err(not_found(name, shelf)),
    };
    parse(&text, name, shelf)
}

fn parse(text: &str, place: &str, shelf: &Shelf) -> Result<Recipe, CliError> {
    Ok(Recipe::parse(text, place, &shelf.library)?)
}

fn not_found(name: &str, shelf: &Shelf) -> CliError {
    let remedy = format!("name a .toml file or one of the shipped recipes: {}", Library::names(&shelf.library.recipes));
    CliError::place(name, "there is no such file and no recipe of that id", remedy)
}
