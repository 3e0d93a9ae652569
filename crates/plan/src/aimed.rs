//! A goal of the library with the scale that a study or a lesson judges it on.

use std::sync::Arc;

use saute_kitchen::Library;
use saute_kitchen::data::goals::GoalDescription;
use saute_kitchen::data::library::DEFAULT_SCALE;
use saute_kitchen::food::Scale;
use saute_recipe::Recipe;
use saute_schema::{InputError, InputText};
use toml::Spanned;

use crate::goal::Goal;

/// A goal with the scale that it is judged on.
#[derive(Clone, Debug)]
pub struct Aimed {
    /// The goal.
    pub goal: Arc<GoalDescription>,
    /// Its scale: its own, else the usual one if it has the class, else the first that has it.
    pub scale: Arc<Scale>,
    /// The goal as a cook is judged by it.
    pub judged: Goal,
}

impl Aimed {
    /// Returns a goal of the library by its id; none if it is unknown.
    pub fn of(library: &Library, id: &str) -> Option<Self> {
        let goal = library.goal(id)?;
        let mut scales = library.scales.iter().filter(|scale| goal.is_on(scale));
        let usual = library.scale(DEFAULT_SCALE).filter(|scale| goal.is_on(scale));
        let scale = usual.or_else(|| scales.next())?;
        let judged = Goal::described(goal, scale).ok()?;
        Some(Self { goal: Arc::clone(goal), scale: Arc::clone(scale), judged })
    }

    /// Returns the goal that a key of a text names.
    ///
    /// # Errors
    ///
    /// Names the known goals if there is none of that name.
    pub fn named(input: InputText, library: &Library, key: &str, id: &Spanned<String>) -> Result<Self, InputError> {
        let (name, at) = (id.get_ref(), id.span().start);
        if let Some(aimed) = Self::of(library, name) {
            return Ok(aimed);
        }
        let known: Vec<&str> = library.goals.iter().map(|goal| goal.id.as_str()).collect();
        input.error(at, format!("{key} = \"{name}\" is not a goal"), format!("use one of: {}", known.join(", ")))
    }

    /// Checks that the goal states something about every food of a recipe, and that there is one.
    ///
    /// # Errors
    ///
    /// Names the goals that fit if this one does not.
    pub fn check_fits(
        &self,
        input: InputText,
        library: &Library,
        id: &Spanned<String>,
        recipe: &Recipe,
    ) -> Result<(), InputError> {
        let foods = recipe.foods.iter().filter_map(|order| library.foods.get(&order.kind));
        let kinetics: Vec<&str> = foods.map(|food| food.kinetics.as_str()).collect();
        if !kinetics.is_empty() && kinetics.iter().all(|kinetics| self.goal.is_for(kinetics)) {
            return Ok(());
        }
        let fits = library.goals.iter().filter(|goal| kinetics.iter().all(|kinetics| goal.is_for(kinetics)));
        let known: Vec<&str> = fits.map(|goal| goal.id.as_str()).collect();
        let message = format!("goal = \"{}\" does not fit the food", id.get_ref());
        input.error(id.span().start, message, format!("use one of: {}", known.join(", ")))
    }

    /// Names of the classes of its scale.
    pub fn classes(&self) -> Vec<String> {
        self.scale.class.iter().map(|class| class.name.clone()).collect()
    }
}
