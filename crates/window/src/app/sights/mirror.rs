//! The window of the half mirror: the picture for the device, or the calibration pattern.

use crate::app::SauteApp;
use crate::app::on_host::OnHost;
use crate::mirror::view::MirrorView;

/// Size of the mirror's window before it fills a screen [points].
const WINDOW: [f32; 2] = [960.0, 540.0];

impl SauteApp {
    /// The mirror's window, while it is open: the picture and nothing else; the main window stays the operator's.
    pub(crate) fn show_mirror(&mut self, ctx: &egui::Context) {
        if !self.sights.mirror.open {
            return;
        }
        let title = self.settings.language.text("half_mirror.window");
        let builder = egui::ViewportBuilder::default()
            .with_title(title)
            .with_inner_size(WINDOW)
            .with_fullscreen(self.sights.mirror.full);
        ctx.show_viewport_immediate(egui::ViewportId::from_hash_of("mirror"), builder, |ui, class| {
            // A hand that is hurt stops its device wherever the keys go.
            self.take_stop(ui.ctx());
            if class == egui::ViewportClass::EmbeddedWindow {
                ui.set_min_size(WINDOW.into());
            } else {
                // The keys of a part of the main window are the main window's.
                self.sights.mirror.take_keys(ui);
            }
            let quality = self.quality();
            let scene = self.sights.scene.shown.clone();
            if self.drawable() {
                let l = self.settings.language;
                self.sights.mirror.show(ui, &mut self.settings.mirror, scene.as_deref(), quality, l);
            }
        });
    }

    /// Opens the mirror's window or closes it, and states how to use it.
    pub(crate) fn toggle_mirror(&mut self) {
        self.sights.mirror.open = !self.sights.mirror.open;
        self.sights.mirror.full = false;
        match self.sights.mirror.rig(&self.settings.mirror.rig) {
            Err(error) if self.sights.mirror.open => self.say_trouble(&error),
            Ok(_) if self.sights.mirror.open => self.say("half_mirror.opened"),
            _ => {}
        }
    }

    /// State of the mirror's window.
    pub fn mirror(&self) -> &MirrorView {
        &self.sights.mirror
    }
}
