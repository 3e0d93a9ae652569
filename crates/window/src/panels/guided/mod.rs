//! What a study or a lesson shows: a ribbon over the scene while a cook runs, and cards between cooks.

mod answers;
mod lesson_cards;
mod ribbon;
mod study_cards;

use std::collections::BTreeMap;

use egui::{Id, Modal, Rect, ScrollArea, Ui};

use crate::ui::layout::Layout;
use crate::ui::theme;
use saute_controls::act::Acts;
use saute_controls::context::PanelContext;
use saute_session::guided::Guided;

/// What was entered on a card so far, by the ids of its items.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Entries {
    pub(super) texts: BTreeMap<String, String>,
    pub(super) places: BTreeMap<String, usize>,
    /// The slider of a question of a lesson.
    pub(super) slider: Option<f64>,
}

/// Width of a card at most [points].
const WIDTH: f32 = 560.0;
/// Height that a card needs in addition to what it scrolls [points].
const BESIDE: f32 = 110.0;

/// Shows the ribbon, or the card; returns true if a card is shown: nothing else is to be shown over it.
pub fn show(state: &PanelContext, entries: &mut Entries, ui: &Ui, acts: &mut Acts, layout: &Layout) -> bool {
    match state.guided {
        None => false,
        Some(Guided::Study(desk)) if desk.is_running() => {
            ribbon::of_study(state, desk, ui, layout);
            false
        }
        Some(Guided::Study(desk)) => {
            study_cards::show(state, desk, entries, ui, acts, layout.whole);
            true
        }
        Some(Guided::Lesson(desk)) => {
            ribbon::of_lesson(state, desk, ui, acts, layout);
            lesson_cards::show(state, desk, entries, ui, acts, layout.whole)
        }
    }
}

/// A card over everything that only its buttons close.
fn card(
    ui: &Ui,
    (name, heading): (&str, &str),
    whole: Rect,
    content: impl FnOnce(&mut Ui),
    buttons: impl FnOnce(&mut Ui),
) {
    let palette = theme::of(ui);
    Modal::new(Id::unique(("guided", name))).frame(palette.panel().fill(palette.solid)).show(ui.ctx(), |ui| {
        ui.set_width((whole.width() - 56.0).min(WIDTH));
        crate::ui::aloud::heading(ui, heading);
        ui.separator();
        ScrollArea::vertical().max_height(whole.height() - BESIDE - theme::TOUCH).show(ui, content);
        ui.add_space(4.0);
        ui.horizontal_wrapped(buttons);
    });
}

/// A button of a card; returns true if it was clicked.
fn button(ui: &mut Ui, text: &str, first: bool) -> bool {
    ui.add(theme::of(ui).button(text, first).min_size(egui::vec2(96.0, theme::TOUCH))).clicked()
}
