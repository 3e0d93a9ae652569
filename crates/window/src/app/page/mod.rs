//! What the app does in a page: what the page hands in and keeps, its phone, and the panels as HTML.

mod hands;
mod inbox;
mod mirrored;
mod script;

use egui::{Context, Ui};
use saute_scene::mesh::strings::StringLook;
use saute_session::export::Export;
use saute_words::language::{Font, Language};

use super::SauteApp;
use super::on_host::OnHost;
use crate::host::HostStart;
use crate::start::DesktopOptions;
use crate::ui::layout::{Layout, Pane};
use saute_controls::act::HostAct;
use saute_controls::plan::PlanFile;

impl OnHost for SauteApp {
    /// A page has its own workers, sound and downloads.
    fn take_options(&mut self, _: DesktopOptions, _: &Context) {}

    fn settle_in(&mut self, start: HostStart, _: bool, ctx: &Context) {
        self.begin_page(start, ctx);
    }

    fn take_devices(&mut self, _: &Context) {
        self.take_tilt();
    }

    fn take_dropped_files(&mut self, ctx: &Context) {
        self.read_dropped_files(ctx);
    }

    fn take_news(&mut self, ctx: &Context) {
        self.take_inbox(ctx);
    }

    fn publish_frame(&mut self) {
        self.show_mirrored();
    }

    fn act_on_host(&mut self, act: HostAct, _: &Context) {
        match act {
            HostAct::TiltPhone => self.tilt_phone(),
            HostAct::Report => self.report_problem(),
        }
    }

    fn choose_file(&mut self, ctx: &Context) {
        self.open_dialog(ctx);
    }

    fn export(&mut self, what: Export, _: &Context) {
        self.download_export(what);
    }

    fn save_plan(&mut self, file: PlanFile, _: &Context) {
        self.download_plan(file);
    }

    fn take_picture(&mut self, ctx: &Context) {
        self.save_picture(ctx);
    }

    fn turn_photo_mode(&mut self, ctx: &Context) {
        self.save_picture(ctx);
    }

    /// A page reaches no device with a motor.
    fn stop_hands(&mut self) {}

    fn take_stop(&mut self, _: &Context) {}

    fn toggle_strings(&mut self) {}

    fn string_looks(&self) -> Vec<StringLook> {
        Vec::new()
    }

    fn show_strings(&self, _: &Ui, _: &Pane) {}

    fn make_room(&self, layout: Layout) -> Layout {
        layout
    }

    /// The page's script fetches the font.
    fn waits_for_font(&mut self, language: Language) -> bool {
        let waits = language.font() == Font::Japanese && !self.graphics.japanese_font;
        if waits {
            self.want_font();
        }
        waits
    }
}
