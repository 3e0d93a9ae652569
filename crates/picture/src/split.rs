//! The look next to a view of a field: one scene, two ways to colour it.

use std::sync::Arc;

use saute_scene::input::{Colouring, SceneInput};

/// The same scene as the eye sees it.
pub fn as_look(input: &SceneInput) -> SceneInput {
    SceneInput { colouring: Colouring::Look, ..input.clone() }
}

/// The scenes of the panes, in their order: the look first where there are two.
pub fn scenes(input: SceneInput, split: bool) -> Vec<Arc<SceneInput>> {
    let look = split.then(|| Arc::new(as_look(&input)));
    look.into_iter().chain([Arc::new(input)]).collect()
}
