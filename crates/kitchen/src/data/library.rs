//! Foods, pans and recipes: those in the program, and those from a folder of the user's.

use std::collections::BTreeMap;
use std::sync::Arc;

use include_dir::{Dir, include_dir};
use saute_food::components::Components;
use saute_food::{FoodDescription, Kinetics, Scale};
use saute_heat::mesh::surface::EXTENT;
use saute_heat::{Soup, Surface};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::data::data_file::DataFile;
use crate::data::format::{Format, FormatSchema};
use crate::data::room::Room;
use crate::liquids::fond::FondData;
use crate::liquids::oil::OilDescription;
use crate::pan::hob::HobDescription;
use crate::pan::pan_description::{CoatingDescription, PanDescription};

/// The file of the scales of doneness.
const DONENESS_FILE: &str = "doneness.toml";

/// The file of what juice leaves on the pan.
const FOND_FILE: &str = "fond.toml";

static DATA: Dir = include_dir!("$CARGO_MANIFEST_DIR/../../data");
static RECIPES: Dir = include_dir!("$CARGO_MANIFEST_DIR/../../recipes");

/// A data file that cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{file}:{line}: {message}")]
pub struct LibraryError {
    /// Which file.
    pub file: String,
    /// Line, from 1.
    pub line: usize,
    /// What is wrong and what to write instead.
    pub message: String,
}

/// The scale that every summary reports and that is chosen unless another is named.
pub const DEFAULT_SCALE: &str = "paper-2013";

/// `doneness.toml` as it is written.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "saute doneness")]
pub(crate) struct DonenessFile {
    /// Scales.
    pub(crate) scale: Vec<Scale>,
}

/// How far a body may be scaled where its file does not say [-] (chosen: a small one and a large one of a kind).
const LEAST_SCALE: f64 = 0.5;
const MOST_SCALE: f64 = 2.0;

/// Everything a kitchen can be built from.
#[derive(Clone, Debug)]
pub struct Library {
    /// Foods by id.
    pub foods: BTreeMap<String, FoodDescription>,
    /// Kinetics by id.
    pub kinetics: BTreeMap<String, Kinetics>,
    /// Pans by id, coated ones included.
    pub pans: BTreeMap<String, PanDescription>,
    /// Kinds of oil and fat by id.
    pub oils: BTreeMap<String, OilDescription>,
    /// Recipes by id: their text.
    pub recipes: BTreeMap<String, String>,
    /// Scales of doneness, in the order of their file; [`DEFAULT_SCALE`] is one of them.
    pub scales: Vec<Arc<Scale>>,
    /// Thermal properties of food components.
    pub components: Components,
    /// The room.
    pub room: Room,
    /// The hob.
    pub hob: HobDescription,
    /// What juice leaves on the pan.
    pub fond: FondData,
}

impl Library {
    /// What the program carries.
    pub fn embedded() -> Result<Self, LibraryError> {
        Self::with(&[])
    }

    /// What the program carries, with files of the user's added or put in place of its own.
    ///
    /// Each entry is a path like `foods/my-steak.toml`, `pans/…`, `recipes/…`, `kinetics/…` or `doneness.toml`, and its
    /// text.
    pub fn with(own: &[(String, String)]) -> Result<Self, LibraryError> {
        Self::with_surfaces(own, &BTreeMap::new())
    }

    /// As [`Self::with`], with the triangles of the surfaces that foods name, by the path of the food's file.
    pub fn with_surfaces(own: &[(String, String)], surfaces: &BTreeMap<String, Soup>) -> Result<Self, LibraryError> {
        let mut files: BTreeMap<String, String> = BTreeMap::new();
        collect(&DATA, "", &mut files);
        collect(&RECIPES, "recipes/", &mut files);
        files.extend(own.iter().cloned());
        let bare = parse_folder(&files, "pans/")?;
        let coatings: BTreeMap<String, CoatingDescription> = parse_folder(&files, "coatings/")?;
        let mut library = Self {
            foods: parse_folder(&files, "foods/")?,
            kinetics: parse_folder(&files, "kinetics/")?,
            pans: with_coatings(bare, &coatings),
            oils: parse_folder(&files, "oils/")?,
            recipes: in_folder(&files, "recipes/").map(|(id, text)| (id.to_owned(), text.clone())).collect(),
            scales: scales(&files)?,
            components: parse(&files, "components.toml")?,
            room: parse(&files, "kitchen.toml")?,
            hob: parse(&files, "hobs/induction.toml")?,
            fond: parse(&files, FOND_FILE)?,
        };
        for (id, food) in std::mem::take(&mut library.foods) {
            let file = format!("foods/{id}.toml");
            let food = with_body(food, surfaces.get(&file), &data_file(&files, &file))?;
            library.foods.insert(id, food);
        }
        for (id, food) in &library.foods {
            let file = format!("foods/{id}.toml");
            library.check_kinetics(food, &data_file(&files, &file))?;
        }
        library.check_oils()?;
        library.check_scales(&data_file(&files, DONENESS_FILE))?;
        Ok(library)
    }

