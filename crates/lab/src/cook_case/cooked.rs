//! The readings of one cook: its summary at the end and at chosen moments.

use saute_kitchen::TICK_S;
use saute_kitchen::data::library::Library;
use saute_recipe::cook::play::Cook;
use saute_recipe::recipe::Recipe;
use saute_schema::InputError;
use serde_json::Value;

use crate::cook_case::file::BandEntry;
use crate::cook_case::moment::Moment;
use crate::cook_case::sweep::TrendEntry;

/// A number of the summary.
#[derive(Clone, Copy)]
pub(super) struct Reading<'a> {
    /// JSON pointer.
    pub pointer: &'a str,
    /// Pointer to a number that is subtracted.
    pub less: Option<&'a str>,
    /// Moment; the end of the cook by default.
    pub at: Option<Moment>,
}

impl BandEntry {
    pub(super) fn reading(&self) -> Reading<'_> {
        Reading { pointer: &self.pointer, less: self.less.as_deref(), at: self.at }
    }
}

impl TrendEntry {
    pub(super) fn reading(&self) -> Reading<'_> {
        Reading { pointer: &self.pointer, less: self.less.as_deref(), at: self.at }
    }
}

/// Summaries of one cook as JSON.
pub(super) struct Cooked {
    end: Value,
    at: Vec<(Moment, Value)>,
}

impl Cooked {
    /// Cooks a recipe to its end and keeps its summary at the moments.
    pub fn new(recipe: &Recipe, library: &Library, moments: &[Moment]) -> Result<Self, InputError> {
        let mut cook = begun(recipe, library)?;
        let mut at: Vec<(Moment, Value)> = Vec::new();
        while cook.stopped().is_none() {
            // The summary at a step is read as soon as the step has fired.
            cook.fire()?;
            let now = cook.kitchen.time_s() + 0.5 * TICK_S;
            for moment in moments.iter().filter(|m| m.time_s(&cook.steps).is_some_and(|time| time <= now)) {
                if at.iter().all(|(taken, _)| taken != moment) {
                    at.push((*moment, summary(recipe, &cook)?));
                }
            }
            cook.tick();
        }
        Ok(Self { end: summary(recipe, &cook)?, at })
    }

    /// Returns a number; none if the summary has none there, or the moment did not come.
    pub fn number(&self, reading: Reading<'_>) -> Option<f64> {
        let summary = match reading.at {
            None => &self.end,
            Some(moment) => &self.at.iter().find(|(taken, _)| *taken == moment)?.1,
        };
        let read = |pointer: &str| summary.pointer(pointer).and_then(Value::as_f64);
        let value = read(reading.pointer)?;
        Some(match reading.less {
            None => value,
            Some(other) => value - read(other)?,
        })
    }
}

/// Starts a cook.
pub(super) fn begun(recipe: &Recipe, library: &Library) -> Result<Cook, InputError> {
    Cook::new(recipe.clone(), library).map_err(|e| line_one(recipe, e.to_string()))
}

fn summary(recipe: &Recipe, cook: &Cook) -> Result<Value, InputError> {
    serde_json::to_value(cook.summary(0.0)).map_err(|e| line_one(recipe, e.to_string()))
}

fn line_one(recipe: &Recipe, message: String) -> InputError {
    let remedy = "choose another size or kind of food or pan".into();
    InputError { file: recipe.file.clone(), line: 1, message, remedy }
}
