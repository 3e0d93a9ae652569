//! The probes in the food: their values, names, and the way to put one in or take one out.

use egui::{RichText, Ui, vec2};

use crate::act::{Act, key_of};
use crate::app::SauteApp;
use crate::ui::theme;

/// A button after which the next click on the food puts a probe in.
pub fn add_button(app: &mut SauteApp, ui: &mut Ui) {
    let l = app.settings.language;
    let text = RichText::new(l.text(if app.scene.placing { "probe.click" } else { "probe.add" })).size(13.0);
    let add = ui.add(egui::Button::new(text).selected(app.scene.placing));
    if add.on_hover_text(l.fill("probe.add_hint", &[("key", &key_of(Act::Probe))])).clicked() {
        app.scene.placing = !app.scene.placing;
    }
}

/// Shows the probes of the piece that the panels are about.
pub fn show(app: &mut SauteApp, ui: &mut Ui) {
    let Some(piece) = app.session.steak() else { return };
    let words = |p: &saute_picture::probe::Probe| app.settings.fine_temperature(p.celsius(piece));
    let shown: Vec<(usize, String)> =
        app.session.probes.of(piece).map(|p| (p.number, format!("{} · {}", p.number, words(p)))).collect();
    if shown.is_empty() {
        return;
    }
    ui.spacing_mut().interact_size.y = 24.0;
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = vec2(4.0, 4.0);
        ui.spacing_mut().button_padding = vec2(7.0, 3.0);
        for (number, text) in shown {
            let on = app.session.probes.selected == Some(number);
            let text = RichText::new(text).size(13.0).color(theme::of(ui).probe(number));
            let chip =
                ui.add(egui::Button::new(text).stroke(egui::Stroke::new(f32::from(u8::from(on)), theme::of(ui).text)));
            if chip.on_hover_text(app.settings.language.text("probe.chip_hint")).clicked() {
                app.session.probes.selected = (!on).then_some(number);
            }
        }
    });
    edit(app, ui);
}

/// Name and end of the chosen probe.
fn edit(app: &mut SauteApp, ui: &mut Ui) {
    let (id, l) = (app.steak_id(), app.settings.language);
    let Some(number) = app.session.probes.selected else { return };
    let Some(probe) = app.session.probes.get_mut(number).filter(|p| p.piece == id) else { return };
    let mut taken_out = false;
    ui.horizontal(|ui| {
        let edit =
            egui::TextEdit::singleline(&mut probe.name).char_limit(24).desired_width(ui.available_width() - 90.0);
        let name = l.fill("probe.name_of", &[("number", &number)]);
        ui.add(edit).widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::TextInput, true, &name));
        taken_out = ui.button(l.text("probe.remove")).on_hover_text(l.text("probe.remove_hint")).clicked();
    });
    if taken_out {
        app.session.probes.remove(number);
    }
}