    /// Checks that a food's kinetics are there and change what the food colours.
    pub(crate) fn check_kinetics(&self, food: &FoodDescription, file: &DataFile) -> Result<(), LibraryError> {
        let Some(kinetics) = self.kinetics.get(&food.kinetics) else {
            let known = Self::names(&self.kinetics);
            let message = format!("kinetics = \"{}\" is unknown; there are: {known}", food.kinetics);
            return Err(file.error("kinetics", message));
        };
        let named = kinetics.in_order("colour", &food.colour.change);
        named.map(|_| ()).map_err(|e| file.error("colour.change", e.to_string()))
    }

    /// Scales are made for kinetics that are there and contain their change.
    fn check_scales(&self, file: &DataFile) -> Result<(), LibraryError> {
        for (at, scale) in self.scales.iter().enumerate() {
            let error = |message| Err(file.error(&format!("scale.{at}.for_kinetics"), message));
            for id in &scale.for_kinetics {
                let Some(kinetics) = self.kinetics.get(id) else {
                    let known = Self::names(&self.kinetics);
                    return error(format!("for_kinetics names \"{id}\", which is unknown; there are: {known}"));
                };
                if !scale.applies_to(kinetics) {
                    let (change, known) = (&scale.for_change, kinetics.names().join(", "));
                    return error(format!(
                        "for_kinetics names \"{id}\", which has no change \"{change}\": write one of its changes as \
                         for_change ({known}), or leave it out of for_kinetics"
                    ));
                }
            }
        }
        Ok(())
    }

    /// The kitchen names oils that are there, and butter that melts.
    fn check_oils(&self) -> Result<(), LibraryError> {
        let oil = &self.room.oil;
        let error = |message| Err(LibraryError { file: "kitchen.toml".into(), line: 1, message });
        for (key, id) in [("default", &oil.default), ("rendered", &oil.rendered), ("butter", &oil.butter)] {
            let Some(kind) = self.oils.get(id) else {
                return error(format!("[oil] {key} = \"{id}\" is unknown; there are: {}", Self::names(&self.oils)));
            };
            if key == "butter" && kind.emulsion.is_none() {
                return error(format!("[oil] butter = \"{id}\" has no [emulsion]: name an oil that has one"));
            }
        }
        Ok(())
    }

    /// A scale of doneness by its id.
    pub fn scale(&self, id: &str) -> Option<&Arc<Scale>> {
        self.scales.iter().find(|s| s.id == id)
    }

    /// The ids of the scales, for messages.
    pub fn scale_names(&self) -> String {
        self.scales.iter().map(|s| s.id.as_str()).collect::<Vec<_>>().join(", ")
    }

    /// The ids of a table, for messages.
    pub fn names<T>(table: &BTreeMap<String, T>) -> String {
        table.keys().map(String::as_str).collect::<Vec<_>>().join(", ")
    }

    /// Every data file that the program carries, for tests of the data itself.
    pub fn embedded_files() -> BTreeMap<String, String> {
        let mut files = BTreeMap::new();
        collect(&DATA, "", &mut files);
        files
    }
}

fn collect(dir: &Dir, prefix: &str, files: &mut BTreeMap<String, String>) {
    for file in dir.files() {
        if let Some(text) = file.contents_utf8() {
            files.insert(format!("{prefix}{}", file.path().display()).replace('\\', "/"), text.to_owned());
        }
    }
    dir.dirs().for_each(|sub| collect(sub, prefix, files));
}

