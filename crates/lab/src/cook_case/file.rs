//! The file format of a cook case, before any check.

use schemars::JsonSchema;
use serde::Deserialize;
use toml::Spanned;

use crate::Evidence;
use crate::cook_case::course::Course;
use crate::cook_case::moment::{Moment, MomentEntry};
use crate::cook_case::sweep::{Sweep, TrendEntry};

/// A cook case.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "saute cook case")]
pub(super) struct CookCaseFile {
    /// What is judged.
    pub name: String,
    /// Where the expected values come from.
    pub source: String,
    /// Kind of evidence.
    pub evidence: Evidence,
    /// The recipe, in its own format.
    #[schemars(with = "String")]
    pub recipe: Spanned<String>,
    /// A second recipe for comparison.
    #[schemars(with = "Option<String>")]
    pub against: Option<Spanned<String>>,
    /// Values that replace a mark in the recipe, one cook for each; trends go along them.
    #[schemars(with = "Option<Sweep>")]
    pub sweep: Option<Spanned<Sweep>>,
    /// Values of a second mark; every trend is judged for each of them.
    #[schemars(with = "Option<Sweep>")]
    pub each: Option<Spanned<Sweep>>,
    /// Expected bands.
    #[serde(default)]
    #[schemars(with = "Vec<BandEntry>")]
    pub expect: Vec<Spanned<BandEntry>>,
    /// Promises along the values of the sweep.
    #[serde(default)]
    #[schemars(with = "Vec<TrendEntry>")]
    pub trend: Vec<Spanned<TrendEntry>>,
    /// Colours in pictures.
    #[serde(default)]
    pub seen: Vec<Seen>,
    /// Colours over time.
    #[serde(default)]
    pub course: Vec<Course>,
}

/// An expected colour in a picture of the end of the cook.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Seen {
    /// Name of the quantity.
    pub quantity: String,
    /// Place on the food.
    pub place: SeenAt,
    /// Expected L*, a*, b* [-].
    pub lab: [f64; 3],
    /// Largest colour difference ΔE*ab [-].
    pub delta_e: f64,
}

/// Place on the first food for a colour.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum SeenAt {
    /// The middle of the upper face.
    Top,
    /// The middle of the lower face.
    Under,
    /// The middle of the cut.
    Cut,
}

/// A band from `low` to `high` for a number of the summary, by its JSON pointer, as in `/foods/0/core_c/peak`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct BandEntry {
    /// Name of the quantity.
    pub quantity: String,
    /// Pointer to its number in the summary.
    pub pointer: String,
    /// Pointer to a number that is subtracted, as the core's temperature from that of a face.
    pub less: Option<String>,
    /// Moment of the reading; the end of the cook by default.
    #[schemars(with = "Option<MomentEntry>")]
    pub at: Option<Moment>,
    /// Its unit.
    pub unit: String,
    /// Least value, in the unit.
    pub low: f64,
    /// Largest value, in the unit.
    pub high: f64,
    /// Comparison with the same number of the second recipe.
    pub compare: Option<Compare>,
    /// Why the program's value is known to lie outside.
    pub known_miss: Option<KnownMiss>,
}

/// A band that the program is known to miss. It is judged: a band that holds in spite of it falls short, so that no miss
/// outlives its cause.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct KnownMiss {
    /// Reason, as far as it is known.
    pub why: String,
    /// The value farthest from the band that is accepted.
    pub worst: f64,
    /// In a sweep, the cooks that miss, by the value of one mark, as `half_s = 105`; all cooks by default.
    pub of: Option<String>,
}

impl BandEntry {
    /// Reason of the known miss of the cook with a label and a value; none if the band should hold there, or if the value
    /// is missing or worse than accepted.
    pub fn known_miss(&self, label: &str, got: Option<f64>) -> Option<String> {
        let known = self.known_miss.as_ref()?;
        let accepted = self.low.min(known.worst)..=self.high.max(known.worst);
        let is_meant = known.of.as_ref().is_none_or(|of| label.split(", ").any(|mark| mark == of));
        (is_meant && accepted.contains(&got?)).then(|| known.why.clone())
    }
}

/// Comparison of a number of the first recipe with that of the second.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub(super) enum Compare {
    /// First over second.
    Ratio,
    /// First less second.
    Difference,
}
