//! The list of keys, of what the mouse does and of what a gamepad does.

use egui::{Id, Modal, Rect, RichText, Ui};

use crate::act::{Act, Acts, BINDINGS, Card};
use crate::input::gamepad::PAD;
use crate::input::pan_keys::HELD;
use crate::panels::window_state::WindowState;
use crate::ui::theme;

/// What a gamepad does; browsers' gamepads are not read.
fn pad() -> impl Iterator<Item = (&'static str, &'static str)> {
    PAD.into_iter().filter(|_| cfg!(not(target_arch = "wasm32")))
}

/// What keys do; a browser reaches no haptic device and no half mirror.
fn keys() -> impl Iterator<Item = (&'static str, &'static str)> {
    let native = |act: &Act| matches!(act, Act::StopHands | Act::Strings | Act::Mirror);
    let here = move |b: &&crate::act::Binding| cfg!(not(target_arch = "wasm32")) || !native(&b.act);
    BINDINGS.iter().filter(here).map(|b| (b.written, b.words))
}

/// Shows the list over everything; Esc, F1 or a click beside it closes it.
pub fn show(state: &WindowState, ui: &Ui, acts: &mut Acts, whole: Rect) {
    let modal =
        Modal::new(Id::unique("help")).frame(theme::of(ui).panel().fill(theme::of(ui).solid)).show(ui.ctx(), |ui| {
            ui.set_width((whole.width() - 60.0).min(900.0));
            let l = state.settings.language;
            ui.horizontal(|ui| {
                ui.heading(l.text("help.title"));
                ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                    if ui.add(theme::of(ui).button(l.text("help.first_steps"), false)).clicked() {
                        acts.push(Act::Open(Card::FirstSteps));
                    }
                });
            });
            ui.label(l.text("help.mouse"));
            ui.add_space(6.0);
            let height = whole.height() - 250.0;
            egui::ScrollArea::vertical().max_height(height).min_scrolled_height(height).show(ui, |ui| {
                let columns = if whole.width() > 700.0 { 3 } else { 1 };
                let lines: Vec<(&str, &str)> = keys().chain(HELD).chain(pad()).collect();
                let rows = lines.len().div_ceil(columns);
                ui.columns(columns, |uis| {
                    for (i, (written, words)) in lines.into_iter().enumerate() {
                        let ui = &mut uis[i / rows];
                        ui.horizontal(|ui| {
                            let key = RichText::new(l.called("button", written))
                                .monospace()
                                .strong()
                                .color(theme::of(ui).accent);
                            ui.add_sized([90.0, 20.0], egui::Label::new(key));
                            ui.label(l.text(words));
                        });
                    }
                });
            });
        });
    if modal.should_close() {
        acts.push(Act::Shut(Card::Help));
    }
}
