//! The list of what was said, the last first.

use egui::{Id, Modal, Rect, RichText, ScrollArea, Ui};

use crate::act::{Act, Acts, Card};
use crate::panels::inside::clock;
use crate::panels::window_state::WindowState;
use crate::ui::theme;

/// Width of the card at most [points].
const WIDTH: f32 = 560.0;

/// Shows the list over everything; Esc, the button or a click beside it closes it.
pub fn show(state: &WindowState, ui: &Ui, acts: &mut Acts, whole: Rect) {
    let l = state.settings.language;
    let palette = theme::of(ui);
    let mut done = false;
    let modal = Modal::new(Id::unique("messages")).frame(palette.panel().fill(palette.solid)).show(ui.ctx(), |ui| {
        ui.set_width((whole.width() - 56.0).min(WIDTH));
        ui.horizontal(|ui| {
            ui.heading(l.text("messages.title"));
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                done = ui.add(palette.button(l.text("settings.done"), true)).clicked();
            });
        });
        ui.separator();
        ScrollArea::vertical().max_height(whole.height() - 140.0).show(ui, |ui| lines(state, ui, acts));
    });
    if done || modal.should_close() {
        acts.push(Act::Shut(Card::Messages));
    }
}

fn lines(state: &WindowState, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    let all = state.said.all();
    if all.is_empty() {
        ui.label(l.text("messages.none"));
    }
    for said in all {
        let ago = l.fill("messages.ago", &[("time", &clock(f64::from(said.ago_s())))]);
        ui.label(RichText::new(ago).size(12.5).color(theme::of(ui).quiet));
        ui.horizontal_wrapped(|ui| {
            ui.label(&said.text);
            show_button(state, ui, acts, &said);
        });
        ui.add_space(4.0);
    }
}

/// A button that shows the file of a sentence.
pub fn show_button(state: &WindowState, ui: &mut Ui, acts: &mut Acts, said: &crate::ui::notice::Said) {
    #[cfg(target_arch = "wasm32")]
    let _ = (state, ui, acts, said);
    #[cfg(not(target_arch = "wasm32"))]
    if let Some(file) = &said.file
        && ui.button(state.settings.language.text("messages.show")).clicked()
    {
        acts.push(Act::ShowFile(file.clone()));
    }
}
