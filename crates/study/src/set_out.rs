//! What a study or a lesson sets out: pan and food, by a recipe, a scenario, or their own keys.

use saute_kitchen::Library;
use saute_recipe::Recipe;
use saute_recipe::session::{SetOutFood, set_out};
use saute_schema::{InputError, InputText};
use toml::Spanned;

use crate::class::shipped;

/// What is set out.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum SetOut {
    /// Pan and food of a recipe of the library, with the place of its name in the text.
    Recipe(String, usize),
    /// Those of a text.
    Text(String),
    /// Those of a shipped scenario.
    Scenario(&'static str, usize),
}

impl SetOut {
    /// What a recipe or a scenario names; one of the two. `at` is the place of their table.
    pub(crate) fn named(
        input: InputText,
        at: usize,
        recipe: Option<&Spanned<String>>,
        scenario: Option<&Spanned<String>>,
    ) -> Result<Self, InputError> {
        match (recipe, scenario) {
            (Some(recipe), None) => Ok(Self::Recipe(recipe.get_ref().clone(), recipe.span().start)),
            (None, Some(scenario)) => {
                let (name, at) = (scenario.get_ref(), scenario.span().start);
                match shipped::text(name) {
                    Some(text) => Ok(Self::Scenario(text, at)),
                    None => {
                        let message = format!("scenario = \"{name}\" is no shipped scenario");
                        input.error(at, message, format!("use one of: {}", shipped::names()))
                    }
                }
            }
            _ => input.error(
                at,
                "one of recipe and scenario is needed",
                "write recipe = \"medium\" or scenario = \"first-steak\"",
            ),
        }
    }

    /// Pan and one food of the library.
    pub(crate) fn food(title: &str, pan: (&str, f64), food: &SetOutFood) -> Self {
        Self::Text(set_out(title, None, pan.0, pan.1, std::slice::from_ref(food)))
    }

    /// The recipe whose pan and food are set out.
    pub(crate) fn recipe(&self, input: InputText, library: &Library) -> Result<Recipe, InputError> {
        match self {
            Self::Recipe(name, at) => {
                let Some(text) = library.recipes.get(name) else {
                    let remedy = format!("use one of: {}", Library::names(&library.recipes));
                    return input.error(*at, format!("recipe = \"{name}\" is not a recipe"), remedy);
                };
                Recipe::parse(text, name, library)
            }
            Self::Text(text) => Recipe::parse(text, input.file, library),
            Self::Scenario(text, _) => {
                let scenario = crate::class::Scenario::parse(text, input.file, library)?;
                Ok(Recipe::clone(&scenario.recipe))
            }
        }
    }
}
