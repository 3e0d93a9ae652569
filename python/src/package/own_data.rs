//! The library of a kitchen: what the package carries, or that with a folder of the user's files, as the command's `--data`.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use pyo3::prelude::*;
use saute_files::regular_file;
use saute_kitchen::data::library::surface_file;
use saute_kitchen::{Library, OwnFiles};
use saute_schema::LibraryError;

use crate::package::errors;
use crate::package::shelf::library;

/// Folders and files that are read, as by the command.
const FOLDERS: [&str; 7] = ["foods", "pans", "hobs", "recipes", "kinetics", "coatings", "oils"];
const FILES: [&str; 3] = ["doneness.toml", "goals.toml", "kitchen-at-home.toml"];
/// Larger files are not read [MiB] (chosen: those of the command's limits: texts have a few kB, surfaces some MB).
const LARGEST_TEXT_MIB: u64 = 4;
const LARGEST_SURFACE_MIB: u64 = 128;

/// Where foods, pans and scales of a kitchen come from.
#[derive(Clone)]
pub(crate) struct Shelf {
    /// The user's folder.
    pub(crate) folder: Option<PathBuf>,
    pub(crate) library: Arc<Library>,
}

impl Shelf {
    /// Opens the shelf with a user's folder, or the one that the package carries. A broken file is refused with its line.
    pub(crate) fn of(folder: Option<PathBuf>) -> PyResult<Self> {
        Self::with_files(folder).map(|(shelf, _)| shelf)
    }

    /// As [`Self::of`], with the files of the user's folder.
    pub(crate) fn with_files(folder: Option<PathBuf>) -> PyResult<(Self, OwnFiles)> {
        let (library, own) = match &folder {
            Some(dir) => opened(dir)?,
            None => (library()?.clone(), OwnFiles::default()),
        };
        Ok((Self { folder, library }, own))
    }

    /// Returns the file of a recipe of the library for messages: the path of the user's own.
    pub(crate) fn recipe_file(&self, name: &str) -> String {
        let file = format!("recipes/{name}.toml");
        let own = self.folder.as_ref().map(|dir| dir.join(&file)).filter(|path| path.is_file());
        own.map_or(file, |path| path.display().to_string())
    }
}

fn wrong(path: &Path, message: &str) -> PyErr {
    let remedy = "name a folder with foods/, pans/, hobs/, recipes/, kinetics/, coatings/ or oils/ that contain .toml files, or with \
                  doneness.toml, goals.toml or kitchen-at-home.toml";
    errors::argument(format!("{}: {message}", path.display()), remedy.to_owned())
}

fn opened(dir: &Path) -> PyResult<(Arc<Library>, OwnFiles)> {
    if !dir.is_dir() {
        return Err(wrong(dir, "data is no folder"));
    }
    let mut names: Vec<String> = FILES.into_iter().filter(|f| dir.join(f).exists()).map(str::to_owned).collect();
    let folders: Vec<&str> = FOLDERS.into_iter().filter(|folder| dir.join(folder).is_dir()).collect();
    if names.is_empty() && folders.is_empty() {
        return Err(wrong(dir, "data contains none of the folders that are read"));
    }
    for folder in folders {
        names.extend(toml_names(dir, folder)?);
    }
    let texts =
        names.into_iter().map(|name| Ok((name.clone(), text(dir, &dir.join(name))?))).collect::<PyResult<_>>()?;
    let own = OwnFiles { surfaces: surfaces(dir, &texts)?, texts, ..OwnFiles::default() };
    let (library, faults) = Library::with_own(&own).map_err(|error| fault(dir, &error))?;
    match faults.first() {
        Some(error) => Err(fault(dir, error)),
        None => Ok((Arc::new(library), own)),
    }
}

fn fault(dir: &Path, error: &LibraryError) -> PyErr {
    let file = dir.join(&error.file).display().to_string();
    errors::data(error.message.trim(), file, error.line)
}

/// Names of the .toml files in a folder, as `foods/mine.toml`.
fn toml_names(dir: &Path, folder: &str) -> PyResult<Vec<String>> {
    let unreadable = |error: std::io::Error| wrong(&dir.join(folder), &format!("cannot be read: {error}"));
    let entries = std::fs::read_dir(dir.join(folder)).map_err(unreadable)?;
    let names = entries.map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned()));
    let mut names = names.collect::<Result<Vec<String>, _>>().map_err(unreadable)?;
    names.retain(|name| name.ends_with(".toml") && !name.starts_with('.'));
    names.sort();
    Ok(names.into_iter().map(|name| format!("{folder}/{name}")).collect())
}

/// Refuses a file that leads out of the folder, by a link to another place, as the command does.
fn within(dir: &Path, path: &Path) -> PyResult<()> {
    match regular_file::led_out(dir, path) {
        None => Ok(()),
        Some(file) => {
            let message = format!("{}: leads out of data, to {}", path.display(), file.display());
            Err(errors::argument(message, "copy the file into the folder".to_owned()))
        }
    }
}

fn text(dir: &Path, path: &Path) -> PyResult<String> {
    within(dir, path)?;
    regular_file::read_text(path, LARGEST_TEXT_MIB).map_err(|unread| wrong(path, &unread.to_string()))
}

/// Triangles of the surfaces that the foods name.
fn surfaces(dir: &Path, texts: &BTreeMap<String, String>) -> PyResult<BTreeMap<String, saute_surface::Soup>> {
    let foods = texts.iter().filter(|(path, _)| path.starts_with("foods/"));
    let named = foods.filter_map(|(path, text)| Some((path.clone(), surface_file(text)?)));
    named.map(|(path, file)| Ok((path.clone(), surface(dir, &dir.join(path).with_file_name(file))?))).collect()
}

fn surface(dir: &Path, path: &Path) -> PyResult<saute_surface::Soup> {
    within(dir, path)?;
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let bytes = regular_file::read(path, LARGEST_SURFACE_MIB).map_err(|unread| wrong(path, &unread.to_string()))?;
    let beside = |other: &str| regular_file::read_beside(path, other, LARGEST_SURFACE_MIB);
    saute_surface::read(&name, &bytes, beside)
        .map_err(|error| errors::argument(format!("{}: {error}", path.display()), error.remedy))
}
