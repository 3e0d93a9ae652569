//! Fineness of the meshes on which a fit cooks.

use saute_recipe::Recipe;

/// Mesh spacing of the first rounds, relative to the default [-] (chosen: a cook is about ten times as fast, and its core
/// temperature within 1 K of the default mesh's; the last rounds use the default).
const COARSE: f64 = 2.0;

/// Fineness of the meshes on which a fit cooks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// For the first rounds.
    Coarse,
    /// That of the recipe.
    Full,
}

impl Level {
    /// Sets the fineness of the foods of a recipe.
    pub(super) fn set_in(self, recipe: &mut Recipe) {
        if self == Self::Coarse {
            recipe.foods.iter_mut().for_each(|food| food.coarseness = food.coarseness.max(COARSE));
        }
    }
}
