//! The native window.

use crate::app::SauteApp;
use crate::desktop::system::NAME;
use crate::start::Start;
use saute_controls::settings::stored_zoom;

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
