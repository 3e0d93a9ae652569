//! A recipe from Python: a dict, the text of a recipe file, the path of one, or the name of a shipped one.

use std::path::{Path, PathBuf};

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};
use saute_files::regular_file;
use saute_kitchen::Library;
use saute_recipe::Recipe;

use crate::package::errors;
use crate::package::expected::type_name;
use crate::package::own_data::Shelf;
use crate::package::shelf::library;

/// Larger files are not read [MiB] (chosen: recipes have a few kB).
const LARGEST_MIB: u64 = 4;

/// A key of a table and its value.
pub(crate) type Part<'a, 'py> = (&'a str, Bound<'py, PyAny>);

/// The text of a recipe.
pub(crate) struct Source {
    text: String,
    file: String,
    /// False for a dict, whose lines nobody has seen.
    pub(crate) has_lines: bool,
}

impl Source {
    /// Finds the text of the argument for a recipe.
    pub(crate) fn of(recipe: &Bound<'_, PyAny>) -> PyResult<Self> {
        if let Ok(dict) = recipe.cast::<PyDict>() {
            return Self::of_dict(dict);
        }
        if let Ok(text) = recipe.cast::<PyString>() {
            return Self::of_words(&text.to_cow()?);
        }
        match recipe.extract::<PathBuf>() {
            Ok(path) => Self::of_path(&path),
            Err(_) => Err(PyTypeError::new_err(format!(
                "recipe must be a dict, the text of a recipe in TOML, a path, or one of: {}; not {}",
                Library::names(&library()?.recipes),
                type_name(recipe)
            ))),
        }
    }

    fn of_dict(dict: &Bound<'_, PyDict>) -> PyResult<Self> {
        let arguments = PyDict::new(dict.py());
        arguments.set_item("default", dict.py().import("saute._plain")?.getattr("plain")?)?;
        let json = dict.py().import("json")?.getattr("dumps")?.call((dict,), Some(&arguments))?;
        let remedy = || "write what a recipe file has: text, numbers, true or false, lists and dicts".to_owned();
        let value: serde_json::Value = serde_json::from_str(&json.extract::<String>()?)
            .map_err(|error| errors::argument(format!("the dict is no recipe: {error}"), remedy()))?;
        let text = toml::to_string(&value)
            .map_err(|error| errors::argument(format!("the dict is no recipe: {error}"), remedy()))?;
        Ok(Self { text, file: "<dict>".to_owned(), has_lines: false })
    }

    /// A recipe without steps: a pan, and a food where one is given; a value that is None is left out.
    pub(crate) fn of_parts(
        py: Python<'_>,
        hob: Option<&[Part<'_, '_>]>,
        pan: &[Part<'_, '_>],
        food: Option<&[Part<'_, '_>]>,
    ) -> PyResult<Self> {
        let table = |parts: &[Part<'_, '_>]| {
            let table = PyDict::new(py);
            let mut given = parts.iter().filter(|(_, value)| !value.is_none());
            given.try_for_each(|(key, value)| table.set_item(key, value))?;
            Ok::<_, PyErr>(table)
        };
        let recipe = PyDict::new(py);
        if let Some(hob) = hob {
            recipe.set_item("hob", table(hob)?)?;
        }
        recipe.set_item("pan", table(pan)?)?;
        if let Some(food) = food {
            recipe.set_item("food", [table(food)?])?;
        }
        Self::of_dict(&recipe)
    }

    /// Text with a line end or an equals sign is a recipe; else a file goes before a name of the library, as in the command.
    pub(crate) fn of_words(words: &str) -> PyResult<Self> {
        if words.contains(['\n', '=']) {
            return Ok(Self { text: words.to_owned(), file: "<text>".to_owned(), has_lines: true });
        }
        let (path, shipped) = (Path::new(words), library()?.recipes.get(words));
        match shipped {
            Some(text) if !path.is_file() => {
                Ok(Self { text: text.clone(), file: format!("recipes/{words}.toml"), has_lines: true })
            }
            _ => Self::of_path(path),
        }
    }

