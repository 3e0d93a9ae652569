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
    #[schemars(range(min = 0.1, max = 86400))]
    pub for_s: Option<f64>,
    /// Spacing of the foods' meshes relative to the default [-]; those of the recipe by default.
    #[schemars(range(min = 1, max = 8))]
    pub coarseness: Option<f64>,
    /// Rows in one Parquet file [-]; about a 64th of all by default, at least 16 and at most 4096.
    #[schemars(with = "Option<i64>", range(min = 1, max = 100_000))]
    pub rows_per_part: Option<Spanned<i64>>,
    /// What varies: a path into the recipe (`food.steak.size_mm[2]`, `pan.initial_c`, `step[3].after_s`) or into a data file
    /// (`kinetics.beef.browning.anchor_c`), with a list of levels or a range.
    #[schemars(with = "BTreeMap<String, VaryEntry>")]
    pub vary: BTreeMap<Spanned<String>, Spanned<VaryEntry>>,
    /// Which combinations are cooked.
    #[schemars(with = "DesignEntry")]
    pub design: Spanned<DesignEntry>,
}

/// Values that a path takes.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
#[schemars(extend("x-remedy" = "write a list or a range, as \"step[3].after_s\" = [1, 2] or { from = 1, to = 2, n = 3 }"))]
pub enum VaryEntry {
    /// A list of levels: numbers, texts or flags.
    Levels(#[schemars(with = "Vec<Value>")] Vec<toml::Value>),
    /// A range of numbers.
    Range(RangeEntry),
}

/// A range of numbers.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("x-remedy" = "there are: from, to, n; a path is written in quotes, as \"food.steak.size_mm[2]\" = [20, 40]"))]
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
    #[schemars(range(max = u32::MAX))]
    pub seed: Option<u32>,
}

impl SpecFile {
    /// Reads a file; `file` is its name in messages.
    ///
    /// # Errors
    /// Returns file, line, key and remedy of the first mistake.
    pub fn parse(text: &str, file: &str) -> Result<Self, InputError> {
        InputText { text, file }.parse("the keys and their types are listed by: saute schema sweep")
    }
}
