//! A cook case: a recipe and the bands of its expected results.

use saute_food::Lab;

use crate::cook_case::check::{Variant, checked, recipes};
use crate::cook_case::cooked::{Cooked, Reading, begun};
use crate::cook_case::course::{Course, largest_rise};
use crate::cook_case::file::{BandEntry, Compare, CookCaseFile, Seen};
use crate::cook_case::moment::Moment;
use crate::cook_case::sweep::TrendEntry;
use crate::{Evidence, Verdict};
use saute_kitchen::data::library::Library;
use saute_recipe::cook::play::Cook;
use saute_recipe::recipe::Recipe;
use saute_schema::{InputError, InputText};

/// A cook with expected bands, or a sweep of cooks with expected trends.
#[derive(Clone, Debug)]
pub struct CookCase {
    file: CookCaseFile,
    /// The recipe; in a sweep that of each value, for each value of `each`.
    recipes: Vec<Vec<Variant>>,
    against: Option<Recipe>,
}

impl CookCase {
    /// Parses and checks a case. `file` is the name in error messages.
    pub fn parse(text: &str, file: &str, library: &Library) -> Result<Self, InputError> {
        let raw = checked(InputText { text, file })?;
        let recipes = recipes(&raw, file, library)?;
        let second = raw.against.as_ref();
        let second = second.map(|text| Recipe::parse(text.get_ref(), &format!("{file}, against"), library));
        Ok(Self { against: second.transpose()?, file: raw, recipes })
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
            known_miss: None,
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

    /// Starts a cook of the recipe, in a sweep of its first value.
    pub fn begin(&self, library: &Library) -> Result<Cook, InputError> {
        // A case has at least one recipe.
        begun(&self.recipes[0][0].recipe, library)
    }

    /// Returns true if a text is a cook case, false if it is a lab case.
    pub fn is_one(text: &str) -> bool {
        text.lines().any(|line| line.starts_with("recipe = "))
    }

    /// Cooks the recipes and returns the verdicts on all bands and trends; a case that expects colours alone needs no
    /// cook here.
    pub fn verdicts(&self, library: &Library) -> Result<Vec<Verdict>, InputError> {
        if self.file.expect.is_empty() && self.file.trend.is_empty() {
            return Ok(Vec::new());
        }
        let moments = self.moments();
        let second = self.against.as_ref().map(|recipe| Cooked::new(recipe, library, &moments)).transpose()?;
        let mut verdicts = Vec::new();
        for along in &self.recipes {
            let cooked = along.iter().map(|variant| Cooked::new(&variant.recipe, library, &moments));
            let cooked: Vec<Cooked> = cooked.collect::<Result<_, _>>()?;
            for (variant, cooked) in along.iter().zip(&cooked) {
                let bands = self.file.expect.iter().map(toml::Spanned::get_ref);
                verdicts.extend(bands.map(|band| self.verdict(band, &variant.label, cooked, second.as_ref())));
            }
            let trends = self.file.trend.iter().map(toml::Spanned::get_ref);
            verdicts.extend(trends.map(|trend| self.verdict_on_trend(trend, along, &cooked)));
        }
        Ok(verdicts)
    }

    /// Returns the moments at which any band or trend reads the summary.
    fn moments(&self) -> Vec<Moment> {
        let bands = self.file.expect.iter().filter_map(|band| band.get_ref().at);
        bands.chain(self.file.trend.iter().filter_map(|trend| trend.get_ref().at)).collect()
    }

    fn verdict(&self, band: &BandEntry, label: &str, first: &Cooked, second: Option<&Cooked>) -> Verdict {
        let own = first.number(band.reading());
        let other = second.and_then(|cooked| cooked.number(band.reading()));
        let got = match band.compare {
            None => own,
            Some(Compare::Ratio) => own.zip(other).map(|(a, b)| a / b),
            Some(Compare::Difference) => own.zip(other).map(|(a, b)| a - b),
        };
        let quantity = if label.is_empty() { band.quantity.clone() } else { format!("{} ({label})", band.quantity) };
        let verdict = self.banded(&quantity, &band.unit, [band.low, band.high], got);
        Verdict { known_miss: band.known_miss(label, got), ..verdict }
    }

    /// Returns the verdict on the largest change against the direction of a trend.
    fn verdict_on_trend(&self, trend: &TrendEntry, along: &[Variant], cooked: &[Cooked]) -> Verdict {
        let values = cooked.iter().filter_map(|cooked| match is_judged(trend, cooked) {
            Some(false) => None,
            Some(true) => Some(cooked.number(trend.reading())),
            // A guard that the summary does not have fails.
            None => Some(None),
        });
        let values: Option<Vec<f64>> = values.collect();
        let relative = trend.slack_pct.is_some();
        let got = values.and_then(|values| trend.direction.largest_breach(&values, relative));
        let slack = trend.slack_pct.or(trend.slack).unwrap_or(0.0);
        let ends = along.first().zip(along.last()).map(|(a, b)| format!("{} to {}", a.label, b.label));
        let quantity = format!("{}: {} ({})", trend.quantity, trend.direction.promise(), ends.unwrap_or_default());
        self.banded(&quantity, if relative { "%" } else { &trend.unit }, [-slack, slack], got)
    }
}

/// Returns false for a cook whose guard is at its limit or beyond; none if it cannot be read.
fn is_judged(trend: &TrendEntry, cooked: &Cooked) -> Option<bool> {
    let Some(guard) = &trend.while_below else { return Some(true) };
    let reading = Reading { pointer: &guard.pointer, less: None, at: trend.at };
    cooked.number(reading).map(|value| value < guard.limit)
}
