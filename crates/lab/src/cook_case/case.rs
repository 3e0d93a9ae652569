//! A cook case: a recipe and the bands of its expected results.

use saute_food::Lab;
use serde::Deserialize;
use toml::Spanned;

use crate::cook_case::course::{Course, largest_rise};
use crate::{Evidence, Verdict};
use saute_kitchen::data::library::Library;
use saute_kitchen::{InputError, InputText};
use saute_recipe::cook::play::Cook;
use saute_recipe::recipe::Recipe;

/// The file format of a cook case, before any check.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct CookCaseFile {
    name: String,
    source: String,
    evidence: Evidence,
    recipe: Spanned<String>,
    /// A second recipe for comparison.
    against: Option<Spanned<String>>,
    #[serde(default)]
    expect: Vec<Spanned<BandEntry>>,
    #[serde(default)]
    seen: Vec<Seen>,
    #[serde(default)]
    course: Vec<Course>,
}

/// An expected colour in a picture of the end of the cook.
#[derive(Clone, Debug, Deserialize, PartialEq)]
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
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
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
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct BandEntry {
    quantity: String,
    pointer: String,
    unit: String,
    low: f64,
    high: f64,
    /// Comparison with the same number of the second recipe.
    compare: Option<Compare>,
}

/// Comparison of a number of the first recipe with that of the second.
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
    /// Parses and checks a case. `file` is the name in error messages.
    pub fn parse(text: &str, file: &str, library: &Library) -> Result<Self, InputError> {
        let input = InputText { text, file };
        let raw: CookCaseFile =
            input.parse("a cook case has name, source, evidence, recipe, [[expect]], [[seen]] and [[course]]")?;
        for band in &raw.expect {
            let b = band.get_ref();
            if b.compare.is_some() && raw.against.is_none() {
                let remedy = "add against = \"…\" with the second recipe, or leave compare out";
                return input.error(band.span().start, "compare needs a second recipe", remedy);
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

    /// Returns the kind of evidence for its expected values.
    pub fn evidence(&self) -> Evidence {
        self.file.evidence
    }

    /// Returns the expected colours in a picture.
    pub fn seen(&self) -> &[Seen] {
        &self.file.seen
    }

    /// Returns the verdict on a colour in a picture: its difference ΔE*ab from the expected one.
    pub fn verdict_on_colour(&self, seen: &Seen, shown: Lab) -> Verdict {
        let band = [-seen.delta_e, seen.delta_e];
        self.banded(&seen.quantity, "ΔE", band, Some(shown.difference(Lab(seen.lab))))
    }

    /// Returns the verdict on a value with a band from low to high; NaN fails.
    fn banded(&self, quantity: &str, unit: &str, [low, high]: [f64; 2], got: Option<f64>) -> Verdict {
        let (expected, tolerance) = (0.5 * (low + high), 0.5 * (high - low));
        let error = got.map(|g| g - expected);
        Verdict {
            name: self.file.name.clone(),
            source: self.file.source.clone(),
            evidence: Some(self.file.evidence),
            quantity: quantity.to_owned(),
            unit: unit.to_owned(),
            expected,
            tolerance,
            got,
            error,
            pass: self.file.evidence.judge(error.is_some_and(|e| e.abs() <= tolerance)),
        }
    }

    /// Returns the expected courses of colours.
    pub fn courses(&self) -> &[Course] {
        &self.file.course
    }

    /// Returns the verdicts on a course: its largest rise, and its total fall.
    pub fn verdicts_on_course(&self, course: &Course, read: &[f64]) -> [Verdict; 2] {
        let verdict =
            |quantity: String, band: [f64; 2], got: f64| self.banded(&quantity, course.of.unit(), band, Some(got));
        let (rise, fall) = (largest_rise(read), read.first().zip(read.last()).map_or(f64::NAN, |(a, b)| a - b));
        [
            verdict(format!("{}: never rises again", course.quantity), [-course.slack, course.slack], rise),
            verdict(format!("{}: falls in all", course.quantity), course.falls, fall),
        ]
    }

    /// Starts a cook of the recipe.
    pub fn begin(&self, library: &Library) -> Result<Cook, InputError> {
        begun(&self.recipe, library)
    }

    /// Returns true if a text is a cook case, false if it is a lab case.
    pub fn is_one(text: &str) -> bool {
        text.lines().any(|line| line.starts_with("recipe = "))
    }

    /// Cooks the recipes and returns the verdicts on all bands; a case that expects colours alone needs no cook here.
    pub fn verdicts(&self, library: &Library) -> Result<Vec<Verdict>, InputError> {
        if self.file.expect.is_empty() {
            return Ok(Vec::new());
        }
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
        self.banded(&band.quantity, &band.unit, [band.low, band.high], got)
    }
}

/// Returns the summary of a cooked recipe as JSON.
fn cooked(recipe: &Recipe, library: &Library) -> Result<serde_json::Value, InputError> {
    let summary = played(recipe, library)?.summary(0.0);
    serde_json::to_value(summary).map_err(|e| line_one(recipe, e.to_string()))
}

fn begun(recipe: &Recipe, library: &Library) -> Result<Cook, InputError> {
    Cook::new(recipe.clone(), library).map_err(|e| line_one(recipe, e.to_string()))
}

/// Returns a cook played to its end.
fn played(recipe: &Recipe, library: &Library) -> Result<Cook, InputError> {
    let mut cook = begun(recipe, library)?;
    while cook.stopped().is_none() {
        cook.advance()?;
    }
    Ok(cook)
}

fn line_one(recipe: &Recipe, message: String) -> InputError {
    let remedy = "choose another size or kind of food or pan".into();
    InputError { file: recipe.file.clone(), line: 1, message, remedy }
}
