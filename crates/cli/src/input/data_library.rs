//! The library: the shipped foods, pans and recipes with the files of the `--data` folder.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use saute_kitchen::data::library;
use saute_kitchen::doneness::ScaleChoice;
use saute_kitchen::heat::Soup;
use saute_kitchen::{Library, LibraryError};

use crate::error::CliError;
use crate::input::{surface_file, text_file};

/// Folders that are read in the `--data` folder.
const FOLDERS: [&str; 6] = ["foods", "pans", "recipes", "kinetics", "coatings", "oils"];

/// File that is read in the `--data` folder itself: the scales of doneness.
const FILE: &str = "doneness.toml";

/// The library, with the list of the files that come from the `--data` folder.
#[derive(Debug)]
pub struct DataLibrary {
    /// Foods, pans, recipes and scales.
    pub library: Library,
    own: Own,
}

/// The user's files: the `--data` folder and the names in it, as `foods/mine.toml`.
#[derive(Debug, Default)]
struct Own {
    dir: PathBuf,
    names: BTreeSet<String>,
}

impl Own {
    /// Returns the name of a library file for messages: the full path of a user's file.
    fn place(&self, name: &str) -> String {
        if self.names.contains(name) { self.dir.join(name).display().to_string() } else { name.to_owned() }
    }

    fn error(&self, error: LibraryError) -> CliError {
        CliError::Data { file: self.place(&error.file), line: error.line, message: error.message.trim().to_owned() }
    }
}

impl DataLibrary {
    /// Reads the shipped files and the ones in `dir`, which take precedence.
    pub fn open(dir: Option<&Path>) -> Result<Self, CliError> {
        let files = dir.map_or(Ok(Vec::new()), read_folders)?;
        let names = files.iter().map(|(name, _)| name.clone()).collect();
        let own = Own { dir: dir.map_or_else(PathBuf::new, Path::to_owned), names };
        let surfaces = dir.map_or(Ok(BTreeMap::new()), |dir| surfaces(dir, &files))?;
        let library = Library::with_surfaces(&files, &surfaces).map_err(|e| own.error(e))?;
        Ok(Self { library, own })
    }

    /// Returns the scales of doneness with the one with an id chosen.
    pub fn scales(&self, id: &str) -> Result<ScaleChoice, CliError> {
        if self.library.scale(id).is_some() {
            return Ok(ScaleChoice::new(&self.library.scales, id));
        }
        let remedy = format!("use one of: {}", self.library.scale_names());
        Err(CliError::place(format!("--doneness {id}"), "there is no scale of doneness with this id", remedy))
    }

    /// Returns the name of a recipe's file for messages.
    pub fn recipe_place(&self, id: &str) -> String {
        self.own.place(&format!("recipes/{id}.toml"))
    }
}

fn read_folders(dir: &Path) -> Result<Vec<(String, String)>, CliError> {
    let remedy = "name a folder with foods/, pans/, recipes/, kinetics/, coatings/ or oils/ that contain .toml files, or with doneness.toml";
    if !dir.is_dir() {
        let message = if dir.exists() { "--data is not a folder" } else { "--data does not exist" };
        return Err(CliError::place(dir.display(), message, remedy));
    }
    let present: Vec<&str> = FOLDERS.into_iter().filter(|f| dir.join(f).is_dir()).collect();
    let mut files = Vec::new();
    if dir.join(FILE).is_file() {
        files.push((FILE.to_owned(), text_file::read(&dir.join(FILE))?));
    }
    if present.is_empty() && files.is_empty() {
        return Err(CliError::place(dir.display(), "--data contains none of the folders that are read", remedy));
    }
    for folder in present {
        for name in toml_names(&dir.join(folder))? {
            files.push((format!("{folder}/{name}"), text_file::read(&dir.join(folder).join(&name))?));
        }
    }
    Ok(files)
}

/// Returns the surfaces that the food files name, by the path of the food file.
fn surfaces(dir: &Path, files: &[(String, String)]) -> Result<BTreeMap<String, Soup>, CliError> {
    let foods = files.iter().filter(|(path, _)| path.starts_with("foods/"));
    let named = foods.filter_map(|(path, text)| Some((path, library::surface_file(text)?)));
    named.map(|(path, file)| Ok((path.clone(), surface_file::read(&dir.join(path).with_file_name(file))?))).collect()
}

/// Returns a library with the kinetics that a food can name: the shipped ones and the ones in a folder.
pub fn kinetics(dir: Option<&Path>) -> Result<Library, CliError> {
    let folder = dir.map(|d| d.join("kinetics")).filter(|f| f.is_dir());
    let mut files = Vec::new();
    for name in folder.as_deref().map_or(Ok(Vec::new()), toml_names)? {
        let path = folder.as_deref().unwrap_or(Path::new("")).join(&name);
        files.push((format!("kinetics/{name}"), text_file::read(&path)?));
    }
    let own =
        Own { dir: dir.map_or_else(PathBuf::new, Path::to_owned), names: files.iter().map(|f| f.0.clone()).collect() };
    Library::with(&files).map_err(|e| own.error(e))
}

/// Returns the names of the .toml files in a folder, sorted.
fn toml_names(folder: &Path) -> Result<Vec<String>, CliError> {
    let unreadable = |e: std::io::Error| {
        CliError::place(folder.display(), format!("cannot be read: {e}"), "check the folder's permissions")
    };
    let mut names = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(unreadable)? {
        let name = entry.map_err(unreadable)?.file_name();
        let Some(name) = name.to_str() else { continue };
        if name.ends_with(".toml") && !name.starts_with('.') {
            names.push(name.to_owned());
        }
    }
    names.sort();
    Ok(names)
}
