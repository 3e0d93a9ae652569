//! What is seen: the scene, the eye, ways side by side, pictures, the half mirror.

mod glance;
mod in_sight;
mod mirror;
mod pose;
mod quality;
mod save_picture;
mod scene_view;
mod ways_view;

use saute_picture::stage::Stage;
use saute_scene::camera::Camera;

use crate::mirror::view::MirrorView;
use crate::ui::scene_view::SceneView;
use crate::ui::ways_view::WaysView;
use saute_controls::eye::Glance;
use saute_picture::motion::Motions;

/// What is seen, and from where.
pub(crate) struct Sights {
    pub(crate) stage: Stage,
    pub(crate) camera: Camera,
    pub(crate) camera_preset: usize,
    /// Place of the cut (−1…1), or none.
    pub(crate) slice: Option<f64>,
    pub(crate) scene: SceneView,
    /// Ways side by side.
    pub(crate) ways: WaysView,
    /// Where the eye is on its way to.
    pub(crate) glance: Option<Glance>,
    /// The kitchen, by its number, whose food was looked for last.
    pub(crate) looked_for: Option<u64>,
    /// True while the eye is where it went by itself to see food beside the pan.
    pub(crate) stands_back: bool,
    /// True if time was turned since.
    pub(crate) looks_again: bool,
    /// The piece to which the eye turns once it lies on the board.
    pub(crate) taken_out: Option<String>,
    pub(crate) motions: Motions,
    pub(crate) mirror: MirrorView,
}

impl Default for Sights {
    fn default() -> Self {
        Self {
            stage: Stage::default(),
            camera: Camera::three_quarter(),
            camera_preset: 0,
            slice: None,
            scene: SceneView::default(),
            ways: WaysView::default(),
            glance: None,
            looked_for: None,
            looks_again: false,
            stands_back: false,
            taken_out: None,
            motions: Motions::default(),
            mirror: MirrorView::default(),
        }
    }
}
