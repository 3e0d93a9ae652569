//! What panels show that only a page has: its foot, and the phone that holds the pan.

use egui::{RichText, Ui};

use crate::host::CurrentHost;
use crate::panels::cards::setting_row::explained;
use crate::ui::layout::Layout;
use crate::ui::theme;
use saute_controls::act::{Act, Acts, AppAct, HostAct};
use saute_controls::context::PanelContext;
use saute_controls::spoken::notice::Said;

/// A page keeps nothing about devices.
pub(crate) type HostMemory = ();

/// Room for the foot of the help [points].
pub(crate) const FOOT: f32 = 56.0;

/// Shows guides, version and privacy.
pub(crate) fn foot(state: &PanelContext, host: &CurrentHost, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    ui.separator();
    ui.horizontal_wrapped(|ui| {
        ui.add(egui::Hyperlink::from_label_and_url(l.text("page.guides"), "docs/index.html").open_in_new_tab(true));
        if ui.add(theme::of(ui).button(l.text("page.report"), false)).clicked() {
            acts.push(Act::App(AppAct::Host(HostAct::Report)));
        }
        let version = l.fill("page.version", &[("version", &host.version)]);
        let text = format!("{version} · {}", l.text("page.private"));
        ui.label(RichText::new(text).size(13.0).color(theme::of(ui).quiet));
    });
}

/// A page has no photo mode.
pub(crate) fn show_instead(_: &PanelContext, _: &CurrentHost, _: &Ui, _: &mut Acts, _: &Layout) -> bool {
    false
}

/// A page reaches no device.
pub(crate) fn devices(_: &PanelContext, _: &Ui, _: &mut Acts, _: &Layout) {}

/// Shows that a page reaches no device.
pub(crate) fn device_settings(state: &PanelContext, _: &mut HostMemory, ui: &mut Ui, _: &mut Acts, is_narrow: bool) {
    explained(ui, is_narrow, state.settings.language.text("settings.native_only"));
}

/// Notices of a page have no button.
pub(crate) fn has_button(_: &Said) -> bool {
    false
}

/// A page cannot show a file.
pub(crate) fn file_button(_: &PanelContext, _: &mut Ui, _: &mut Acts, _: &Said) {}

/// The paths of files are unknown to a page.
pub(crate) fn recent_files(_: &PanelContext, _: &mut Ui, _: &mut Acts) {}

/// Shows whether the phone holds the pan, where it can.
pub(crate) fn tilt_button(state: &PanelContext, host: &CurrentHost, ui: &mut Ui, acts: &mut Acts) {
    if !host.can_tilt() {
        return;
    }
    let l = state.settings.language;
    let button = theme::of(ui).button(l.text("pour.tilt"), state.session.hands.phone.is_some());
    if ui.add(button).on_hover_text(l.text("pour.tilt_hint")).clicked() {
        acts.push(Act::App(AppAct::Host(HostAct::TiltPhone)));
    }
}
