//! The summary of a cook as one row of a table.
//!
//! A column is named as the number is in the summary's JSON, with dots between the keys: `pan_c.peak`, `liquids_g.oil`,
//! `food.steak.core_c.end`. A food or group is under its id after `food.`; of a group the means over its pieces are in the
//! table. Every kind of event has its count. Units follow from the names. Wall time and steps are left out, so that the same cook
//! gives the same row.

use std::collections::BTreeMap;

use saute_kitchen::tick::event::EventKind;
use saute_recipe::Summary;
use serde::Serialize;
use serde_json::Value as Json;

use crate::table::{ColumnKind, Heading, Table, Value};

/// Keys of a summary that are not columns: lists, times of this machine, labels of scales, and foods, which have columns of their
/// own.
const LEFT_OUT: [&str; 10] =
    ["wall_s", "steps", "warnings", "events", "foods", "groups", "id", "group", "label", "spread"];

/// Endings of names with their units.
const UNITS: [(&str, &str); 12] = [
    ("_c", "°C"),
    ("_g", "g"),
    ("_s", "s"),
    ("_j", "J"),
    ("_mm", "mm"),
    ("_pct", "%"),
    ("_deg", "°"),
    ("_kpa", "kPa"),
    ("_w", "W"),
    ("_kg", "kg"),
    ("_k", "K"),
    ("_min", "min"),
];

/// One number of a summary with its heading; the value is none where the summary has null.
pub type Cell = (Heading, Option<Value>);

/// Returns the numbers of a summary with their headings, sorted by name.
pub fn cells(summary: &Summary) -> Vec<Cell> {
    let mut found = BTreeMap::new();
    flatten("", &json(summary), &mut found);
    for entry in summary.foods_and_groups() {
        flatten(&format!("food.{}", entry.food.id), &json(entry.food), &mut found);
        if entry.group {
            let count = i64::try_from(entry.members.len()).unwrap_or(i64::MAX);
            put(&format!("food.{}.count", entry.food.id), ColumnKind::Integer, Some(Value::Integer(count)), &mut found);
        }
    }
    for kind in EventKind::ALL {
        let tally = summary.events.iter().find(|tally| tally.kind == kind);
        let count = tally.map_or(0, |tally| i64::try_from(tally.count).unwrap_or(i64::MAX));
        let name = json(&kind);
        let name = name.as_str().unwrap_or("other");
        put(&format!("events.{name}.count"), ColumnKind::Integer, Some(Value::Integer(count)), &mut found);
    }
    let warnings = summary.warnings.join("; ");
    put("warnings", ColumnKind::Text, Some(Value::Text(warnings)), &mut found);
    found.into_values().collect()
}

/// Returns the summary of one cook as a table of one row.
pub fn table(summary: &Summary) -> Table {
    let (headings, row) = cells(summary).into_iter().unzip();
    Table { headings, rows: vec![row], ..Table::default() }
}

fn json(value: &impl Serialize) -> Json {
    // Numbers, texts and maps by text always have a JSON form.
    serde_json::to_value(value).unwrap_or_default()
}

fn flatten(path: &str, json: &Json, found: &mut BTreeMap<String, Cell>) {
    match json {
        Json::Object(entries) => {
            for (key, value) in entries.iter().filter(|(key, _)| !LEFT_OUT.contains(&key.as_str())) {
                let path = if path.is_empty() { key.clone() } else { format!("{path}.{key}") };
                flatten(&path, value, found);
            }
        }
        Json::Array(items) if path.ends_with(".lab") => {
            for (axis, value) in ["L", "a", "b"].into_iter().zip(items) {
                flatten(&format!("{path}.{axis}"), value, found);
            }
        }
        Json::Array(_) => {}
        Json::Null if path == "waiting_step" => put(path, ColumnKind::Integer, None, found),
        Json::Null => put(path, ColumnKind::Float, None, found),
        Json::Bool(flag) => put(path, ColumnKind::Flag, Some(Value::Flag(*flag)), found),
        Json::String(text) => put(path, ColumnKind::Text, Some(Value::Text(text.clone())), found),
        Json::Number(number) => match number.as_i64() {
            Some(whole) => put(path, ColumnKind::Integer, Some(Value::Integer(whole)), found),
            None => put(path, ColumnKind::Float, number.as_f64().map(Value::Float), found),
        },
    }
}

fn put(path: &str, kind: ColumnKind, value: Option<Value>, found: &mut BTreeMap<String, Cell>) {
    let unit = if matches!(kind, ColumnKind::Float) { unit_of(path) } else { "" };
    found.insert(path.to_owned(), (Heading::new(path, unit, kind), value));
}

/// Returns the unit that a name states: that of its last key with one, as `°C` for `core_c.end`; `-` for a plain number.
pub fn unit_of(path: &str) -> &'static str {
    let of_key = |key: &str| UNITS.iter().find(|(ending, _)| key.ends_with(ending)).map(|(_, unit)| *unit);
    path.rsplit('.').find_map(of_key).unwrap_or("-")
}
