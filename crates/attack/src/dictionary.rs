//! Dictionaries of the fuzzer: the keys of a format from its schema, and the words of its seeds.

use std::collections::BTreeSet;
use std::fmt::Write;

use saute_kitchen::food::{FoodDescription, Kinetics};
use saute_kitchen::liquids::oil::OilDescription;
use saute_kitchen::pan::pan_description::PanDescription;
use saute_lab::CaseFile;
use saute_mirror::rig_file::RigFile;
use saute_recipe::recipe_file::RecipeFile;
use saute_schema::FormatSchema;
use saute_study::class::scenario_file::ScenarioFile;
use saute_study::protocol_file::ProtocolFile;
use saute_sweep::SpecFile;
use serde_json::Value;

use crate::{Target, kept};

/// Numbers at which readers break.
const NUMBERS: [&str; 14] = [
    "nan",
    "inf",
    "-inf",
    "1e308",
    "-1e308",
    "5e-324",
    "1e-9",
    "0",
    "-1",
    "1e9",
    "4294967295",
    "9223372036854775807",
    "-9223372036854775808",
    "18446744073709551615",
];
/// Longest word [bytes] (chosen: longer ones are sentences).
const LONGEST: usize = 40;

/// Returns the dictionary of a target as libFuzzer reads it: one quoted word a line.
pub fn dictionary(target: &Target) -> String {
    let mut lines = String::from("# Generated: SAUTE_BLESS=1 cargo test --release -p saute-attack dictionaries\n");
    for word in words(target) {
        writeln!(lines, "\"{word}\"").expect("a string takes every text");
    }
    lines
}

/// Returns the words of a target's dictionary.
pub fn words(target: &Target) -> Vec<String> {
    let mut words: BTreeSet<String> = NUMBERS.map(str::to_owned).into();
    if let Some(schema) = schema(target.name) {
        keys(schema.json(), &mut words);
    }
    for seed in kept("seeds", target) {
        let text = String::from_utf8_lossy(&seed.bytes).into_owned();
        let separate = |c: char| !(c.is_ascii_alphanumeric() || "_-./".contains(c));
        words.extend(text.split(separate).filter(|word| word.len() > 1).map(str::to_owned));
    }
    let is_short =
        |word: &String| word.len() <= LONGEST && word.bytes().all(|b| b.is_ascii_graphic() && b != b'"' && b != b'\\');
    words.into_iter().filter(is_short).collect()
}

/// Returns the schema of a target's format, where it has one.
fn schema(name: &str) -> Option<FormatSchema> {
    Some(match name {
        "recipe" => FormatSchema::of::<RecipeFile>(),
        "food" => FormatSchema::of::<FoodDescription>(),
        "pan" => FormatSchema::of::<PanDescription>(),
        "oil" => FormatSchema::of::<OilDescription>(),
        "kinetics" => FormatSchema::of::<Kinetics>(),
        "lab" => FormatSchema::of::<CaseFile>(),
        "protocol" => FormatSchema::of::<ProtocolFile>(),
        "scenario" => FormatSchema::of::<ScenarioFile>(),
        "sweep" => FormatSchema::of::<SpecFile>(),
        "rig" => FormatSchema::of::<RigFile>(),
        _ => return None,
    })
}

/// Adds the names of all keys and the words of all choices in a schema.
fn keys(schema: &Value, words: &mut BTreeSet<String>) {
    match schema {
        Value::Object(entries) => {
            for (name, inner) in entries {
                match (name.as_str(), inner) {
                    ("properties" | "$defs", Value::Object(all)) => words.extend(all.keys().cloned()),
                    ("enum", Value::Array(all)) => {
                        words.extend(all.iter().filter_map(Value::as_str).map(str::to_owned))
                    }
                    ("const", Value::String(word)) => drop(words.insert(word.clone())),
                    _ => {}
                }
                keys(inner, words);
            }
        }
        Value::Array(all) => all.iter().for_each(|inner| keys(inner, words)),
        _ => {}
    }
}
