//! The shipped files, each read and checked once in a process.
//!
//! A library with files of the user's reads only those again.

use std::collections::BTreeMap;
use std::sync::{LazyLock, OnceLock};

use include_dir::{Dir, File, include_dir};
use saute_food::components::Components;
use saute_food::{FoodDescription, Kinetics};

use crate::data::at_home::KitchenAtHome;
use crate::data::goals::GoalsFile;
use crate::data::library::DonenessFile;
use crate::data::room::Room;
use crate::liquids::fond::FondData;
use crate::liquids::oil::OilDescription;
use crate::pan::hob::HobDescription;
use crate::pan::pan_description::{CoatingDescription, PanDescription};
use saute_schema::{DataFile, Format, FormatSchema, LibraryError};

static DATA: Dir = include_dir!("$CARGO_MANIFEST_DIR/../../data");
static RECIPES: Dir = include_dir!("$CARGO_MANIFEST_DIR/../../recipes");

/// The format of one kind of file, and the shipped files of that kind by path.
pub(crate) struct Shelf<T: 'static> {
    format: FormatSchema,
    read: BTreeMap<String, Result<T, LibraryError>>,
}

impl<T: Format + Clone + 'static> Shelf<T> {
    /// Reads the shipped files whose path begins with a text.
    fn of(start: &str) -> Self {
        let format = FormatSchema::of::<T>();
        let own = shipped_files().iter().filter(|(path, _)| path.starts_with(start));
        let read = own.map(|(path, text)| (path.clone(), format.read(&DataFile { name: path, text }))).collect();
        Self { format, read }
    }

    /// Reads and checks a file; one that is as shipped was read before.
    pub(crate) fn read(&self, file: &DataFile) -> Result<T, LibraryError> {
        match self.read.get(file.name) {
            Some(read) if shipped_files().get(file.name).is_some_and(|text| text == file.text) => read.clone(),
            _ => self.format.read(file),
        }
    }
}

/// A kind of file that the program ships.
pub(crate) trait Shelved: Format + Clone + 'static {
    /// Returns the shelf of this kind.
    fn shelf() -> &'static Shelf<Self>;
}

/// States where the shipped files of each kind are.
macro_rules! shelves {
    ($($kind:ty: $start:literal,)*) => {
        $(impl Shelved for $kind {
            fn shelf() -> &'static Shelf<Self> {
                static SHELF: OnceLock<Shelf<$kind>> = OnceLock::new();
                SHELF.get_or_init(|| Shelf::of($start))
            }
        })*
    };
}

shelves! {
    FoodDescription: "foods/",
    Kinetics: "kinetics/",
    PanDescription: "pans/",
    CoatingDescription: "coatings/",
    OilDescription: "oils/",
    HobDescription: "hobs/",
    DonenessFile: "doneness.toml",
    GoalsFile: "goals.toml",
    Components: "components.toml",
    Room: "kitchen.toml",
    KitchenAtHome: "kitchen-at-home.toml",
    FondData: "fond.toml",
}

/// Returns every data file and every recipe that the program carries, by path.
pub(crate) fn shipped_files() -> &'static BTreeMap<String, String> {
    static FILES: LazyLock<BTreeMap<String, String>> = LazyLock::new(|| {
        let mut files = data_files();
        collect(&RECIPES, "recipes/", &mut files);
        files
    });
    &FILES
}

/// Returns every data file that the program carries, by path.
pub(crate) fn data_files() -> BTreeMap<String, String> {
    let mut files = BTreeMap::new();
    collect(&DATA, "", &mut files);
    files
}

/// Returns the picture of a shipped food, which is next to its file; none for a food that the program does not ship.
pub(crate) fn food_picture(id: &str) -> Option<&'static [u8]> {
    DATA.get_file(format!("foods/{id}.png")).map(File::contents)
}

fn collect(dir: &Dir, prefix: &str, files: &mut BTreeMap<String, String>) {
    for file in dir.files() {
        if let Some(text) = file.contents_utf8() {
            files.insert(format!("{prefix}{}", file.path().display()).replace('\\', "/"), text.to_owned());
        }
    }
    dir.dirs().for_each(|sub| collect(sub, prefix, files));
}
