//! The format of a sweep's file.

use std::collections::BTreeMap;

use saute_schema::{InputError, InputText};
use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::Value;
use toml::Spanned;

use crate::design::DesignKind;

/// A sweep: a recipe, what varies and how.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "saute sweep")]
pub struct SpecFile {
    /// Id of a shipped recipe, or a recipe's file, relative to this one.
    #[schemars(with = "String")]
    pub recipe: Spanned<String>,
    /// Simulated time after which a row ends if its recipe has not ended [s]; none by default.
    #[schemars(with = "Option<f64>", range(min = 0.1, max = 86400))]
    pub for_s: Option<Spanned<f64>>,
    /// Spacing of the foods' meshes relative to the default [-]; those of the recipe by default.
    #[schemars(with = "Option<f64>", range(min = 1, max = 8))]
    pub coarseness: Option<Spanned<f64>>,
    /// Rows in one Parquet file [-]; about a 64th of all by default, at least 16 and at most 4096.
    #[schemars(with = "Option<i64>", range(min = 1, max = 100_000))]
    pub rows_per_part: Option<Spanned<i64>>,
    /// What varies: a path into the recipe (`food.steak.size_mm[2]`, `pan.initial_c`, `step[3].after_s`) or into a data file
    /// (`kinetics.beef.browning.anchor_c`), with a list of levels or a range.
    #[schemars(with = "BTreeMap<String, VaryEntry>")]
    pub vary: BTreeMap<Spanned<String>, Spanned<toml::Value>>,
    /// Which combinations are cooked.
    #[schemars(with = "DesignEntry")]
    pub design: Spanned<DesignEntry>,
}

/// Values that a path takes.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum VaryEntry {
    /// A list of levels: numbers, texts or flags.
    Levels(Vec<Value>),
    /// A range of numbers.
    Range(RangeEntry),
}

/// A range of numbers.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RangeEntry {
    /// First value.
    pub from: f64,
    /// Last value.
    pub to: f64,
    /// Number of evenly spaced levels; a grid needs it, other designs take every number of the range unless it is given.
    #[schemars(range(min = 2, max = 1_000_000))]
    pub n: Option<u64>,
}

/// Which combinations are cooked.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DesignEntry {
    /// Kind.
    pub kind: DesignKind,
    /// Rows of a Latin hypercube or a Sobol' sequence, base rows of `saltelli`, trajectories of `morris` [-]; a grid has none.
    #[schemars(with = "Option<i64>", range(min = 1))]
    pub n: Option<Spanned<i64>>,
    /// Seed of the random parts [-]; 1 by default. With 0 a Sobol' sequence is the plain one.
    pub seed: Option<u32>,
}

impl SpecFile {
    /// Reads a file; `file` is its name in messages.
    ///
    /// # Errors
    /// Returns file, line, key and remedy of the first mistake.
    pub fn parse(text: &str, file: &str) -> Result<Self, InputError> {
        let parsed = InputText { text, file }.parse(KEYS);
        parsed.map_err(|error: InputError| InputError { remedy: remedy(&error.message), ..error })
    }
}

/// Where all keys are listed.
const KEYS: &str = "the keys and their types are listed by: saute schema sweep";

/// Returns what to write instead, from the parser's message: for an unknown key it lists the known ones.
fn remedy(message: &str) -> String {
    if message.contains("duplicate key") {
        return "leave one of the lines out".to_owned();
    }
    if message.ends_with("expected i64") {
        return "write a whole number, without a point; the ranges are listed by: saute schema sweep".to_owned();
    }
    if message.ends_with("expected u32") {
        return format!("write a whole number of 0 to {}", u32::MAX);
    }
    let unknown = message.split_once("unknown ").map(|(_, rest)| rest);
    let mut quoted = unknown.into_iter().flat_map(|rest| rest.split('`').skip(1).step_by(2));
    let near = quoted.next().and_then(|unknown| nearest(unknown, quoted));
    near.map_or_else(|| KEYS.to_owned(), |near| format!("write {near}; all keys are listed by: saute schema sweep"))
}

/// Similarity from which a name is taken for a misspelt one [-] (chosen: as in data files).
const ALIKE: f64 = 0.6;

/// Returns the known name that a misspelt one resembles most.
pub(crate) fn nearest<'a>(name: &str, known: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let rated = known.map(|k| (strsim::normalized_damerau_levenshtein(name, k), k)).filter(|(rate, _)| *rate >= ALIKE);
    rated.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, name)| name)
}
