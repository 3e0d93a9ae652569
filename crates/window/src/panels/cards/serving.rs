//! The food as it is served, beside the words of the result.

use std::sync::Arc;

use egui::{Rect, Sense, Ui, vec2};
use saute_scene::input::SceneInput;
use saute_scene::quality::Quality;

use crate::paint::scene::{SceneCallback, SceneRest};
use saute_words::judgement_words::ResultWords;
use saute_words::language::Language;

/// Its own place among the renderers of the scene.
const PANE: usize = 100;
/// Height over width (chosen: the plate fills it).
const SHAPE: f32 = 0.72;

/// A serving, and what it was put on the plate for.
pub struct Serving {
    /// The plate.
    pub input: Arc<SceneInput>,
    /// How it is drawn.
    pub quality: Quality,
    /// Samples of light that it gathers.
    pub samples: u32,
    /// Takes note while the picture is not final.
    pub rest: SceneRest,
    /// The result that it belongs to.
    pub words: ResultWords,
}

impl Serving {
    /// Shows it in a width [points].
    pub fn show(&self, ui: &mut Ui, width: f32, l: Language) {
        let (rect, response) = ui.allocate_exact_size(vec2(width, width * SHAPE), Sense::hover());
        response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Image, true, l.text("result.served")));
        ui.painter().add(egui_wgpu::Callback::new_paint_callback(rect, self.callback(rect, ui)));
    }

    fn callback(&self, rect: Rect, ui: &Ui) -> SceneCallback {
        let fineness = ui.ctx().pixels_per_point();
        let size = [rect.width(), rect.height()].map(|points| (points * fineness).round().max(1.0) as u32);
        SceneCallback {
            input: Arc::clone(&self.input),
            size,
            quality: self.quality,
            samples: self.samples,
            pane: PANE,
            rest: self.rest.clone(),
        }
    }
}
