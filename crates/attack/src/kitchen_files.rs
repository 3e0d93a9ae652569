//! Recipes and data files of the kitchen.

use std::sync::LazyLock;

use saute_kitchen::heat::Soup;
use saute_kitchen::{Library, OwnFiles};
use saute_recipe::{Cook, Recipe};

use crate::ten_ticks::{check, fry, fry_shrimp};
use crate::text;

/// Spacing of the meshes of a recipe's pieces over the default [-], so that many inputs are tried.
const COARSE: f64 = 3.0;
/// Recipes with more pieces are read and checked only: each piece would be built in the same way.
const MOST_PIECES: usize = 3;

/// The shipped library.
pub static LIBRARY: LazyLock<Library> = LazyLock::new(|| Library::embedded().expect("the shipped files are sound"));

/// A recipe, cooked for ten ticks.
pub fn recipe(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    let Ok(mut recipe) = Recipe::parse(text, "recipe.toml", &LIBRARY) else { return };
    if recipe.foods.len() > MOST_PIECES {
        return;
    }
    recipe.foods.iter_mut().for_each(|food| food.coarseness = COARSE);
    let Ok(mut cook) = Cook::new(recipe, &LIBRARY) else { return };
    for _ in 0..10 {
        if cook.advance().is_err() {
            return;
        }
    }
    check(&cook.kitchen);
    let summary = cook.summary(0.0);
    serde_json::to_string(&summary).expect("a summary can be written");
}

/// Reads a file of the user's among the shipped ones; `None` if it is refused.
pub fn library_with(path: &str, text: &str, surface: Option<Soup>) -> Option<Library> {
    let path = path.to_owned();
    let surfaces = surface.map(|soup| (path.clone(), soup)).into_iter().collect();
    let own = OwnFiles { texts: [(path, text.to_owned())].into(), surfaces, ..OwnFiles::default() };
    let (library, faults) = Library::with_own(&own).expect("the shipped files are sound");
    faults.is_empty().then_some(library)
}

/// A food, fried for ten ticks; one that names a surface has that of `tetrahedron`.
pub fn food(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    if let Some(library) = library_with("foods/attacked.toml", text, Some(tetrahedron())) {
        fry(&library, "attacked");
    }
}

/// A pan with a shrimp in it.
pub fn pan(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    if let Some(library) = library_with("pans/attacked.toml", text, None) {
        fry_shrimp(&library, Some("attacked"), "canola");
    }
}

/// An oil under a shrimp; it takes the place of butter if it is an emulsion.
pub fn oil(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    if let Some(library) = library_with("oils/attacked.toml", text, None) {
        fry_shrimp(&library, None, "attacked");
    }
}

/// A change that shows which food's kinetics a text contains, their id, and a food that follows them.
const KINETICS: [(&str, &str, &str); 5] = [
    ("crustacyanin", "shrimp", "shrimp"),
    ("chlorophyll", "leek", "leek-ring"),
    ("pectin", "carrot", "carrot-coin"),
    ("collagen", "ground-beef", "beef-patty"),
    ("", "shrimp", "shrimp"),
];

/// Kinetics in the place of those of a food with the same changes.
pub fn kinetics(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    let Some((_, id, food)) = KINETICS.iter().find(|(change, ..)| text.contains(change)) else { return };
    if let Some(library) = library_with(&format!("kinetics/{id}.toml"), text, None) {
        fry(&library, food);
    }
}

/// A tetrahedron with legs of 7 mm.
fn tetrahedron() -> Soup {
    let vertices = vec![[0.0; 3], [7.0, 0.0, 0.0], [0.0, 7.0, 0.0], [0.0, 0.0, 7.0]];
    Soup { vertices, triangles: vec![[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]], unit_mm: 1.0 }
}
