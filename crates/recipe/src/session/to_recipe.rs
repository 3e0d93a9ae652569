//! A session as a recipe: what was done becomes steps at their times.

use std::collections::BTreeSet;
use std::fmt::Write;

use saute_kitchen::food::Rules;
use saute_kitchen::{Library, PieceOrder, TICK_S, celsius};
use saute_schema::InputError;
use serde_json::Value;

use crate::action::{Action, mm, tidy};
use crate::cook::play::Cook;
use crate::cook::step_record::StepRecord;
use crate::recipe::Recipe;
use crate::session::beginning::{FoodDetail, SetOutFood, head, write_food};
use crate::session::entry::Deed;
use crate::session::recording::Recording;

/// A session as a recipe.
#[derive(Clone, Debug, PartialEq)]
pub struct ToRecipe {
    /// Text of the recipe.
    pub text: String,
    /// What it cannot state, in words.
    pub left_out: Vec<String>,
}

/// Why a session is no recipe.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ToRecipeError {
    /// A food has no size that a recipe can state.
    #[error("the food \"{0}\" is not in the library: use the --data folder of the session")]
    NoSuchFood(String),
    /// The steps do not make a recipe.
    #[error("what was done is no recipe: {0}")]
    NoRecipe(#[from] InputError),
}

impl Cook {
    /// Returns the session, played to its end, as a recipe. A session without a hand's command is its own recipe; else the
    /// steps that were carried out follow at their times.
    ///
    /// # Errors
    ///
    /// If what was done breaks a rule of recipes.
    pub fn to_recipe(&self, library: &Library) -> Result<ToRecipe, ToRecipeError> {
        let Some(recording) = self.recording() else {
            return Ok(ToRecipe { text: self.runner.recipe().text.clone(), left_out: Vec::new() });
        };
        let steps = self.steps.iter().map(StepRecord::as_text).collect();
        Told { recording, begun: self.runner.recipe(), steps, end_s: self.kitchen.time_s() }.to_recipe(library)
    }
}

/// What a session states about its cook, for a recipe.
#[derive(Clone, Debug)]
pub struct Told<'a> {
    /// What was done.
    pub recording: &'a Recording,
    /// The recipe with which it began.
    pub begun: &'a Recipe,
    /// The steps in their order, as [`StepRecord::as_text`] writes them.
    pub steps: Vec<String>,
    /// Its end [s].
    pub end_s: f64,
}

impl Told<'_> {
    /// Returns it as a recipe: its own if no hand gave a command, else its steps at their times.
    ///
    /// # Errors
    ///
    /// If what was done breaks a rule of recipes.
    pub fn to_recipe(&self, library: &Library) -> Result<ToRecipe, ToRecipeError> {
        let Self { recording, begun, .. } = self;
        let beginning = recording.beginning();
        if beginning.plays && recording.entries().is_empty() {
            return Ok(ToRecipe { text: beginning.text.clone(), left_out: Vec::new() });
        }
        let end_s = TICK_S * libm::ceil(tidy(self.end_s / TICK_S));
        let max_s = (end_s + 1.0).clamp(1.0, 86_400.0);
        let mut text = {
            let (hob, pan_c) = (begun.hob_kind.as_deref(), tidy(celsius(begun.pan_temperature)));
            let preset = begun.foods.iter().any(|food| food.rules == Rules::Paper2013).then_some("preset = \"2013\"\n");
            preset.unwrap_or_default().to_owned() + &head(&begun.title, max_s, hob, &begun.pan_kind, pan_c)
        };
        let usual = 1e-3 * library.room.contact.oil_g;
        let _ = writeln!(text, "oil_g = {}", mm(begun.oil.unwrap_or(usual)));
        let mut orders: Vec<&PieceOrder> = begun.foods.iter().collect();
        orders.extend(recording.entries().iter().filter_map(|entry| match &entry.deed {
            Deed::Add(order) => Some(order),
            _ => None,
        }));
        foods(&orders, library)?.iter().for_each(|food| write_food(&mut text, food));
        self.steps.iter().for_each(|step| text.push_str(step));
        let _ = write!(text, "[[step]]\nat_s = {}\nend = true\n", tidy(end_s));
        Recipe::parse(&text, &beginning.file, library)?;
        Ok(ToRecipe { text, left_out: left_out(recording) })
    }
}

