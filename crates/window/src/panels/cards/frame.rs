//! The frame of a card over everything: heading, buttons beside it, and what the card shows.

use egui::{Id, Modal, Rect, Ui};

use crate::ui::aloud::heading;
use crate::ui::theme;
use saute_controls::act::{Act, Acts, AppAct, Card};
use saute_controls::context::PanelContext;

/// Height of a window beyond the rows of a card [points].
const BESIDE: f32 = 140.0;

/// A card with a heading.
pub struct Framed {
    /// The card.
    pub card: Card,
    /// Its name in the memory of the interface.
    pub id: &'static str,
    /// Key of its heading.
    pub title: &'static str,
    /// Its width at most [points].
    pub width: f32,
}

impl Framed {
    /// Shows the card with the button alone that closes it.
    pub fn show(
        &self,
        state: &PanelContext,
        ui: &Ui,
        acts: &mut Acts,
        whole: Rect,
        content: impl FnOnce(&mut Ui, &mut Acts),
    ) {
        self.show_with(state, ui, acts, whole, |_, _| {}, content);
    }

    /// Shows the card, with buttons beside the one that closes it; Esc, that button or a click beside the card closes it.
    pub fn show_with(
        &self,
        state: &PanelContext,
        ui: &Ui,
        acts: &mut Acts,
        whole: Rect,
        beside: impl FnOnce(&mut Ui, &mut Acts),
        content: impl FnOnce(&mut Ui, &mut Acts),
    ) {
        let l = state.settings.language;
        let palette = theme::of(ui);
        let mut done = false;
        let modal = Modal::new(Id::unique(self.id)).frame(palette.panel().fill(palette.solid)).show(ui.ctx(), |ui| {
            ui.set_width((whole.width() - 56.0).min(self.width));
            ui.horizontal(|ui| {
                heading(ui, l.text(self.title));
                ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                    done = ui.add(palette.button(l.text("settings.done"), false)).clicked();
                    beside(ui, acts);
                });
            });
            ui.separator();
            content(ui, acts);
        });
        if done || modal.should_close() {
            acts.push(Act::App(AppAct::Shut(self.card)));
        }
    }
}

/// The rows of a card, over the whole height that the window has for them; they scroll where that is too little.
pub fn list(ui: &mut Ui, whole: Rect, rows: impl FnOnce(&mut Ui)) {
    let height = whole.height() - BESIDE;
    egui::ScrollArea::vertical().max_height(height).min_scrolled_height(height).show(ui, rows);
}

/// A part of a card beside another one, which scrolls by itself.
pub fn part(ui: &mut Ui, name: &str, width: f32, height: f32, content: impl FnOnce(&mut Ui)) {
    let down = egui::Layout::top_down(egui::Align::Min);
    ui.allocate_ui_with_layout(egui::vec2(width, height), down, |ui| {
        ui.set_min_size(egui::vec2(width, height));
        let scrolled = egui::ScrollArea::vertical().id_salt(name).max_height(height).min_scrolled_height(height);
        scrolled.auto_shrink([false, false]).show(ui, |ui| {
            ui.set_max_width(width - 14.0);
            content(ui);
        });
    });
}
