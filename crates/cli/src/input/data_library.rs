//! The library: the shipped foods, pans and recipes with the files of the `--data` folder.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use saute_files::regular_file;
use saute_kitchen::data::library;
use saute_kitchen::doneness::ScaleChoice;
use saute_kitchen::{Library, OwnFiles};
use saute_schema::LibraryError;

use crate::error::CliError;
use crate::input::{surface_file, text_file};
use crate::output::stderr;

/// Folders that are read in the `--data` folder.
const FOLDERS: [&str; 7] = ["foods", "pans", "hobs", "recipes", "kinetics", "coatings", "oils"];

/// The file of the scales of doneness.
const SCALES: &str = "doneness.toml";
/// Files that are read in the `--data` folder itself.
const FILES: [&str; 3] = [SCALES, "goals.toml", "kitchen-at-home.toml"];

/// Files that are read of one folder [-] (chosen: far more than anybody keeps; a folder of more is a mistake).
const MOST_FILES: usize = 2000;
/// Entries that are looked at in one folder [-] (chosen: it may hold other files besides).
const MOST_ENTRIES: usize = 100_000;
/// Length of all texts [bytes] (chosen: the shipped ones have 0.2 MB).
const MOST_TEXT: usize = 32 << 20;

/// The library, with the list of the files that come from the `--data` folder.
#[derive(Clone, Debug)]
pub struct DataLibrary {
    /// Foods, pans, recipes and scales.
    pub library: Library,
    own: Own,
    files: OwnFiles,
}

/// The user's files: the `--data` folder and the names in it, as `foods/mine.toml`.
#[derive(Clone, Debug, Default)]
struct Own {
    dir: PathBuf,
    names: BTreeSet<String>,
}

impl Own {
    fn of(dir: Option<&Path>, found: &FoundData) -> Self {
        let names = found.own.texts.keys().chain(&found.own.unreadable).cloned().collect();
        Self { dir: dir.map_or_else(PathBuf::new, Path::to_owned), names }
    }

    /// Returns the name of a library file for messages: the full path of a user's file.
    fn place(&self, name: &str) -> String {
        if self.names.contains(name) { self.dir.join(name).display().to_string() } else { name.to_owned() }
    }

    fn error(&self, error: LibraryError) -> CliError {
        CliError::Data { file: self.place(&error.file), line: error.line, message: error.message.trim().to_owned() }
    }
}

/// Files found in the `--data` folder, and the errors of those that cannot be read.
#[derive(Debug, Default)]
struct FoundData {
    own: OwnFiles,
    errors: Vec<CliError>,
    /// Length of all texts [bytes].
    length: usize,
}

impl FoundData {
    /// Adds a text file. One that cannot be read is set aside, and one that leads out of the folder.
    fn add(&mut self, dir: &Path, name: String) {
        let path = dir.join(&name);
        let text = within(dir, &path).and_then(|()| text_file::read(&path));
        match text.and_then(|text| self.has_room(&path, text)) {
            Ok(text) => drop(self.own.texts.insert(name, text)),
            Err(error) => self.set_aside(name, error),
        }
    }

    /// Returns a text that the memory for all of them takes.
    fn has_room(&mut self, path: &Path, text: String) -> Result<String, CliError> {
        self.length += text.len();
        if self.length <= MOST_TEXT {
            return Ok(text);
        }
        self.length -= text.len();
        let message = format!("is one too many: the files of --data have more than {} MiB", MOST_TEXT >> 20);
        Err(CliError::place(path.display(), message, "keep only the files that you use in the folder"))
    }

    /// Adds the surfaces that the foods name. A food whose surface cannot be read is set aside.
    fn add_surfaces(&mut self, dir: &Path) {
        let foods = self.own.texts.iter().filter(|(path, _)| path.starts_with("foods/"));
        let named = foods.filter_map(|(path, text)| Some((path.clone(), library::surface_file(text)?)));
        for (path, file) in named.collect::<Vec<_>>() {
            let surface = dir.join(&path).with_file_name(file);
            let read = || surface_file::read(&surface).map_err(|error| surface_file::refused(&surface, error));
            match within(dir, &surface).and_then(|()| read()) {
                Ok(soup) => drop(self.own.surfaces.insert(path, soup)),
                Err(error) => self.set_aside(path, error),
            }
        }
    }

    fn set_aside(&mut self, name: String, error: CliError) {
        self.own.texts.remove(&name);
        self.own.unreadable.insert(name);
        self.errors.push(error);
    }

    /// Returns the library; names every broken file on stderr, once.
    fn library(self, dir: Option<&Path>) -> Result<DataLibrary, CliError> {
        let own = Own::of(dir, &self);
        let (library, faults) = Library::with_own(&self.own).map_err(|e| own.error(e))?;
        let faults = faults.into_iter().map(|e| own.error(e));
        self.errors.into_iter().chain(faults).for_each(|error| stderr::say(format!("warning: {error}")));
        Ok(DataLibrary { library, own, files: self.own })
    }
}

