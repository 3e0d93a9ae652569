//! Widgets as screen readers use them: headings to jump to, values with units, and sliders of our own with their ranges.

use std::ops::RangeInclusive;

use egui::accesskit::{Action, ActionData, Role};
use egui::{Response, Ui, WidgetInfo};

/// Shows a heading.
pub fn heading(ui: &mut Ui, text: impl Into<String>) {
    let text = text.into();
    ui.heading(&text).widget_info(|| WidgetInfo::labeled(Role::Heading, true, &text));
}

/// Gives a panel its name.
pub fn name_panel(ui: &Ui, name: &str) {
    ui.ctx().accesskit_node_builder(ui.unique_id(), |node| {
        node.set_role(Role::Group);
        node.set_label(name);
    });
}

/// Gives screen readers the value of a slider with its unit.
pub fn spoken_value(ui: &Ui, response: &Response, text: String) {
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_value(text));
}

/// Gives screen readers the range and the value of a slider; returns the value that one requests, within the range.
pub fn spoken_range(ui: &Ui, response: &Response, range: RangeInclusive<f64>, now: f64) -> Option<f64> {
    ui.ctx().accesskit_node_builder(response.id, |node| {
        node.set_min_numeric_value(*range.start());
        node.set_max_numeric_value(*range.end());
        node.set_numeric_value(now);
        node.add_action(Action::SetValue);
    });
    let number = |data: &Option<ActionData>| match data {
        Some(ActionData::NumericValue(value)) if value.is_finite() => Some(*value),
        _ => None,
    };
    let asked = ui.input(|input| {
        input
            .accesskit_action_requests(response.id, Action::SetValue)
            .filter_map(|request| number(&request.data))
            .last()
    });
    asked.map(|value| value.clamp(*range.start(), *range.end()))
}
