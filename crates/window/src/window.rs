//! The native window.

use crate::app::{SauteApp, Start};
use crate::ui::stored_zoom;

/// What a start says about the world around the window.
pub(crate) struct Surroundings {
    hands: crate::hand::HandsStart,
    /// True if the cook is kept: a recipe or a session that is named is what the person wants.
    keeps: bool,
}

impl Surroundings {
    pub fn of(start: &Start, remembers: bool) -> Self {
        let keeps = remembers && start.recipe.is_none() && start.recorded.is_none();
        Self { hands: start.hands.clone(), keeps }
    }
}

impl SauteApp {
    /// Connects devices, and keeps the cook in the user's folder.
    pub(crate) fn settle_in(&mut self, around: Surroundings, _: &egui::Context) {
        let folder = eframe::storage_dir(NAME);
        self.session.hands.folder = folder.as_ref().map(|folder| folder.join("calibrations"));
        self.begin_hands(around.hands);
        if let Some(folder) = folder.filter(|_| around.keeps) {
            self.keep_cook_in(&folder.join("cook.saute"));
        }
    }
}

/// A window has no address.
pub(crate) fn page_address() -> Option<String> {
    None
}

/// Without an address there is nothing to copy.
pub(crate) fn copy_text(_: &SauteApp, _: String) {}

/// Name of the program, after which eframe names the folder of its settings.
const NAME: &str = "saute";

/// Opens the window and stays until it is closed.
pub fn run(start: Start) -> eframe::Result {
    if let Some(folder) = eframe::storage_dir(NAME) {
        stored_zoom::mend(&folder);
    }
    let options = eframe::NativeOptions {
        viewport: egui::ViewportBuilder::default()
            .with_title(NAME)
            .with_app_id(NAME)
            .with_inner_size([1280.0, 720.0])
            .with_min_inner_size([360.0, 560.0]),
        renderer: eframe::Renderer::Wgpu,
        // The scene dithers itself and the panels are flat: on a software rasteriser egui's own costs frames.
        dithering: false,
        ..Default::default()
    };
    eframe::run_native(NAME, options, Box::new(|cc| Ok(Box::new(SauteApp::new(cc, start)?))))
}
