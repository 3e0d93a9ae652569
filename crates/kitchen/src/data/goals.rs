//! Goals of a cook as data: what a finished food is judged by.

use std::collections::BTreeMap;

use saute_food::Scale;
use saute_food::description::Confidence;
use schemars::JsonSchema;
use serde::Deserialize;

/// `goals.toml` as it is written.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "saute goals")]
pub(crate) struct GoalsFile {
    /// Goals.
    pub(crate) goal: Vec<GoalDescription>,
}

/// What the share of a goal is a share of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Counted {
    /// The section: the part of it in the goal's class of doneness.
    Section,
    /// The two faces: the browned part of them.
    Faces,
}

/// A goal of a cook: one entry of `goals.toml`.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GoalDescription {
    /// Name in files and on the command line.
    #[schemars(example = &"medium")]
    pub id: String,
    /// Label for people.
    #[schemars(example = &"Medium, with a crust")]
    pub name: String,
    /// Labels in other languages by their code.
    #[serde(default)]
    #[schemars(extend("examples" = [{ "ja": "ミディアム" }]))]
    pub names: BTreeMap<String, String>,
    /// Ids of the kinetics of the foods that it fits.
    #[schemars(length(min = 1), extend("examples" = [["beef"]]))]
    pub kinetics: Vec<String>,
    /// What the share is a share of: the section in the class, or the browned faces.
    #[schemars(example = &"section")]
    pub counts: Counted,
    /// Id of the scale of the class; without it, every scale that has the class and fits the food.
    #[schemars(example = &"paper-2013")]
    pub scale: Option<String>,
    /// Class of doneness; for `counts = "faces"` none.
    #[schemars(example = &"medium")]
    pub class: Option<String>,
    /// True if the core must be in the class too.
    #[schemars(example = true)]
    pub core_counts: bool,
    /// Share that is to be exceeded or reached [%].
    #[schemars(range(min = 0.0, max = 100.0), example = 40.0)]
    pub least_share_pct: f64,
    /// Share that a cook can reach who does it best: it has full marks [%]; 50 where none is given.
    #[schemars(range(min = 1.0, max = 100.0), example = 50.0)]
    pub full_share_pct: Option<f64>,
    /// Browned share of each face that is wanted [%].
    #[schemars(range(min = 0.0, max = 100.0), example = 60.0)]
    pub crust_pct: f64,
    /// Charred share of the faces above which the food is burnt [%].
    #[schemars(range(min = 0.0, max = 100.0), example = 5.0)]
    pub most_charred_pct: f64,
    /// Source of the numbers.
    #[schemars(example = &"chosen: …")]
    pub source: String,
    /// Confidence in the numbers.
    #[schemars(example = &"medium")]
    pub confidence: Confidence,
}

impl GoalDescription {
    /// Returns true if it states anything about a food with the kinetics of an id.
    pub fn is_for(&self, kinetics: &str) -> bool {
        self.kinetics.iter().any(|id| id == kinetics)
    }

    /// Returns true if it can be judged on a scale: it names that scale or none, and the scale has its class.
    pub fn is_on(&self, scale: &Scale) -> bool {
        let named = self.scale.as_ref().is_none_or(|id| *id == scale.id);
        named && self.class.as_ref().is_none_or(|name| scale.class.iter().any(|class| class.name == *name))
    }
}
