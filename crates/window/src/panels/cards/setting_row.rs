//! A row of a card: a name and its choices, or what explains them.

use egui::{RichText, Ui, vec2};

use crate::ui::theme;

/// Width of the names where they are to the left of their choices [points].
pub(super) const NAMES: f32 = 128.0;

/// A name and its choices, of which one is on; returns the one that was clicked.
pub(crate) fn row(ui: &mut Ui, narrow: bool, name: &str, choices: &[(&str, bool)]) -> Option<usize> {
    named(ui, narrow, name, |ui| buttons(ui, name, choices))
}

/// A name and what belongs to it: to its right, or below it where it is narrow.
pub(crate) fn named<R>(ui: &mut Ui, narrow: bool, name: &str, content: impl FnOnce(&mut Ui) -> R) -> R {
    if narrow {
        ui.label(RichText::new(name).size(14.0).color(theme::of(ui).quiet));
        return ui.horizontal_wrapped(content).inner;
    }
    ui.horizontal(|ui| {
        let beside = egui::Layout::left_to_right(egui::Align::Center);
        ui.allocate_ui_with_layout(vec2(NAMES, theme::TOUCH), beside, |ui| {
            ui.set_min_size(vec2(NAMES, theme::TOUCH));
            ui.label(name);
        });
        ui.horizontal_wrapped(content).inner
    })
    .inner
}

fn buttons(ui: &mut Ui, name: &str, choices: &[(&str, bool)]) -> Option<usize> {
    ui.spacing_mut().item_spacing = vec2(5.0, 5.0);
    let mut clicked = None;
    for (place, &(text, on)) in choices.iter().enumerate() {
        let response = ui.add(theme::of(ui).button(text, on));
        // Read out with what it is a choice of.
        let spoken = format!("{name}: {text}");
        response.widget_info(|| egui::WidgetInfo::selected(egui::accesskit::Role::RadioButton, true, on, &spoken));
        if response.clicked() {
            clicked = Some(place);
        }
    }
    clicked
}

/// What the choice above amounts to.
pub(crate) fn explained(ui: &mut Ui, narrow: bool, text: &str) {
    let text = RichText::new(text).size(13.0).color(theme::of(ui).quiet);
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().interact_size.y = 16.0;
        if !narrow {
            ui.add_space(NAMES + ui.spacing().item_spacing.x);
        }
        ui.label(text);
    });
}