/// Returns the foods of a recipe: pieces of a group that follow each other become one entry.
fn foods(orders: &[&PieceOrder], library: &Library) -> Result<Vec<SetOutFood>, ToRecipeError> {
    let mut foods: Vec<SetOutFood> = Vec::new();
    for order in orders {
        let food = library.foods.get(&order.kind).ok_or_else(|| ToRecipeError::NoSuchFood(order.kind.clone()))?;
        let size_mm = food.form.dimensions_of(order.size.map(mm));
        let initial_c = tidy(celsius(order.temperature));
        let (id, number) = match order.id.rsplit_once('.') {
            Some((group, number)) => (group.to_owned(), number.parse::<usize>().ok()),
            None => (order.id.clone(), None),
        };
        match foods.last_mut().filter(|last| last.id == id) {
            Some(last) if number.is_some() => last.count = number,
            _ => foods.push(SetOutFood {
                id,
                kind: order.kind.clone(),
                size_mm,
                initial_c,
                seed: order.seed,
                count: number,
                detail: FoodDetail::of(order),
            }),
        }
    }
    Ok(foods)
}

impl StepRecord {
    /// Returns the step as a recipe states it; empty for the end, which a recipe has once.
    pub fn as_text(&self) -> String {
        if self.action == Action::End {
            return String::new();
        }
        let at_s = tidy(TICK_S * libm::ceil(tidy(self.time_s / TICK_S)));
        format!("[[step]]\nat_s = {at_s}\n{} = {}\n", self.action.name(), value_of(self))
    }
}

/// The value of a step's action, with its food.
fn value_of(step: &StepRecord) -> String {
    let value = step.action.value();
    let Some(target) = step.action.target() else { return inline(&table_of(&step.action, value)) };
    let food = ("food".to_owned(), Value::from(target.name.clone()));
    let rest = match (step.action.name(), value) {
        ("put", Value::Array(at)) => vec![("at_mm".to_owned(), Value::Array(at))],
        ("move", to) => vec![("to_mm".to_owned(), to)],
        ("rest", on) => vec![("on".to_owned(), on)],
        (_, Value::Object(entries)) => entries.into_iter().collect(),
        _ => Vec::new(),
    };
    inline(&Value::Object(std::iter::once(food).chain(rest).collect()))
}

/// The value of an action on the pan as a recipe takes it.
fn table_of(action: &Action, value: Value) -> Value {
    match (action.name(), value) {
        ("cool", for_s) => serde_json::json!({ "by": "wet-cloth", "for_s": for_s }),
        (_, value) => value,
    }
}

/// A JSON value as inline TOML, without null.
fn inline(value: &Value) -> String {
    match value {
        Value::Object(entries) => {
            let entries = entries.iter().filter(|(_, value)| !value.is_null());
            let entries: Vec<String> = entries.map(|(key, value)| format!("{key} = {}", inline(value))).collect();
            format!("{{ {} }}", entries.join(", "))
        }
        Value::Array(items) => format!("[{}]", items.iter().map(inline).collect::<Vec<_>>().join(", ")),
        Value::String(text) => toml::Value::String(text.clone()).to_string(),
        other => other.to_string(),
    }
}

/// What a recipe cannot state, in words.
fn left_out(recording: &Recording) -> Vec<String> {
    let mut words = BTreeSet::new();
    for entry in recording.entries() {
        match &entry.deed {
            Deed::Command(command) if Action::of_command(command).is_none() => {
                words.insert("motions of pan and tools in the hand".to_owned());
            }
            Deed::Remove(food) => {
                words.insert(format!("the removal of \"{food}\""));
            }
            _ => {}
        }
    }
    words.into_iter().collect()
}
