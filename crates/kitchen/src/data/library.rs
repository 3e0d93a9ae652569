//! Foods, pans and recipes: those in the program, and those from a folder of the user's.

use std::collections::BTreeMap;
use std::sync::Arc;

use saute_food::components::Components;
use saute_food::{FoodDescription, Kinetics, Scale};
use saute_heat::mesh::surface::EXTENT;
use saute_heat::{Soup, Surface};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::data::at_home::KitchenAtHome;
use crate::data::goals::GoalDescription;
use crate::data::loading::{Loading, OwnFiles};
use crate::data::relations::scale_fault;
use crate::data::room::Room;
use crate::data::shelf::{data_files, food_picture};
use crate::liquids::fond::FondData;
use crate::liquids::oil::OilDescription;
use crate::pan::hob::HobDescription;
use crate::pan::pan_description::PanDescription;
use saute_schema::{DataFile, LibraryError};

/// The scale that every summary reports and that is chosen unless another is named.
pub const DEFAULT_SCALE: &str = "paper-2013";

/// `doneness.toml` as it is written.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "saute doneness")]
pub(crate) struct DonenessFile {
    /// Scales.
    pub(crate) scale: Vec<Scale>,
}

/// How far a body may be scaled where its file does not state it [-] (chosen: a small one and a large one of a kind).
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
    /// Goals of a cook, in the order of their file.
    pub goals: Vec<Arc<GoalDescription>>,
    /// Thermal properties of food components.
    pub components: Components,
    /// The room.
    pub room: Room,
    /// Hobs by id, as their files describe them.
    pub hobs: BTreeMap<String, HobDescription>,
    /// The hob that is cooked on, as it is at home.
    pub hob: HobDescription,
    /// What a kitchen at home has otherwise; hob and room contain it already.
    pub at_home: KitchenAtHome,
    /// The text of the file that states it, unless it is the program's own.
    pub(crate) home: Option<Arc<str>>,
    /// The room without it.
    pub(crate) typical: Arc<Room>,
    /// What juice leaves on the pan.
    pub fond: FondData,
    /// Entries that are not in the tables because a file of the user's is broken, by path: the cause.
    pub(crate) set_aside: BTreeMap<String, String>,
    /// Hash of every data file, by path.
    pub(crate) hashes: BTreeMap<String, u64>,
}

impl Library {
    /// What the program carries.
    pub fn embedded() -> Result<Self, LibraryError> {
        Self::with(&[])
    }

    /// What the program carries, with files of the user added or in their place.
    ///
    /// Each entry is a path like `foods/my-steak.toml`, `pans/…`, `recipes/…`, `kinetics/…` or `doneness.toml`, and its
    /// text.
    pub fn with(own: &[(String, String)]) -> Result<Self, LibraryError> {
        let own = OwnFiles { texts: own.iter().cloned().collect(), ..OwnFiles::default() };
        let (library, faults) = Self::with_own(&own)?;
        faults.into_iter().next().map_or(Ok(library), Err)
    }

    /// What the program carries, with a user's files; a broken file of the user's is set aside and returned as an error.
    ///
    /// An entry that is set aside is in no table, and never falls back to a shipped one of the same id.
    ///
    /// # Errors
    /// If the program's own files are not sound.
    pub fn with_own(own: &OwnFiles) -> Result<(Self, Vec<LibraryError>), LibraryError> {
        Loading::new(own).library()
    }

    /// Returns why an entry of a user's is set aside, by the path of its file, as `foods/my-steak.toml`; `None` if it is not.
    pub fn set_aside(&self, path: &str) -> Option<&str> {
        self.set_aside.get(path).map(String::as_str)
    }

    /// Returns why an entry is not in its table: its file is broken, else the text for one without a file.
    pub fn absence(&self, folder: &str, id: &str, without_file: &str) -> String {
        match self.set_aside(&format!("{folder}/{id}.toml")) {
            Some(cause) => format!("cannot be used: {cause}"),
            None => without_file.to_owned(),
        }
    }

    /// Checks that a food's kinetics are there and change what the food colours.
    pub(crate) fn check_kinetics(&self, food: &FoodDescription, file: &DataFile) -> Result<(), LibraryError> {
        let Some(kinetics) = self.kinetics.get(&food.kinetics) else {
            let known = Self::names(&self.kinetics);
            let why = self.absence("kinetics", &food.kinetics, "is unknown");
            let message = format!("kinetics = \"{}\" {why}; there are: {known}", food.kinetics);
            return Err(file.error("kinetics", message));
        };
        let named = kinetics.in_order("colour", &food.colour.change);
        named.map(|_| ()).map_err(|e| file.error("colour.change", e.to_string()))
    }

