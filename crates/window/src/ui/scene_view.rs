//! The scene in the window: drawing, and the handle of the cut.

use crate::paint::scene::SceneRest;
use crate::ui::layout::Pane;
use egui::{Pos2, Rect, pos2};
use glam::Vec3;
use saute_controls::input::grab::Hold;
use saute_picture::stage::Pose;
use saute_recipe::probe::SeenPoint;
use saute_scene::input::SceneInput;
use std::collections::BTreeMap;
use std::sync::Arc;

/// State of the scene's part of the window.
#[derive(Clone, Debug, Default)]
pub struct SceneView {
    /// Size drawn last [pixels].
    pub drawn_size: [u32; 2],
    /// Where it was drawn last.
    pub(crate) pane: Option<Pane>,
    /// A waiting piece held by the mouse.
    pub(crate) carried: BTreeMap<String, Pose>,
    pub(crate) hold: Hold,
    /// The piece under the pointer.
    pub(crate) hovered: Option<String>,
    /// Where the pointer reads the scene, and true if it is a finger that was held still.
    pub(crate) reads_at: Option<(Pos2, bool)>,
    /// What the pointer is on.
    pub(crate) pointed: Option<SeenPoint>,
    /// True if the next click puts a probe in.
    pub(crate) placing: bool,
    /// The scene as it was drawn last.
    pub(crate) shown: Option<Arc<SceneInput>>,
    /// Whether its pictures are final.
    pub(crate) rest: SceneRest,
    /// True if the last frame left nothing to draw.
    pub(crate) rests: bool,
    /// The recipe of the condition that was taken on last, and the cook's generation.
    pub(crate) posed: Option<(String, u64)>,
}

pub(crate) fn ndc(at: Pos2, rect: Rect) -> [f32; 2] {
    [2.0 * (at.x - rect.left()) / rect.width() - 1.0, 1.0 - 2.0 * (at.y - rect.top()) / rect.height()]
}

pub(crate) fn on_screen(ndc: [f32; 2], rect: Rect) -> Pos2 {
    pos2(rect.left() + 0.5 * (ndc[0] + 1.0) * rect.width(), rect.top() + 0.5 * (1.0 - ndc[1]) * rect.height())
}

pub(crate) fn meet_height(origin: Vec3, direction: Vec3, z: f32) -> Option<Vec3> {
    let t = (z - origin.z) / direction.z;
    (t.is_finite() && t > 0.0).then(|| origin + direction * t)
}