    pub(crate) fn of_path(path: &Path) -> PyResult<Self> {
        let file = path.display().to_string();
        let known = || Library::names(&library().map(|l| l.recipes.clone()).unwrap_or_default());
        if !path.exists() {
            let remedy = format!("name a .toml file or one of the shipped recipes: {}", known());
            return Err(errors::argument(
                format!("{file}: there is no such file and no recipe with this name"),
                remedy,
            ));
        }
        let text = regular_file::read_text(path, LARGEST_MIB).map_err(|unread| {
            errors::argument(format!("{file}: {unread}"), "name a recipe file, which is text".to_owned())
        })?;
        Ok(Self { text, file, has_lines: true })
    }

    /// As [`Self::of`], with the names of a shelf that has a user's recipes too.
    pub(crate) fn among(recipe: &Bound<'_, PyAny>, shelf: &Shelf) -> PyResult<Self> {
        let name = recipe.extract::<String>().ok();
        name.and_then(|name| Self::on_shelf(&name, shelf)).map_or_else(|| Self::of(recipe), Ok)
    }

    /// As [`Self::of_words`], with the names of a shelf that has a user's recipes too.
    pub(crate) fn of_words_among(words: &str, shelf: &Shelf) -> PyResult<Self> {
        Self::on_shelf(words, shelf).map_or_else(|| Self::of_words(words), Ok)
    }

    /// A recipe by its name, unless there is a file of that name.
    fn on_shelf(name: &str, shelf: &Shelf) -> Option<Self> {
        let text = shelf.library.recipes.get(name).filter(|_| !Path::new(name).is_file())?;
        Some(Self { text: text.clone(), file: shelf.recipe_file(name), has_lines: true })
    }

    /// Reads and checks the recipe, with the foods of a library.
    pub(crate) fn recipe(&self, library: &Library) -> PyResult<Recipe> {
        Recipe::parse(&self.text, &self.file, library).map_err(|error| errors::input(error, self))
    }

    /// The text.
    pub(crate) fn text(&self) -> &str {
        &self.text
    }

    /// Name of the file for messages.
    pub(crate) fn file(&self) -> &str {
        &self.file
    }

    /// The recipe with an end, where it has no step: a kitchen needs none.
    pub(crate) fn with_end(mut self) -> Self {
        let lacks_steps = toml::from_str::<toml::Table>(&self.text).is_ok_and(|table| !table.contains_key("step"));
        if lacks_steps {
            self.text.push_str("\n[[step]]\nend = true\n");
        }
        self
    }

    /// The key on a line, with the tables that it is in, as `food[0].size_mm`; none on a line without one.
    pub(crate) fn key_at(&self, line: usize) -> Option<String> {
        let lines: Vec<&str> = self.text.lines().take(line).map(str::trim).collect();
        let last = lines.last()?;
        let table = lines.iter().rposition(|l| l.starts_with('[') && l.trim_end_matches('#').contains(']'));
        let path = table.map(|at| table_name(&lines, at));
        let key = last.split_once('=').map(|(key, _)| key.trim().to_owned()).filter(|_| !last.starts_with(['[', '#']));
        match (path, key) {
            (Some(path), Some(key)) => Some(format!("{path}.{key}")),
            (path, key) => key.or(path),
        }
    }
}

/// The name of the table whose header is on a line; entries of a list have their index.
fn table_name(lines: &[&str], at: usize) -> String {
    let name = |line: &str| line.trim_start_matches('[').split(']').next().unwrap_or_default().trim().to_owned();
    let own = name(lines[at]);
    if !lines[at].starts_with("[[") {
        return own;
    }
    let before = lines[..at].iter().filter(|l| l.starts_with("[[") && name(l) == own).count();
    format!("{own}[{before}]")
}
