//! Cooks with an answer from outside: a recipe and the bands in which its numbers should lie.

use serde::Deserialize;
use toml::Spanned;

use crate::cook::Cook;
use crate::input_error::{InputError, InputText};
use crate::lab::Verdict;
use crate::library::Library;
use crate::recipe::Recipe;

/// A cook case as it is written.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct CookCaseFile {
    name: String,
    source: String,
    recipe: Spanned<String>,
    /// A second recipe with which numbers are compared.
    against: Option<Spanned<String>>,
    expect: Vec<Spanned<BandEntry>>,
}

/// A band: a number of the summary by its JSON pointer, as in `/foods/0/core_c/peak`, from `low` to `high`.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct BandEntry {
    quantity: String,
    pointer: String,
    unit: String,
    low: f64,
    high: f64,
    /// How the number is compared with that of the second recipe.
    compare: Option<Compare>,
}

/// How a number of the first recipe is compared with that of the second.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
enum Compare {
    /// First over second.
    Ratio,
    /// First less second.
    Difference,
}

/// A cook with expected bands.
#[derive(Clone, Debug)]
pub struct CookCase {
    file: CookCaseFile,
    recipe: Recipe,
    against: Option<Recipe>,
}

impl CookCase {
    /// Reads and checks a case. `file` is its name in messages.
    pub fn parse(text: &str, file: &str, library: &Library) -> Result<Self, InputError> {
        let input = InputText { text, file };
        let raw: CookCaseFile = input.parse("a cook case has name, source, recipe and [[expect]]")?;
        for band in &raw.expect {
            let b = band.get_ref();
            if b.compare.is_some() && raw.against.is_none() {
                let remedy = "add against = \"…\" with the second recipe, or leave compare out";
                return input.error(band.span().start, "there is nothing to compare with", remedy);
            }
            if b.low.partial_cmp(&b.high).is_none_or(std::cmp::Ordering::is_gt) {
                let message = format!("the band {} to {} is empty", b.low, b.high);
                return input.error(band.span().start, message, "write low = … and high = … with low below high");
            }
        }
        let recipe = Recipe::parse(raw.recipe.get_ref(), &format!("{file}, recipe"), library)?;
        let second = |text: &Spanned<String>| Recipe::parse(text.get_ref(), &format!("{file}, against"), library);
        Ok(Self { against: raw.against.as_ref().map(second).transpose()?, file: raw, recipe })
    }

    /// Whether a text is a cook case rather than a lab case.
    pub fn is_one(text: &str) -> bool {
        text.lines().any(|line| line.starts_with("recipe = "))
    }

    /// Cooks and compares.
    pub fn verdicts(&self, library: &Library) -> Result<Vec<Verdict>, InputError> {
        let first = cooked(&self.recipe, library)?;
        let second = self.against.as_ref().map(|recipe| cooked(recipe, library)).transpose()?;
        Ok(self.file.expect.iter().map(|band| self.verdict(band.get_ref(), &first, second.as_ref())).collect())
    }

    fn verdict(&self, band: &BandEntry, first: &serde_json::Value, second: Option<&serde_json::Value>) -> Verdict {
        let read = |summary: &serde_json::Value| summary.pointer(&band.pointer).and_then(serde_json::Value::as_f64);
        let other = second.and_then(read);
        let got = match band.compare {
            None => read(first),
            Some(Compare::Ratio) => read(first).zip(other).map(|(a, b)| a / b),
            Some(Compare::Difference) => read(first).zip(other).map(|(a, b)| a - b),
        };
        let expected = 0.5 * (band.low + band.high);
        let error = got.map(|g| g - expected);
        let tolerance = 0.5 * (band.high - band.low);
        Verdict {
            name: self.file.name.clone(),
            source: self.file.source.clone(),
            quantity: band.quantity.clone(),
            unit: band.unit.clone(),
            expected,
            tolerance,
            got,
            error,
            pass: error.is_some_and(|e| e.abs() <= tolerance),
        }
    }
}

/// The summary of a recipe as JSON.
fn cooked(recipe: &Recipe, library: &Library) -> Result<serde_json::Value, InputError> {
    let line_one = |message: String| InputError {
        file: recipe.file.clone(),
        line: 1,
        message,
        remedy: "choose another size or kind of food or pan".into(),
    };
    let mut cook = Cook::new(recipe.clone(), library).map_err(|e| line_one(e.to_string()))?;
    while cook.stopped().is_none() {
        cook.advance()?;
    }
    serde_json::to_value(cook.summary(0.0)).map_err(|e| line_one(e.to_string()))
}
