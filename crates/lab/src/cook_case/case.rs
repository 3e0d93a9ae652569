//! Cooks with an answer from outside: a recipe and the bands in which its numbers should lie.

use saute_food::Lab;
use serde::Deserialize;
use toml::Spanned;

use crate::Verdict;
use crate::cook_case::course::{Course, largest_rise};
use saute_kitchen::data::library::Library;
use saute_kitchen::{InputError, InputText};
use saute_recipe::cook::play::Cook;
use saute_recipe::recipe::Recipe;

/// A cook case as it is written.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct CookCaseFile {
    name: String,
    source: String,
    recipe: Spanned<String>,
    /// A second recipe with which numbers are compared.
    against: Option<Spanned<String>>,
    #[serde(default)]
    expect: Vec<Spanned<BandEntry>>,
    #[serde(default)]
    seen: Vec<Seen>,
    #[serde(default)]
    course: Vec<Course>,
}

/// A colour that a picture should show, at the end of the cook.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Seen {
    /// What it is.
    pub quantity: String,
    /// Where it is looked for.
    pub place: SeenAt,
    /// L*, a*, b*.
    pub lab: [f64; 3],
    /// Largest ΔE*ab from it.
    pub delta_e: f64,
}

/// Where a colour is looked for on the first food.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum SeenAt {
    /// The middle of the face that lies above.
    Top,
    /// The middle of the face that lies below.
    Under,
    /// The middle of the cut.
    Cut,
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
        let raw: CookCaseFile =
            input.parse("a cook case has name, source, recipe, [[expect]], [[seen]] and [[course]]")?;
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

    /// The colours that a picture should show.
    pub fn seen(&self) -> &[Seen] {
        &self.file.seen
    }

    /// The verdict on a colour that a picture shows: its ΔE*ab from the expected one.
    pub fn verdict_on_colour(&self, seen: &Seen, shown: Lab) -> Verdict {
        let apart = shown.difference(Lab(seen.lab));
        Verdict {
            name: self.file.name.clone(),
            source: self.file.source.clone(),
            quantity: seen.quantity.clone(),
            unit: "ΔE".into(),
            expected: 0.0,
            tolerance: seen.delta_e,
            got: Some(apart),
            error: Some(apart),
            pass: apart <= seen.delta_e,
        }
    }

    /// The courses that colours should take.
    pub fn courses(&self) -> &[Course] {
        &self.file.course
    }

    /// The verdicts on a course: how far it ever went back, and where it led in all.
    pub fn verdicts_on_course(&self, course: &Course, read: &[f64]) -> [Verdict; 2] {
        let verdict = |quantity: String, [low, high]: [f64; 2], got: f64| {
            let expected = 0.5 * (low + high);
            let (tolerance, error) = (0.5 * (high - low), got - expected);
            Verdict {
                name: self.file.name.clone(),
                source: self.file.source.clone(),
                quantity,
                unit: course.of.unit().into(),
                expected,
                tolerance,
                got: Some(got),
                error: Some(error),
                // Not a number is no pass.
                pass: error.abs() <= tolerance,
            }
        };
        let (rise, fall) = (largest_rise(read), read.first().zip(read.last()).map_or(f64::NAN, |(a, b)| a - b));
        [
            verdict(format!("{}: never rises again", course.quantity), [-course.slack, course.slack], rise),
            verdict(format!("{}: falls in all", course.quantity), course.falls, fall),
        ]
    }

    /// Sets the recipe out.
    pub fn begin(&self, library: &Library) -> Result<Cook, InputError> {
        begun(&self.recipe, library)
    }

    /// Whether a text is a cook case rather than a lab case.
    pub fn is_one(text: &str) -> bool {
        text.lines().any(|line| line.starts_with("recipe = "))
    }

    /// Cooks and compares; a case without bands, which expects colours alone, needs no cook here.
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
    let summary = played(recipe, library)?.summary(0.0);
    serde_json::to_value(summary).map_err(|e| line_one(recipe, e.to_string()))
}

fn begun(recipe: &Recipe, library: &Library) -> Result<Cook, InputError> {
    Cook::new(recipe.clone(), library).map_err(|e| line_one(recipe, e.to_string()))
}

/// A recipe played to its end.
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
