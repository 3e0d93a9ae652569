//! The window in a stated condition: a recipe at an instant, with view, cut and camera. Pictures of it can be compared.

use saute_picture::view::View;
use saute_recipe::Recipe;
use saute_scene::quality::Quality;
use saute_schema::number_text::number_text;
use serde::Deserialize;

/// A condition of the window.
#[derive(Clone, Debug, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Pose {
    /// Id of a shipped recipe, or a recipe's text.
    pub recipe: String,
    /// Simulated time [s].
    pub at_s: f64,
    /// View that the colours show.
    pub view: View,
    /// True if the look is shown next to the view.
    pub split: bool,
    /// Place of the cut (−1…1), or none.
    pub cut: Option<f64>,
    /// Number of the camera: over the hob, above, close.
    pub camera: usize,
    /// Rendering quality.
    pub quality: Quality,
    /// True if the panels are shown.
    pub panels: bool,
}

impl Pose {
    /// Refuses an instant that a cook of the recipe does not reach.
    ///
    /// # Errors
    ///
    /// States the range of the instant.
    pub fn check(&self, recipe: &Recipe) -> Result<(), String> {
        if (0.0..=recipe.max_s).contains(&self.at_s) {
            return Ok(());
        }
        Err(format!("at_s may be 0 to {}", number_text(recipe.max_s)))
    }
}

impl Default for Pose {
    fn default() -> Self {
        Self {
            recipe: "medium".to_owned(),
            at_s: 0.0,
            view: View::Look,
            split: false,
            cut: None,
            camera: 0,
            quality: Quality::Quick,
            panels: false,
        }
    }
}
