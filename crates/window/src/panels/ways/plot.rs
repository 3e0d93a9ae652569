//! The curves of all ways in one plot, with a legend.

use egui::{RichText, Ui, vec2};
use egui_plot::VLine;
use saute_recipe::recorder::Row;

use super::look::piece;
use crate::panels::curve::Curve;
use crate::panels::curves::{MOST_POINTS, axes, goal, goal_line, read_off, sample};
use crate::panels::ways::look::style;
use crate::ui::{fingers, theme};
use saute_controls::ways_state::WaysState;
use saute_session::timeline::WayBeside;

/// How strongly what is after the shown instant is drawn [-] (chosen: seen, and distinguished from what has happened).
const AHEAD_SEEN: f32 = 0.4;

/// Height of a row of the legend [points].
const ROW: f32 = 18.0;
/// A goal farther than this from all that was reached is left away [°C] (chosen: it would press the curves together).
const GOAL_NEAR: f64 = 25.0;

/// What the curves show.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Quantity {
    /// Temperature of the core.
    #[default]
    Core,
    /// Temperature of the underside.
    Underside,
    /// Temperature of the pan.
    Pan,
}

impl Quantity {
    const ALL: [Self; 3] = [Self::Core, Self::Underside, Self::Pan];

    fn name(self) -> &'static str {
        match self {
            Self::Core => "curves.core",
            Self::Underside => "curves.underside",
            Self::Pan => "curves.pan",
        }
    }

    /// Its value for a piece [°C].
    fn of(self, row: &Row, piece: usize) -> Option<f64> {
        match self {
            Self::Core => row.foods.get(piece).map(|food| food[0]),
            Self::Underside => row.foods.get(piece).map(|food| food[2]),
            Self::Pan => Some(row.pan_c),
        }
    }
}

/// Shows the curves in a height [points]: faint after the instant that is shown.
pub(super) fn show(state: &WaysState, quantity: Quantity, ui: &mut Ui, height: f32) {
    let palette = theme::of(ui);
    // The one that goes on is the widest: the others are drawn on it.
    let mut ways: Vec<&WayBeside> = state.ways.iter().collect();
    ways.sort_by_key(|way| way.place.is_some());
    let curves: Vec<Curve> = ways.into_iter().map(|way| curve(state, way, quantity, ui)).collect();
    let now = state.session.shown_s() / 60.0;
    let highest = curves.iter().flat_map(|curve| &curve.points).map(|point| point[1]).fold(f64::MIN, f64::max);
    let is_near = quantity == Quantity::Core && goal(state).is_some_and(|goal| highest > goal - GOAL_NEAR);
    let shown = axes(state, "ways", height).show(ui, |plot| {
        for curve in &curves {
            let done = curve.points.partition_point(|point| point[0] <= now);
            plot.line(curve.line(&curve.points[..done], curve.colour));
            plot.line(curve.line(&curve.points[done.saturating_sub(1)..], curve.colour.gamma_multiply(AHEAD_SEEN)));
        }
        if let Some(goal) = goal_line(state, palette).filter(|_| is_near) {
            plot.hline(goal);
        }
        plot.vline(VLine::new("", now).color(palette.quiet).width(1.0));
    });
    let spoken = state.settings.language.text("ways.curves_spoken");
    shown.response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Image, true, spoken));
    read_off(state, ui, &shown.response, &shown.transform, &curves);
}

fn curve(state: &WaysState, way: &WayBeside, quantity: Quantity, ui: &Ui) -> Curve {
    let pieces = way.kitchen.pieces();
    let shown = piece(state, way).map(|piece| &piece.id);
    let place = pieces.iter().position(|piece| Some(&piece.id) == shown).unwrap_or(0);
    let step = way.rows.len().div_ceil(MOST_POINTS).max(1);
    let rows = way.rows.iter().step_by(step).chain(way.rows.last());
    Curve {
        name: state.way_name(way).to_owned(),
        mark: String::new(),
        colour: theme::of(ui).way(way.way.slot),
        style: style(way.way.slot),
        width: if way.place.is_none() { 2.8 } else { 1.8 },
        points: rows
            .filter_map(|row| Some([row.time_s / 60.0, state.settings.degrees(quantity.of(row, place)?)]))
            .collect(),
    }
}

/// Shows which curve belongs to which way, and chooses what they show.
pub(super) fn legend(state: &WaysState, quantity: &mut Quantity, ui: &mut Ui) {
    let l = state.settings.language;
    ui.spacing_mut().item_spacing = vec2(6.0, 2.0);
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().interact_size.y = fingers::height(ui, ROW);
        ui.spacing_mut().button_padding = vec2(7.0, 2.0);
        for other in Quantity::ALL {
            let text = RichText::new(l.text(other.name())).size(13.0);
            if ui.selectable_label(*quantity == other, text).clicked() {
                *quantity = other;
            }
        }
    });
    ui.spacing_mut().interact_size.y = ROW;
    for way in &state.ways {
        ui.horizontal(|ui| {
            sample(ui, theme::of(ui).way(way.way.slot), style(way.way.slot), 2.4);
            let name = state.way_name(way);
            let text = if way.place.is_none() { l.fill("ways.this", &[("way", &name)]) } else { name.to_owned() };
            ui.add(egui::Label::new(RichText::new(text).size(13.0)).truncate());
        });
    }
}
