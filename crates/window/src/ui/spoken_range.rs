//! A slider of our own, as screen readers use it: its range, its value, and the value that is asked for.

use std::ops::RangeInclusive;

use egui::accesskit::{Action, ActionData};
use egui::{Response, Ui};

/// Tells screen readers the range and the value of a slider; returns the value that one asks for, within the range.
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
