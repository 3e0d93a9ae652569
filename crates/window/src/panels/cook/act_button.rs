//! Buttons that do an act.

use crate::bindings::hint;
use crate::panels::now::control_place;
use crate::ui::theme;
use egui::Ui;
use saute_controls::act::{Act, Acts};
use saute_controls::context::PanelContext;

pub(crate) fn button(
    state: &PanelContext,
    ui: &mut Ui,
    acts: &mut Acts,
    text: &str,
    on: bool,
    enabled: bool,
    act: Act,
) {
    if state.hides(&act) {
        return;
    }
    let enabled = enabled && !state.forbids(&act);
    let response = pressed(ui, text, on, enabled, &hint(&act, state.settings.language));
    let response = why_off(state, response, &act);
    control_place::note(ui, &act, response.rect);
    if response.clicked() {
        acts.push(act);
    }
}

/// Shows why a study or a lesson disables a button.
pub(crate) fn why_off(state: &PanelContext, response: egui::Response, act: &Act) -> egui::Response {
    match state.forbids(act) {
        true => response.on_disabled_hover_text(state.settings.language.text("guided.locked")),
        false => response,
    }
}

pub(crate) fn pressed(ui: &mut Ui, text: &str, on: bool, enabled: bool, hint: &str) -> egui::Response {
    let height = ui.spacing().interact_size.y;
    let response = ui.add_enabled(enabled, theme::of(ui).button(text, on).min_size(egui::vec2(height, height)));
    response.on_hover_text(hint)
}
