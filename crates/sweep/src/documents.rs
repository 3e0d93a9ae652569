//! The texts that a sweep varies, as parsed TOML: its recipe and the data files.

use std::collections::BTreeMap;

use saute_kitchen::food::{FoodDescription, Kinetics};
use saute_kitchen::liquids::oil::OilDescription;
use saute_kitchen::pan::hob::HobDescription;
use saute_kitchen::pan::pan_description::{CoatingDescription, PanDescription};
use saute_recipe::recipe_file::RecipeFile;
use saute_schema::FormatSchema;
use serde_json::Value as Json;
use toml::Table;

use crate::place::{Document, Place};

/// Folders of data files with an id each; the first key of a path into one of them is the name of the folder.
pub(crate) const FOLDERS: [&str; 6] = ["foods", "kinetics", "pans", "coatings", "oils", "hobs"];
/// Data files that are one of a kind, by the first key of a path.
pub(crate) const SINGLE: [&str; 4] = ["components", "doneness", "fond", "kitchen"];

/// Recipe and data files as texts.
#[derive(Clone, Debug, Default)]
pub(crate) struct Documents {
    /// Recipe.
    pub(crate) recipe: Table,
    /// Data files by path, as `kinetics/beef.toml`.
    pub(crate) data: BTreeMap<String, String>,
}

impl Documents {
    /// Returns the document that a path leads into as a table; none if there is no such file.
    pub(crate) fn table(&self, document: &Document) -> Option<Table> {
        match document {
            Document::Recipe => Some(self.recipe.clone()),
            Document::Data(file) => self.data.get(file)?.parse().ok(),
        }
    }

    /// Returns the names that can begin a path.
    pub(crate) fn roots(&self) -> Vec<String> {
        let of_recipe = keys(&schema(&Document::Recipe));
        let rest = FOLDERS.into_iter().chain(SINGLE).map(str::to_owned);
        of_recipe.into_iter().chain(rest).collect()
    }

    /// Returns the ids of the files of a folder.
    pub(crate) fn ids(&self, folder: &str) -> Vec<String> {
        let id = |path: &String| Some(path.strip_prefix(folder)?.strip_prefix('/')?.strip_suffix(".toml")?.to_owned());
        self.data.keys().filter_map(id).collect()
    }
}

/// Returns the schema of a document; null where its format is not public.
pub(crate) fn schema(document: &Document) -> Json {
    let of = |schema: FormatSchema| schema.json().clone();
    let Document::Data(file) = document else { return of(FormatSchema::of::<RecipeFile>()) };
    match file.split('/').next().unwrap_or_default() {
        "foods" => of(FormatSchema::of::<FoodDescription>()),
        "kinetics" => of(FormatSchema::of::<Kinetics>()),
        "pans" => of(FormatSchema::of::<PanDescription>()),
        "coatings" => of(FormatSchema::of::<CoatingDescription>()),
        "oils" => of(FormatSchema::of::<OilDescription>()),
        "hobs" => of(FormatSchema::of::<HobDescription>()),
        _ => Json::Null,
    }
}

/// Returns the alternatives of a schema that are not null.
fn alternatives(schema: &Json) -> Vec<&Json> {
    let all = ["anyOf", "oneOf", "allOf"].into_iter().find_map(|key| schema[key].as_array());
    all.map_or_else(|| vec![schema], |all| all.iter().flat_map(alternatives).collect())
}

/// Returns the keys in the schema of a table.
pub(crate) fn keys(schema: &Json) -> Vec<String> {
    let properties = alternatives(schema).into_iter().filter_map(|s| s["properties"].as_object());
    properties.flat_map(|p| p.keys().cloned()).collect()
}

/// Returns the schema of a key of a table; null where it states nothing.
pub(crate) fn of_key(schema: &Json, key: &str) -> Json {
    let found = alternatives(schema).into_iter().find(|s| s["properties"].get(key).is_some());
    found.map_or_else(
        || {
            alternatives(schema)
                .into_iter()
                .map(|s| s["additionalProperties"].clone())
                .find(Json::is_object)
                .unwrap_or_default()
        },
        |s| s["properties"][key].clone(),
    )
}

/// Returns the schema of the items of a list; null where it states nothing.
pub(crate) fn of_item(schema: &Json) -> Json {
    let items = alternatives(schema).into_iter().map(|s| s["items"].clone());
    items.into_iter().find(Json::is_object).unwrap_or_default()
}

/// Returns true if a schema takes whole numbers only.
pub(crate) fn is_whole(schema: &Json) -> bool {
    let is_integer = |s: &Json| match &s["type"] {
        Json::String(name) => name == "integer",
        Json::Array(names) => names.iter().any(|n| n == "integer") && !names.iter().any(|n| n == "number"),
        _ => false,
    };
    alternatives(schema).into_iter().any(is_integer)
}

impl Documents {
    /// Sets the value at a place; a key that is missing is added.
    pub(crate) fn set(table: &mut Table, place: &Place, value: toml::Value) -> Option<()> {
        let (last, way) = place.steps.split_last()?;
        let mut at = toml::Value::Table(std::mem::take(table));
        let done = set_within(&mut at, way, last, if place.is_whole { whole(value) } else { value });
        if let toml::Value::Table(back) = at {
            *table = back;
        }
        done
    }
}

fn whole(value: toml::Value) -> toml::Value {
    match value {
        toml::Value::Float(v) if v.abs() < 9e15 => toml::Value::Integer(libm::round(v) as i64),
        other => other,
    }
}

fn set_within(
    top: &mut toml::Value,
    way: &[crate::place::Step],
    last: &crate::place::Step,
    value: toml::Value,
) -> Option<()> {
    use crate::place::Step;
    let mut at = top;
    for step in way {
        at = match step {
            Step::Key(key) => {
                let table = at.as_table_mut()?;
                table.entry(key.clone()).or_insert_with(|| toml::Value::Table(Table::new()))
            }
            Step::Item(index) => at.as_array_mut()?.get_mut(*index)?,
        };
    }
    match last {
        Step::Key(key) => drop(at.as_table_mut()?.insert(key.clone(), value)),
        Step::Item(index) => *at.as_array_mut()?.get_mut(*index)? = value,
    }
    Some(())
}
