//! Checks a scenario file: what parses must also be possible.

use std::sync::Arc;

use saute_kitchen::{Library, kelvin};
use saute_recipe::session::{FoodDetail, SetOutFood};
use saute_schema::{InputError, InputText};
use toml::Spanned;

use super::result_row::MOST_QUESTIONS;
use super::scenario::{Ask, Predict, Scenario, When, Words};
use super::scenario_file::{AskKind, PredictEntry, ScenarioFile, SetOutEntry};
use crate::protocol_file::Information;
use crate::set_out::SetOut;
use saute_plan::Aimed;

/// Longest lesson unless the scenario states another one [s].
const USUAL_MAX_S: f64 = 1800.0;
/// How far ahead a question looks unless it states a time [s].
const USUAL_AHEAD_S: f64 = 120.0;
/// Longest title and introduction [letters] (chosen: what is read on a phone without scrolling far).
const LONGEST: [usize; 2] = [80, 1200];
/// Pan, its temperature and that of the food unless the scenario states others.
const PAN: &str = "carbon-steel-26";
const PAN_C: f64 = 20.0;
const FOOD_C: f64 = 5.0;

/// A scenario's text and the library with what it can name.
pub(super) struct Check<'a> {
    pub(super) input: InputText<'a>,
    pub(super) library: &'a Library,
}

type Checked<T> = Result<T, InputError>;

impl Check<'_> {
    pub(super) fn scenario(&self) -> Checked<Scenario> {
        if self.input.text.trim().is_empty() {
            return self.input.error(0, "the file is empty", "start from a shipped scenario: saute list scenarios");
        }
        let raw: ScenarioFile = self.input.parse("the keys and their types are listed by: saute schema scenario")?;
        self.id(&raw.id)?;
        let title = self.words("title", &raw.title, raw.title_ja.as_ref(), LONGEST[0])?;
        let intro = self.words("intro", &raw.intro, raw.intro_ja.as_ref(), LONGEST[1])?;
        let recipe = self.set_out(&raw)?.recipe(self.input, self.library)?;
        let goal = Aimed::named(self.input, self.library, "goal", &raw.goal)?;
        goal.check_fits(self.input, self.library, &raw.goal, &recipe)?;
        if raw.predict.len() > MOST_QUESTIONS {
            let at = raw.predict[MOST_QUESTIONS].span().start;
            return self.input.error(
                at,
                "predict is there too often",
                format!("ask {MOST_QUESTIONS} questions at most"),
            );
        }
        Ok(Scenario {
            id: raw.id.get_ref().clone(),
            title,
            intro,
            recipe: Arc::new(recipe),
            goal,
            locked: raw.lock.iter().copied().collect(),
            overlays: raw.overlays.unwrap_or(Information::Shown),
            speed: raw.speed.as_ref().map_or(1.0, |speed| *speed.get_ref()),
            max_s: raw.max_s.as_ref().map_or(USUAL_MAX_S, |s| *s.get_ref()),
            predictions: raw.predict.iter().map(|entry| self.predict(entry)).collect::<Checked<_>>()?,
            checksum: crc32fast::hash(self.input.text.as_bytes()),
        })
    }

    fn set_out(&self, raw: &ScenarioFile) -> Checked<SetOut> {
        match (&raw.recipe, &raw.set_out) {
            (Some(recipe), None) => SetOut::named(self.input, recipe.span().start, Some(recipe), None),
            (None, Some(entry)) => self.food(entry.get_ref(), raw.title.get_ref()),
            _ => self.input.error(
                raw.id.span().start,
                "one of recipe and [set_out] is needed",
                "write recipe = \"medium\", or [set_out] with food",
            ),
        }
    }

    fn food(&self, entry: &SetOutEntry, title: &str) -> Checked<SetOut> {
        let SetOutEntry { food, size_mm, initial_c, pan, preheat_c } = entry;
        let Some(description) = self.library.foods.get(food.get_ref()) else {
            let message = format!("food = \"{}\" is not a food", food.get_ref());
            let remedy = format!("use one of: {}", Library::names(&self.library.foods));
            return self.input.error(food.span().start, message, remedy);
        };
        let pan = pan.as_deref().unwrap_or(PAN);
        if !self.library.pans.contains_key(pan) {
            let remedy = format!("use one of: {}", Library::names(&self.library.pans));
            return self.input.error(food.span().start, format!("pan = \"{pan}\" is not a pan"), remedy);
        }
        let food = SetOutFood {
            id: description.piece_id(food.get_ref()),
            kind: food.get_ref().clone(),
            size_mm: size_mm.clone().unwrap_or_else(|| description.size.default_mm.clone()),
            initial_c: initial_c.unwrap_or(FOOD_C),
            seed: 1,
            count: None,
            detail: FoodDetail::default(),
        };
        Ok(SetOut::food(title, (pan, preheat_c.unwrap_or(PAN_C)), &food))
    }

    fn predict(&self, entry: &Spanned<PredictEntry>) -> Checked<Predict> {
        let (raw, at) = (entry.get_ref(), entry.span().start);
        let after_s = raw.after_s.as_ref().map_or(0.0, |s| *s.get_ref());
        let when = match (&raw.at_s, &raw.core_c, raw.after) {
            (Some(s), None, None) => When::At(*s.get_ref()),
            (None, Some(c), None) => When::Core(kelvin(*c.get_ref())),
            (None, None, Some(deed)) => When::After(deed, after_s),
            _ => {
                return self.input.error(
                    at,
                    "predict does not say when, or says it twice",
                    "write one of at_s, core_c and after",
                );
            }
        };
        let ask = match raw.ask {
            AskKind::CoreNow => Ask::CoreNow,
            AskKind::CoreIn => Ask::CoreIn(raw.in_s.as_ref().map_or(USUAL_AHEAD_S, |s| *s.get_ref())),
            AskKind::CorePeak => Ask::CorePeak,
            AskKind::UndersideBrown => Ask::UndersideBrown,
            AskKind::ClassInTheEnd => Ask::ClassInTheEnd,
        };
        Ok(Predict { when, ask, text: Words::new(raw.text.as_deref().unwrap_or_default(), raw.text_ja.as_deref()) })
    }

    fn id(&self, id: &Spanned<String>) -> Checked<()> {
        let plain = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
        let (name, at) = (id.get_ref(), id.span().start);
        if (1..=40).contains(&name.len()) && name.chars().all(plain) {
            return Ok(());
        }
        self.input.error(at, format!("id = \"{name}\" cannot be used"), "write 1 to 40 letters, digits, - and _")
    }

    fn words(&self, key: &str, en: &Spanned<String>, ja: Option<&String>, longest: usize) -> Checked<Words> {
        let count = en.get_ref().trim().chars().count();
        if !(1..=longest).contains(&count) {
            let remedy = format!("{key} may have 1 to {longest} letters");
            return self.input.error(en.span().start, format!("{key} has {count} letters"), remedy);
        }
        Ok(Words::new(en.get_ref().trim(), ja.map(|text| text.trim())))
    }
}
