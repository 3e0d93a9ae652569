//! What the app does on a desktop.

mod cook_file;
mod devices;
mod files;
mod photo;
mod strings;

use std::sync::Arc;

use egui::{Context, Ui};
use saute_haptics::control::scheduling::yield_to_others;
use saute_scene::mesh::strings::StringLook;
use saute_session::export::Export;
use saute_session::work::thread::Threads;
use saute_words::language::Language;

use super::SauteApp;
use super::on_host::OnHost;
use crate::desktop::files::Asked;
use crate::desktop::hand;
use crate::desktop::photo::PhotoMode;
use crate::desktop::system::NAME;
use crate::host::HostStart;
use crate::start::DesktopOptions;
use crate::ui::layout::{Layout, Pane};
use saute_controls::act::HostAct;
use saute_controls::hands::GamepadDevice;
use saute_controls::plan::PlanFile;

impl SauteApp {
    /// The photo mode.
    pub fn photo_mode(&self) -> &PhotoMode {
        &self.host.photo
    }
}

impl OnHost for SauteApp {
    fn take_options(&mut self, options: DesktopOptions, ctx: &Context) {
        (self.host.pictures, self.host.may_sound) = (options.pictures, options.speaker);
        if options.threads {
            let ctx = ctx.clone();
            self.employ(Box::new(Threads::new(Arc::new(move || ctx.request_repaint()), yield_to_others)));
        }
    }

    fn settle_in(&mut self, start: HostStart, keeps: bool, _: &Context) {
        self.host.pad = GamepadDevice::connect();
        let folder = eframe::storage_dir(NAME);
        self.session.hands.folder = folder.as_ref().map(|folder| folder.join("calibrations"));
        self.begin_hands(start);
        if let Some(folder) = folder.filter(|_| keeps) {
            self.keep_cook_in(&folder.join("cook.saute"));
        }
    }

    /// While a device is connected, Enter stops it, whichever widget has the focus.
    fn take_devices(&mut self, ctx: &Context) {
        if self.session.hands.any() {
            self.take_stop(ctx);
            self.read_devices(ctx);
        }
    }

    fn take_dropped_files(&mut self, ctx: &Context) {
        for file in ctx.input(|i| i.raw.dropped_files.clone()) {
            self.take_file(&file.path().display().to_string(), file.bytes());
        }
    }

    fn take_news(&mut self, _: &Context) {
        self.take_chosen_file();
        self.take_photo_made();
    }

    /// Nothing reads a window on a desktop.
    fn publish_frame(&mut self) {}

    fn act_on_host(&mut self, act: HostAct, ctx: &Context) {
        match act {
            HostAct::OpenFile(path) => self.open_file(&path),
            HostAct::ShowFile(path) => self.show_file(&path),
            HostAct::ResumeHands => self.resume_hands(),
            HostAct::Connect { role, device, pairing } => self.connect_hand(role, &device, pairing),
            HostAct::Disconnect(role) => self.session.hands.disconnect(role),
            HostAct::SetPhoto(choice) => self.host.photo.choice = choice,
            HostAct::TimeLapse => self.make_time_lapse(ctx),
        }
    }

    fn choose_file(&mut self, ctx: &Context) {
        self.ask(Asked::Open, ctx);
    }

    fn export(&mut self, what: Export, ctx: &Context) {
        self.ask(Asked::Save(what), ctx);
    }

    fn save_plan(&mut self, file: PlanFile, ctx: &Context) {
        self.ask(Asked::SavePlan(file), ctx);
    }

    fn take_picture(&mut self, ctx: &Context) {
        match self.host.photo.open {
            true => self.take_photo(ctx),
            false => self.save_picture(ctx),
        }
    }

    fn turn_photo_mode(&mut self, _: &Context) {
        self.host.photo.open = !self.host.photo.open;
    }

    fn stop_hands(&mut self) {
        if self.session.hands.any() {
            self.session.hands.stop();
            self.say("notice.hands_stopped");
        }
    }

    fn take_stop(&mut self, ctx: &Context) {
        if self.session.hands.any() && ctx.input_mut(devices::enter) {
            self.stop_hands();
        }
    }

    fn toggle_strings(&mut self) {
        self.turn_strings();
    }

    fn string_looks(&self) -> Vec<StringLook> {
        self.strings_now().iter().map(hand::strings_view::Seen::look).collect()
    }

    fn show_strings(&self, ui: &Ui, pane: &Pane) {
        self.draw_strings(ui, pane);
    }

    fn make_room(&self, layout: Layout) -> Layout {
        hand::make_room(layout, &self.session.hands)
    }

    /// A desktop has its fonts from the start.
    fn waits_for_font(&mut self, _: Language) -> bool {
        false
    }
}