    /// Scales are made for kinetics that are there and contain their change.
    pub(crate) fn check_scales(&self, file: &DataFile) -> Result<(), LibraryError> {
        for (at, scale) in self.scales.iter().enumerate() {
            let error = |message| Err(file.error(&format!("scale.{at}.for_kinetics"), message));
            for id in &scale.for_kinetics {
                let Some(kinetics) = self.kinetics.get(id) else {
                    if self.set_aside.contains_key(&format!("kinetics/{id}.toml")) {
                        continue;
                    }
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

    /// The scale that a food states for itself is sound, has its own id and a change of the food's kinetics.
    pub(crate) fn check_own_scale(
        &self,
        food: &FoodDescription,
        scale: &Scale,
        file: &DataFile,
    ) -> Result<(), LibraryError> {
        let error = |key: &str, message| Err(file.error(&format!("doneness.{key}"), message));
        if let Err((key, message)) = scale_fault(scale) {
            return error(key, message);
        }
        if self.scale(&scale.id).is_some() {
            return error("id", format!("there is another scale \"{}\": use another id", scale.id));
        }
        if !scale.for_kinetics.is_empty() {
            let message = "for_kinetics does not go with the scale of one food: leave it out";
            return error("for_kinetics", message.to_owned());
        }
        match self.kinetics.get(&food.kinetics) {
            Some(kinetics) if !scale.applies_to(kinetics) => {
                let known = kinetics.names().join(", ");
                error("for_change", format!("for_change is none of the food's changes: write one of {known}"))
            }
            _ => Ok(()),
        }
    }

    /// Goals name kinetics, a scale and a class that are there; what is set aside may be missing.
    pub(crate) fn check_goals(&self, file: &DataFile) -> Result<(), LibraryError> {
        for (at, goal) in self.goals.iter().enumerate() {
            let error = |key: &str, message| Err(file.error(&format!("goal.{at}.{key}"), message));
            for id in goal.kinetics.iter().filter(|id| !self.kinetics.contains_key(*id)) {
                if !self.set_aside.contains_key(&format!("kinetics/{id}.toml")) {
                    let known = Self::names(&self.kinetics);
                    return error("kinetics", format!("\"{id}\" is unknown; there are: {known}"));
                }
            }
            if self.scales.is_empty() || self.scales.iter().any(|scale| goal.is_on(scale)) {
                continue;
            }
            let (class, known) = (goal.class.clone().unwrap_or_default(), self.scale_names());
            let (key, scale) = goal.scale.as_ref().map_or(("class", "any scale"), |id| ("scale", id.as_str()));
            return error(key, format!("{scale} has no class \"{class}\"; there are the scales {known}"));
        }
        Ok(())
    }

    /// The kitchen names oils that are there, and butter that melts.
    pub(crate) fn check_oils(&self) -> Result<(), LibraryError> {
        let oil = &self.room.oil;
        let error = |message| Err(LibraryError { file: "kitchen.toml".into(), line: 1, message });
        for (key, id) in [("default", &oil.default), ("rendered", &oil.rendered), ("butter", &oil.butter)] {
            let Some(kind) = self.oils.get(id) else {
                let why = self.absence("oils", id, "is not an oil");
                return error(format!("[oil] {key} = \"{id}\" {why}; there are: {}", Self::names(&self.oils)));
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

    /// A goal by its id.
    pub fn goal(&self, id: &str) -> Option<&Arc<GoalDescription>> {
        self.goals.iter().find(|goal| goal.id == id)
    }

    /// The goals that fit a food, in their order.
    pub fn goals_for(&self, food: &FoodDescription) -> impl Iterator<Item = &Arc<GoalDescription>> {
        self.goals.iter().filter(|goal| goal.is_for(&food.kinetics))
    }

    /// The ids of the scales, for messages.
    pub fn scale_names(&self) -> String {
        self.scales.iter().map(|s| s.id.as_str()).collect::<Vec<_>>().join(", ")
    }

    /// The ids of a table, for messages.
    pub fn names<T>(table: &BTreeMap<String, T>) -> String {
        table.keys().map(String::as_str).collect::<Vec<_>>().join(", ")
    }

    /// The picture of a shipped food for lists, a PNG file; none for a food of the user's own.
    pub fn food_picture(id: &str) -> Option<&'static [u8]> {
        food_picture(id)
    }

    /// Every data file that the program carries, for tests of the data itself.
    pub fn embedded_files() -> BTreeMap<String, String> {
        data_files()
    }
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

/// Closes the triangles of a surface file, given the millimetres in one of its units; else states what is wrong and what
/// to do.
fn close_surface(soup: &Soup, name: &str, scale_mm: Option<f64>) -> Result<Surface, String> {
    Surface::close(soup, 1e-3 * scale_mm.unwrap_or(soup.unit_mm))
        .map_err(|defect| format!("{name} is not sound: {defect}; {}", defect.remedy()))
}
