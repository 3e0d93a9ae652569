//! The content of a folder: which sweep, and how its rows are divided into parts.

use std::ops::RangeInclusive;

use serde::{Deserialize, Serialize};

use crate::design::Design;

/// Name of the manifest in the folder of a sweep.
pub const FILE: &str = "sweep.json";
/// Most rows of a sweep [-] (chosen: with short cooks a week of one core, with long ones a year; a Sobol' sequence has more digits).
pub(crate) const MOST_ROWS: u64 = 10_000_000;
/// Rows of a part [-] (chosen: a part is held in memory while it is written).
pub(crate) const PART_ROWS: RangeInclusive<u64> = 1..=100_000;
/// Version of the manifest's format.
const FORMAT: u32 = 1;

/// The manifest of a sweep.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Manifest {
    /// Version of this format.
    pub format: u32,
    /// Version of the program.
    pub version: String,
    /// Hash of specification, recipe, data and version: the same for the same rows.
    pub hash: String,
    /// Recipe, as the specification names it.
    pub recipe: String,
    /// Paths of the varied values, in the order of the file.
    pub varied: Vec<String>,
    /// Design.
    pub design: Design,
    /// Number of rows.
    pub rows: u64,
    /// Number of rows in each part but the last.
    pub rows_per_part: u64,
}

impl Manifest {
    pub(crate) fn new(hash: u64, recipe: &str, varied: Vec<String>, design: Design, rows: [u64; 2]) -> Self {
        let [rows, rows_per_part] = rows;
        let version = env!("CARGO_PKG_VERSION").to_owned();
        let hash = format!("{hash:016x}");
        Self { format: FORMAT, version, hash, recipe: recipe.to_owned(), varied, design, rows, rows_per_part }
    }

    /// Returns the manifest as JSON.
    pub fn text(&self) -> String {
        serde_json::to_string_pretty(self).unwrap_or_default() + "\n"
    }

    /// Reads a manifest; states why it cannot be used.
    ///
    /// # Errors
    /// If the text is no manifest of this version of the program.
    pub fn parse(text: &str) -> Result<Self, String> {
        let manifest: Self = serde_json::from_str(text).map_err(|e| format!("is no manifest of a sweep: {e}"))?;
        if manifest.format != FORMAT {
            return Err(format!("has the format {}; this program reads {FORMAT}", manifest.format));
        }
        if !manifest.is_sound() {
            return Err("contradicts itself: it was changed or is damaged".to_owned());
        }
        Ok(manifest)
    }

    /// Returns true if its numbers fit together.
    fn is_sound(&self) -> bool {
        let dimensions = self.design.dimensions();
        dimensions > 0
            && dimensions == self.varied.len()
            && self.design.has_dimensions()
            && u32::try_from(self.design.seed).is_ok()
            && (1..=MOST_ROWS).contains(&self.rows)
            && self.design.rows() == Some(self.rows)
            && PART_ROWS.contains(&self.rows_per_part)
    }

    /// Returns why this sweep cannot go on in a folder with another manifest; none if it is the same sweep.
    pub fn conflict(&self, found: &Self) -> Option<String> {
        if self == found {
            return None;
        }
        let differs = if self.version != found.version {
            format!("was begun by version {}", found.version)
        } else if self.recipe != found.recipe || self.varied != found.varied || self.design != found.design {
            "holds another sweep".to_owned()
        } else {
            "was begun with another recipe, data or values".to_owned()
        };
        Some(differs)
    }

    /// Returns the number of parts.
    pub fn parts(&self) -> u64 {
        self.rows.div_ceil(self.rows_per_part)
    }

    /// Returns the rows of a part.
    pub fn part_rows(&self, part: u64) -> std::ops::Range<u64> {
        let first = part * self.rows_per_part;
        first..(first + self.rows_per_part).min(self.rows)
    }

    /// Returns the file name of a part: `part-00000.parquet`.
    pub fn part_name(part: u64) -> String {
        format!("part-{part:05}.parquet")
    }

    /// Returns the number of the part with a file name.
    pub fn part_of(name: &str) -> Option<u64> {
        let digits = name.strip_prefix("part-")?.strip_suffix(".parquet")?;
        let part = digits.parse().ok()?;
        (Self::part_name(part) == name).then_some(part)
    }
}
