//! `saute list actions`: the actions of a recipe's steps, with their keys from the JSON Schema of the recipe format.

use std::process::ExitCode;

use saute_recipe::ActionKind;
use saute_recipe::recipe_file::RecipeFile;
use serde::Serialize;
use serde_json::Value;

use crate::error::CliError;
use crate::output::{json, stdout};

/// An action.
#[derive(Debug, Serialize)]
struct ListedAction {
    id: &'static str,
    /// Description.
    name: &'static str,
    /// Keys of its table.
    key: Vec<Key>,
}

/// A key of an action's table.
#[derive(Debug, Serialize)]
struct Key {
    id: String,
    name: String,
    /// True if it must be given.
    required: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    default: Option<Value>,
    #[serde(skip_serializing_if = "Option::is_none")]
    min: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    max: Option<f64>,
}

/// Prints all actions with the keys of their tables.
pub fn run(as_json: bool) -> Result<ExitCode, CliError> {
    let entries = entries(&serde_json::to_value(schemars::schema_for!(RecipeFile))?);
    let text = if as_json { json::text(&entries)? } else { entries.iter().map(text).collect() };
    stdout::print(&text)?;
    Ok(ExitCode::SUCCESS)
}

/// Returns the members of an object; none for any other value.
fn members(of: &Value) -> impl Iterator<Item = (&String, &Value)> {
    of.as_object().into_iter().flatten()
}

fn entries(schema: &Value) -> Vec<ListedAction> {
    let properties = &schema["$defs"]["StepEntry"]["properties"];
    let entry = |kind: ActionKind| {
        let id = kind.name();
        ListedAction { id, name: kind.summary(), key: keys(schema, &properties[id]) }
    };
    let mut entries: Vec<ListedAction> = ActionKind::ALL.map(entry).into();
    entries.sort_by_key(|entry| entry.id);
    entries
}

/// Returns the keys of an action's table; none for an action that takes a single value.
fn keys(schema: &Value, property: &Value) -> Vec<Key> {
    let Some(table) = table(schema, property) else { return Vec::new() };
    let required = |id: &str| table["required"].as_array().is_some_and(|all| all.iter().any(|key| key == id));
    let key = |(id, of): (&String, &Value)| Key {
        id: id.clone(),
        name: of["description"].as_str().unwrap_or_default().to_owned(),
        required: required(id),
        default: of.get("default").cloned(),
        min: of["minimum"].as_f64(),
        max: of["maximum"].as_f64(),
    };
    members(&table["properties"]).map(key).collect()
}

/// Returns the table among the alternatives of a property.
fn table<'a>(schema: &'a Value, part: &'a Value) -> Option<&'a Value> {
    if let Some(path) = part["$ref"].as_str() {
        return table(schema, schema.pointer(path.trim_start_matches('#'))?);
    }
    if part["properties"].is_object() {
        return Some(part);
    }
    part["anyOf"].as_array()?.iter().find_map(|alternative| table(schema, alternative))
}

fn text(entry: &ListedAction) -> String {
    let mut lines = format!("{:<12}{}\n", entry.id, entry.name);
    for key in &entry.key {
        let range = key.min.zip(key.max).map_or(String::new(), |(low, high)| format!(" {low}–{high}."));
        let must = if key.required { " Required." } else { "" };
        lines += &format!("  {:<14}{}{range}{must}\n", key.id, key.name);
    }
    lines
}