impl DataLibrary {
    /// Returns the same with another hob; as it is for none.
    pub fn on_hob(&self, id: Option<&str>) -> Result<Cow<'_, Self>, CliError> {
        let Some(id) = id else { return Ok(Cow::Borrowed(self)) };
        let library = self.library.on_hob(id).map_err(|_| {
            let remedy = format!("use one of: {}", Library::names(&self.library.hobs));
            CliError::place(format!("--hob-kind {id}"), self.library.absence("hobs", id, "is not a hob"), remedy)
        })?;
        Ok(Cow::Owned(Self { library: library.into_owned(), ..self.clone() }))
    }

    /// Reads the shipped files and the ones in `dir`, which take precedence. Broken files are named on stderr and set aside.
    pub fn open(dir: Option<&Path>) -> Result<Self, CliError> {
        let mut found = dir.map_or_else(|| Ok(FoundData::default()), read_folders)?;
        dir.into_iter().for_each(|dir| found.add_surfaces(dir));
        found.library(dir)
    }

    /// Returns the scales of doneness with the one with an id chosen.
    pub fn scales(&self, id: &str) -> Result<ScaleChoice, CliError> {
        if self.library.scale(id).is_some() {
            return Ok(ScaleChoice::new(&self.library.scales, id));
        }
        if let Some(cause) = self.library.set_aside(SCALES) {
            return Err(CliError::place(format!("--doneness {id}"), format!("cannot be used: {cause}"), MEND));
        }
        let remedy = format!("use one of: {}", self.library.scale_names());
        Err(CliError::place(format!("--doneness {id}"), "there is no scale of doneness with this id", remedy))
    }

    /// Returns true if the user has files in a `--data` folder, which can break what other files need.
    pub fn has_own_files(&self) -> bool {
        !self.own.names.is_empty()
    }

    /// Returns the user's files.
    pub fn own_files(&self) -> &OwnFiles {
        &self.files
    }

    /// Returns the name of a recipe's file for messages.
    pub fn recipe_place(&self, id: &str) -> String {
        self.own.place(&format!("recipes/{id}.toml"))
    }
}

/// The remedy for an entry whose file is broken.
pub const MEND: &str = "correct that file, or remove it from the --data folder to use the shipped one";

fn read_folders(dir: &Path) -> Result<FoundData, CliError> {
    let remedy = "name a folder with foods/, pans/, hobs/, recipes/, kinetics/, coatings/ or oils/ that contain .toml files, or with doneness.toml, goals.toml or kitchen-at-home.toml";
    if !dir.is_dir() {
        let message = if dir.exists() { "--data is not a folder" } else { "--data does not exist" };
        return Err(CliError::place(dir.display(), message, remedy));
    }
    let present: Vec<&str> = FOLDERS.into_iter().filter(|f| dir.join(f).is_dir()).collect();
    let mut found = FoundData::default();
    let files: Vec<&str> = FILES.into_iter().filter(|file| dir.join(file).exists()).collect();
    files.iter().for_each(|file| found.add(dir, (*file).to_owned()));
    if files.is_empty() && present.is_empty() {
        return Err(CliError::place(dir.display(), "--data contains none of the folders that are read", remedy));
    }
    for folder in present {
        for name in toml_names(&dir.join(folder))? {
            found.add(dir, format!("{folder}/{name}"));
        }
    }
    Ok(found)
}

/// Refuses a file that leads out of the folder, by a link to another place.
fn within(dir: &Path, path: &Path) -> Result<(), CliError> {
    // What cannot be followed is named where it is read.
    let Some(file) = regular_file::led_out(dir, path) else { return Ok(()) };
    let message = format!("leads out of --data, to {}", file.display());
    Err(CliError::place(path.display(), message, "copy the file into the folder"))
}

/// Returns a library with the kinetics that a food can name: the shipped ones and the ones in a folder.
pub fn kinetics(dir: Option<&Path>) -> Result<Library, CliError> {
    let mut found = FoundData::default();
    if let Some((dir, folder)) = dir.map(|d| (d, d.join("kinetics"))).filter(|(_, f)| f.is_dir()) {
        for name in toml_names(&folder)? {
            found.add(dir, format!("kinetics/{name}"));
        }
    }
    Ok(found.library(dir)?.library)
}

/// Returns the names of the .toml files in a folder, sorted.
fn toml_names(folder: &Path) -> Result<Vec<String>, CliError> {
    let unreadable = |e: std::io::Error| {
        CliError::place(folder.display(), format!("cannot be read: {e}"), "check the folder's permissions")
    };
    let too_many = || {
        let message =
            format!("holds more than {MOST_FILES} .toml files, or more than {MOST_ENTRIES} files of all kinds");
        CliError::place(folder.display(), message, "keep only the files that you use in the folder")
    };
    let mut names = Vec::new();
    for (count, entry) in std::fs::read_dir(folder).map_err(unreadable)?.enumerate() {
        let name = entry.map_err(unreadable)?.file_name();
        if count == MOST_ENTRIES || names.len() > MOST_FILES {
            return Err(too_many());
        }
        let Some(name) = name.to_str() else { continue };
        if name.ends_with(".toml") && !name.starts_with('.') {
            names.push(name.to_owned());
        }
    }
    names.sort();
    Ok(names)
}