fn in_folder<'a>(files: &'a BTreeMap<String, String>, folder: &'a str) -> impl Iterator<Item = (&'a str, &'a String)> {
    files.iter().filter_map(move |(path, text)| Some((path.strip_prefix(folder)?.strip_suffix(".toml")?, text)))
}

fn data_file<'a>(files: &'a BTreeMap<String, String>, name: &'a str) -> DataFile<'a> {
    DataFile { name, text: files.get(name).map_or("", String::as_str) }
}

/// Reads and checks every file of a folder, by id.
fn parse_folder<T: Format>(
    files: &BTreeMap<String, String>,
    folder: &str,
) -> Result<BTreeMap<String, T>, LibraryError> {
    let format = FormatSchema::of::<T>();
    in_folder(files, folder)
        .map(|(id, text)| {
            let name = format!("{folder}{id}.toml");
            Ok((id.to_owned(), format.read(&DataFile { name: &name, text })?))
        })
        .collect()
}

fn scales(files: &BTreeMap<String, String>) -> Result<Vec<Arc<Scale>>, LibraryError> {
    let parsed: DonenessFile = parse(files, DONENESS_FILE)?;
    Ok(parsed.scale.into_iter().map(Arc::new).collect())
}

fn parse<T: Format>(files: &BTreeMap<String, String>, path: &str) -> Result<T, LibraryError> {
    FormatSchema::of::<T>().read(&data_file(files, path))
}

/// Line number, from 1, of a byte offset.
pub fn line_of(text: &str, offset: usize) -> usize {
    1 + text.as_bytes()[..offset.min(text.len())].iter().filter(|&&b| b == b'\n').count()
}

/// The surface file that a food's text names, where it names one.
pub fn surface_file(text: &str) -> Option<String> {
    let parsed: toml::Table = text.parse().ok()?;
    Some(parsed.get("mesh")?.as_table()?.get("file")?.as_str()?.to_owned())
}

/// A food with the body that its surface encloses, and with the sizes of that unless its file gives others.
pub(crate) fn with_body(
    mut food: FoodDescription,
    soup: Option<&Soup>,
    file: &DataFile,
) -> Result<FoodDescription, LibraryError> {
    let Some(mesh) = food.mesh.clone() else { return Ok(food) };
    let error = |message: String| file.error("mesh.file", message);
    let soup = soup.ok_or_else(|| error(format!("the surface \"{}\" was not read", mesh.file)))?;
    let surface = close_surface(soup, &mesh.file, mesh.scale_mm).map_err(error)?;
    if !food.size.is_set() {
        let longest = 1e3 * surface.extent().into_iter().fold(0.0, f64::max);
        food.size.default_mm = vec![longest];
        food.size.min_mm = vec![(LEAST_SCALE * longest).max(1e3 * EXTENT[0])];
        food.size.max_mm = vec![(MOST_SCALE * longest).min(1e3 * EXTENT[1])];
        food.size.source = format!("as in {}", mesh.file);
    }
    food.body = Some(Arc::new(surface));
    Ok(food)
}

/// Closes the triangles of a surface file, given the millimetres in one of its units; else says what is wrong and what
/// to do.
pub fn close_surface(soup: &Soup, name: &str, scale_mm: Option<f64>) -> Result<Surface, String> {
    Surface::close(soup, 1e-3 * scale_mm.unwrap_or(soup.unit_mm))
        .map_err(|defect| format!("{name} is not sound: {defect}; {}", defect.remedy()))
}

fn with_coatings(
    bare: BTreeMap<String, PanDescription>,
    coatings: &BTreeMap<String, CoatingDescription>,
) -> BTreeMap<String, PanDescription> {
    let mut pans = bare.clone();
    for (id, pan) in &bare {
        for (coating_id, coating) in coatings {
            let mut coated = pan.clone();
            coated.name = format!("{}, {}", pan.name, coating.name);
            coated.coating_w_m2k = Some(coating.conductance_w_m2k);
            coated.surface.emissivity = coating.emissivity;
            coated.look = coating.look.clone();
            coated.heat_tint = coating.heat_tint.clone();
            pans.entry(format!("{id}-{coating_id}")).or_insert(coated);
        }
    }
    pans
}
