//! A checked scenario.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use saute_kitchen::Library;
use saute_recipe::Recipe;
use saute_schema::{InputError, InputText};

use super::check::Check;
use super::scenario_file::{Deed, Locked};
use crate::protocol_file::Information;
use saute_plan::Aimed;

/// A checked scenario.
#[derive(Clone, Debug)]
pub struct Scenario {
    /// Id in results and links.
    pub id: String,
    /// Title.
    pub title: Words,
    /// What the student reads first.
    pub intro: Words,
    /// The recipe whose pan and food are set out.
    pub recipe: Arc<Recipe>,
    /// The goal.
    pub goal: Aimed,
    /// What cannot be changed.
    pub locked: BTreeSet<Locked>,
    /// Whether read-outs are shown.
    pub overlays: Information,
    /// Simulated time over wall time at the start [-].
    pub speed: f64,
    /// Longest lesson [simulated s].
    pub max_s: f64,
    /// Questions.
    pub predictions: Vec<Predict>,
    /// Checksum of the text.
    pub checksum: u32,
}

/// A text in English, and in other languages where the file has it.
#[derive(Clone, Debug, Default, Eq, PartialEq)]
pub struct Words {
    /// English.
    pub en: String,
    /// The others by their codes.
    pub others: BTreeMap<String, String>,
}

/// A question at which the cook pauses.
#[derive(Clone, Debug, PartialEq)]
pub struct Predict {
    /// When it is asked.
    pub when: When,
    /// What is asked.
    pub ask: Ask,
    /// Words before it; empty where there are none.
    pub text: Words,
}

/// When a question is asked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum When {
    /// At a time [s].
    At(f64),
    /// Once the core has a temperature [K].
    Core(f64),
    /// So long after a deed was done for the first time [s].
    After(Deed, f64),
}

/// What is asked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ask {
    /// How warm the core is now [°C].
    CoreNow,
    /// How warm it will be so much later [°C; s].
    CoreIn(f64),
    /// How warm it will get at most [°C].
    CorePeak,
    /// How much of the underside is brown now [%].
    UndersideBrown,
    /// Which class the core will have in the end, by its place in the scale.
    ClassInTheEnd,
}

impl Scenario {
    /// Parses and checks a scenario. `file` is its name in messages.
    ///
    /// # Errors
    ///
    /// Returns file, line, key and remedy of the first mistake.
    pub fn parse(text: &str, file: &str, library: &Library) -> Result<Self, InputError> {
        Check { input: InputText { text, file }, library }.scenario()
    }
}

impl Words {
    /// The text in English, and in Japanese where there is one.
    pub(super) fn new(en: &str, ja: Option<&str>) -> Self {
        Self { en: en.to_owned(), others: ja.map(|text| ("ja".to_owned(), text.to_owned())).into_iter().collect() }
    }

    /// The text in a language, given its code; in English where it is not there.
    pub fn of(&self, language: &str) -> &str {
        self.others.get(language).unwrap_or(&self.en)
    }
}

impl Ask {
    /// Lowest and highest answer; none for the class (chosen: colder is frozen, hotter is not to be had inside of food).
    pub fn range(self) -> Option<[f64; 2]> {
        match self {
            Self::CoreNow | Self::CoreIn(_) | Self::CorePeak => Some([0.0, 100.0]),
            Self::UndersideBrown => Some([0.0, 100.0]),
            Self::ClassInTheEnd => None,
        }
    }

    /// Distance from the truth within which an answer is near [K, points of %] (chosen: half of the narrowest class of beef;
    /// a tenth of a face). A class is right or not.
    pub fn near(self) -> f64 {
        match self {
            Self::CoreNow | Self::CoreIn(_) | Self::CorePeak => 2.5,
            Self::UndersideBrown => 10.0,
            Self::ClassInTheEnd => 0.0,
        }
    }
}
