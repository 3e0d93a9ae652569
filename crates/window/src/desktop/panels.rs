//! What panels show that only a desktop has: devices, files by their paths, the photo mode.

use egui::{Ui, vec2};

use super::hand::{self, Choice};
use super::photo_bar;
use crate::host::CurrentHost;
use crate::ui::layout::Layout;
use saute_controls::act::{Act, Acts, AppAct, HostAct};
use saute_controls::context::PanelContext;
use saute_controls::spoken::notice::Said;

/// What was typed and chosen about a device.
pub(crate) type HostMemory = Choice;

/// Room for the foot of the help [points]: a window has none.
pub(crate) const FOOT: f32 = 0.0;

/// A window has no foot of the help.
pub(crate) fn foot(_: &PanelContext, _: &CurrentHost, _: &mut Ui, _: &mut Acts) {}

/// Shows the bar of the photo mode in place of all panels while it is open; returns true if it is.
pub(crate) fn show_instead(
    state: &PanelContext,
    host: &CurrentHost,
    ui: &Ui,
    acts: &mut Acts,
    layout: &Layout,
) -> bool {
    if host.photo.open {
        photo_bar::show(state, &host.photo, ui, acts, layout.whole);
    }
    host.photo.open
}

/// Shows the devices that are connected.
pub(crate) fn devices(state: &PanelContext, ui: &Ui, acts: &mut Acts, layout: &Layout) {
    hand::show(state, ui, acts, layout);
}

/// Shows how devices are connected.
pub(crate) fn device_settings(
    state: &PanelContext,
    memory: &mut HostMemory,
    ui: &mut Ui,
    acts: &mut Acts,
    is_narrow: bool,
) {
    hand::section(state, memory, ui, acts, is_narrow);
}

/// Returns true if a notice has a button.
pub(crate) fn has_button(said: &Said) -> bool {
    said.file.is_some()
}

/// Shows a button that shows the file of a sentence.
pub(crate) fn file_button(state: &PanelContext, ui: &mut Ui, acts: &mut Acts, said: &Said) {
    if let Some(file) = &said.file
        && ui.button(state.settings.language.text("messages.show")).clicked()
    {
        acts.push(Act::App(AppAct::Host(HostAct::ShowFile(file.clone()))));
    }
}

/// Lists the files that were opened before.
pub(crate) fn recent_files(state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
    for file in &state.settings.recent {
        let name = file.file_name().map_or_else(|| file.display().to_string(), |n| n.to_string_lossy().into_owned());
        let button = egui::Button::new(name).min_size(vec2(ui.available_width(), 34.0));
        if ui.add(button).on_hover_text(file.display().to_string()).clicked() {
            acts.push(Act::App(AppAct::Host(HostAct::OpenFile(file.clone()))));
        }
    }
}

/// No phone controls a window.
pub(crate) fn tilt_button(_: &PanelContext, _: &CurrentHost, _: &mut Ui, _: &mut Acts) {}
