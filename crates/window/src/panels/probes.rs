//! The probes in the food: their values, names, and the way to put one in or take one out.

use egui::{RichText, Ui, vec2};

use crate::bindings::key_of;
use crate::ui::{fingers, theme};
use saute_controls::act::{Act, Acts, ViewAct};
use saute_controls::context::PanelContext;

/// A button after which the next click on the food puts a probe in; `placing` is true until then.
pub fn add_button(state: &PanelContext, placing: bool, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    let text = RichText::new(l.text(if placing { "probe.click" } else { "probe.add" })).size(13.0);
    let add = ui.add(egui::Button::new(text).selected(placing));
    if add.on_hover_text(l.fill("probe.add_hint", &[("key", &key_of(&Act::View(ViewAct::Probe)))])).clicked() {
        acts.push(Act::View(ViewAct::Placing(!placing)));
    }
}

/// Shows the probes of the piece that the panels are about.
pub fn show(state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
    let Some(piece) = state.session.shown_piece() else { return };
    let words = |p: &saute_recipe::probe::Probe| state.settings.fine_temperature(p.celsius(piece));
    let shown: Vec<(usize, String)> =
        state.session.probes.of(piece).map(|p| (p.number, format!("{} · {}", p.number, words(p)))).collect();
    if shown.is_empty() {
        return;
    }
    ui.spacing_mut().interact_size.y = fingers::height(ui, 24.0);
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = vec2(4.0, 4.0);
        ui.spacing_mut().button_padding = vec2(7.0, 3.0);
        for (number, text) in shown {
            let on = state.session.probes.selected == Some(number);
            let text = RichText::new(text).size(13.0).color(theme::of(ui).probe(number));
            let chip =
                ui.add(egui::Button::new(text).stroke(egui::Stroke::new(f32::from(u8::from(on)), theme::of(ui).text)));
            if chip.on_hover_text(state.settings.language.text("probe.chip_hint")).clicked() {
                acts.push(Act::View(ViewAct::SelectProbe((!on).then_some(number))));
            }
        }
    });
    edit(state, ui, acts);
}

/// Name and end of the chosen probe.
fn edit(state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
    let (id, l) = (state.session.shown_id(), state.settings.language);
    let Some(number) = state.session.probes.selected else { return };
    let Some(probe) = state.session.probes.get(number).filter(|p| p.piece == id) else { return };
    let mut name = probe.name.clone();
    ui.horizontal(|ui| {
        let edit = egui::TextEdit::singleline(&mut name).char_limit(24).desired_width(ui.available_width() - 90.0);
        let spoken = l.fill("probe.name_of", &[("number", &number)]);
        let edit = theme::field(ui, edit);
        edit.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::TextInput, true, &spoken));
        if edit.changed() {
            acts.push(Act::View(ViewAct::NameProbe(number, name)));
        }
        if ui.button(l.text("probe.remove")).on_hover_text(l.text("probe.remove_hint")).clicked() {
            acts.push(Act::View(ViewAct::RemoveProbe(number)));
        }
    });
}
