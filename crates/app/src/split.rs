//! The look beside a view of a field: one scene, two ways to colour it.

use std::sync::Arc;

use crate::app::SauteApp;
use crate::scene::input::{Colouring, SceneInput};
use crate::view::View;

/// The same scene as the eye sees it.
pub(crate) fn as_look(input: &SceneInput) -> SceneInput {
    SceneInput { colouring: Colouring::Look, ..input.clone() }
}

/// The scenes of the panes, in their order: the look first where there are two.
pub(crate) fn scenes(input: SceneInput, split: bool) -> Vec<Arc<SceneInput>> {
    let look = split.then(|| Arc::new(as_look(&input)));
    look.into_iter().chain([Arc::new(input)]).collect()
}

impl SauteApp {
    /// The look beside the view, or the view alone; where only the look is shown, temperatures come beside it.
    pub(crate) fn toggle_split(&mut self) {
        self.settings.split = !self.settings.is_split();
        if self.settings.split && self.settings.view == View::Look {
            self.settings.view = View::Temperature;
        }
    }
}
