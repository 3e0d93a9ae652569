//! The card of the kitchen at home: what was observed on its left, what was found on its right.

use egui::{Rect, RichText, ScrollArea, Ui};

use super::at_home_state::AtHomeState;
use super::{entry, found};
use crate::panels::cards::frame::{Framed, part};
use crate::ui::theme;
use saute_controls::act::{Acts, Card};
use saute_controls::context::PanelContext;

/// Width of the card at most, and of what is entered where the answer is beside it [points].
const WIDTH: f32 = 1040.0;
const ENTRY: f32 = 440.0;
/// Below this width the answer is below what is entered [points].
const NARROW: f32 = 860.0;

/// Shows the card over everything; Esc, the button or a click beside it closes it.
pub fn show(state: &AtHomeState, ui: &Ui, acts: &mut Acts, whole: Rect) {
    let framed = Framed { card: Card::AtHome, id: "at-home", title: "athome.title", width: WIDTH };
    framed.show(state, ui, acts, whole, |ui, acts| {
        let height = whole.height() - 112.0;
        if whole.width() < NARROW {
            let scrolled = ScrollArea::vertical().max_height(height).min_scrolled_height(height);
            scrolled.auto_shrink([false, true]).show(ui, |ui| {
                how(state, ui);
                entry::show(state, ui, acts);
                ui.separator();
                found::show(state, ui, acts);
            });
            return;
        }
        ui.horizontal_top(|ui| {
            part(ui, "entered", ENTRY, height, |ui| entry::show(state, ui, acts));
            let rest = ui.available_width();
            part(ui, "fitted", rest, height, |ui| {
                how(state, ui);
                found::show(state, ui, acts);
            });
        });
    });
}

fn how(state: &PanelContext, ui: &mut Ui) {
    ui.label(RichText::new(state.settings.language.text("athome.how")).size(13.5).color(theme::of(ui).quiet));
}
