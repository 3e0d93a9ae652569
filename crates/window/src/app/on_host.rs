//! What the app does differently on a desktop and in a page.

use egui::{Context, Ui};
use saute_scene::mesh::strings::StringLook;
use saute_session::export::Export;
use saute_words::language::Language;

use crate::host::HostStart;
use crate::start::DesktopOptions;
use crate::ui::layout::{Layout, Pane};
use saute_controls::act::HostAct;
use saute_controls::plan::PlanFile;

/// What the app does differently on a desktop and in a page; [`super::SauteApp`] does it once for each, and only one of both is compiled.
pub(crate) trait OnHost {
    /// Takes what a desktop lets the window use: threads, sound, a folder of pictures.
    fn take_options(&mut self, options: DesktopOptions, ctx: &Context);

    /// Sets the app up: connects devices, opens what an address names, keeps the cook if it `keeps` it.
    fn settle_in(&mut self, start: HostStart, keeps: bool, ctx: &Context);

    /// Reads the state of the devices, first of all in a frame.
    fn take_devices(&mut self, ctx: &Context);

    /// Opens files that were dropped on the window.
    fn take_dropped_files(&mut self, ctx: &Context);

    /// Takes what has come since the last frame: chosen files, pictures that are made, fonts.
    fn take_news(&mut self, ctx: &Context);

    /// Hands what a frame has shown to the host.
    fn publish_frame(&mut self);

    /// Carries out an act that only this host has.
    fn act_on_host(&mut self, act: HostAct, ctx: &Context);

    /// Opens a file dialog for a recipe, a session or a log.
    fn choose_file(&mut self, ctx: &Context);

    /// Saves a file that is made of the cook.
    fn export(&mut self, what: Export, ctx: &Context);

    /// Saves a file that is made of a plan.
    fn save_plan(&mut self, file: PlanFile, ctx: &Context);

    /// Saves a picture.
    fn take_picture(&mut self, ctx: &Context);

    /// Opens the photo mode or closes it; where there is none, saves a picture.
    fn turn_photo_mode(&mut self, ctx: &Context);

    /// Stops all devices until a hand resumes.
    fn stop_hands(&mut self);

    /// Stops the devices if the key for it was pressed.
    fn take_stop(&mut self, ctx: &Context);

    /// Shows the strings of a device, or hides them.
    fn toggle_strings(&mut self);

    /// The strings above the worktop, for the scene.
    fn string_looks(&self) -> Vec<StringLook>;

    /// Draws what the scene does not show of the strings.
    fn show_strings(&self, ui: &Ui, pane: &Pane);

    /// Makes room for what is shown of devices.
    fn make_room(&self, layout: Layout) -> Layout;

    /// Returns true if a language cannot be shown yet; its font is then requested.
    fn waits_for_font(&mut self, language: Language) -> bool;
}
