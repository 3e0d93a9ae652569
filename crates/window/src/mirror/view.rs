//! The window of the half mirror: the picture for the device, or the calibration pattern.

use super::aim::Aim;
use super::callback::MirrorCallback;
use super::pattern::Pattern;
use egui::{Color32, Key, Sense, Ui};
use glam::DVec2;
use saute_files::regular_file;
use saute_mirror::rig::Rig;
use saute_mirror::rig_file;
use saute_mirror::settings::MirrorSettings;
use saute_picture::mirrored::frame::MirrorFrame;
use saute_scene::input::SceneInput;
use saute_scene::quality::Quality;
use saute_words::language::Language;
use std::sync::Arc;

/// State of the mirror's window.
#[derive(Clone, Debug, Default)]
pub struct MirrorView {
    /// True if the window is open.
    pub open: bool,
    /// True if it fills its screen.
    pub full: bool,
    /// True if the pattern is shown instead of the picture.
    pub calibrating: bool,
    /// The mark that is moved.
    pub aim: Aim,
    /// Size drawn last [pixels].
    pub size: DVec2,
    /// The rig, and what it was read from.
    pub(crate) rig: Option<(String, Result<Arc<Rig>, String>)>,
}

impl MirrorView {
    /// The rig of the settings, read when it is another; or why it cannot be used.
    pub fn rig(&mut self, named: &str) -> Result<Arc<Rig>, String> {
        match &self.rig {
            Some((read, rig)) if read == named => rig.clone(),
            _ => {
                let rig = read(named).map(Arc::new);
                self.rig = Some((named.to_owned(), rig.clone()));
                rig
            }
        }
    }

    /// The rig that was read last, or why it cannot be used.
    pub fn rig_read(&self) -> Result<Arc<Rig>, String> {
        self.rig.as_ref().map_or_else(|| Err(String::new()), |(_, rig)| rig.clone())
    }

    /// Reads the rig's file again at the next frame.
    pub fn forget_rig(&mut self) {
        self.rig = None;
    }

    /// Shows the picture or the pattern over the whole of a window.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        settings: &mut MirrorSettings,
        scene: Option<&SceneInput>,
        quality: Quality,
        l: Language,
    ) {
        let rect = ui.max_rect();
        let response = ui.interact(rect, ui.scope_id().with("mirror"), Sense::click_and_drag());
        response.widget_info(|| {
            egui::WidgetInfo::labeled(egui::accesskit::Role::Canvas, true, l.text("half_mirror.spoken"))
        });
        ui.painter().rect_filled(rect, 0.0, Color32::BLACK);
        let scale = ui.ctx().pixels_per_point();
        self.size = DVec2::new(f64::from(rect.width() * scale), f64::from(rect.height() * scale)).round();
        if !self.calibrating && response.hovered() {
            ui.ctx().set_cursor_icon(egui::CursorIcon::None);
        }
        let Ok(rig) = self.rig(&settings.rig) else { return };
        // A window that is being made small has no pixels for a while.
        if self.size.min_element() < 1.0 {
            return;
        }
        let mut calibration = settings.calibration();
        if self.calibrating && self.aim.take(ui, &response, &mut calibration, &rig, self.size) {
            // Three corners on a line show nothing: such a move is not made.
            if calibration.fitted(&rig, self.size).is_some() {
                settings.keep(calibration.clone());
            } else {
                calibration = settings.calibration();
            }
        }
        let Some(fitted) = calibration.fitted(&rig, self.size) else { return };
        if self.calibrating {
            let Some(pixels) = calibration.pixels(&rig, self.size) else { return };
            let pattern = Pattern { rig: &rig, warp: &fitted.warp, pixels, chosen: self.aim.chosen };
            pattern.paint(ui.painter(), rect, scale);
        } else if let Some(scene) = scene {
            let frame = MirrorFrame::new(scene, &rig, &fitted.warp, &settings.options(&rig), self.size, quality);
            ui.painter().add(egui_wgpu::Callback::new_paint_callback(rect, MirrorCallback { frame }));
        }
    }

    /// F11 fills the screen, F10 calibrates, Esc closes.
    pub fn take_keys(&mut self, ui: &mut Ui) {
        let pressed = |ui: &Ui, key: Key| ui.input(|i| i.key_pressed(key));
        if pressed(ui, Key::F11) {
            self.full = !self.full;
        }
        if pressed(ui, Key::F10) {
            self.calibrating = !self.calibrating;
        }
        if pressed(ui, Key::Escape) || pressed(ui, Key::F9) || ui.input(|i| i.viewport().close_requested()) {
            (self.open, self.full, self.calibrating) = (false, false, false);
        }
    }
}

/// Longest rig file that is read [MiB] (chosen: a thousand times what one has).
const LARGEST_MIB: u64 = 1;

/// A shipped rig, else a file.
fn read(named: &str) -> Result<Rig, String> {
    if let Some(rig) = rig_file::shipped(named) {
        return rig.map_err(|e| e.to_string());
    }
    let text =
        regular_file::read_text(std::path::Path::new(named), LARGEST_MIB).map_err(|e| format!("{named}: {e}"))?;
    rig_file::parse(&text, named).map_err(|e| e.to_string())
}

/// Name of a stereo mode.
pub(crate) fn stereo_word(stereo: saute_mirror::stereo::Stereo, l: Language) -> &'static str {
    use saute_mirror::stereo::Stereo;
    l.text(match stereo {
        Stereo::Off => "half_mirror.mono",
        Stereo::Anaglyph => "half_mirror.anaglyph",
        Stereo::SideBySide => "half_mirror.side_by_side",
    })
}
