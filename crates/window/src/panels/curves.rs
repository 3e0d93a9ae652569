//! Pan, underside, core and probes against time, with what happened.

use std::sync::Arc;

use egui::{Align2, Area, Color32, FontId, Id, Order, Rect, RichText, Sense, Shape, Stroke, Ui, pos2, vec2};
use egui_plot::{HLine, LineStyle, Plot, PlotPoint, PlotTransform, VLine};
use saute_kitchen::food::Scale;
use saute_kitchen::food::change::doneness::Measure;

use crate::panels::ahead::future_curves::futures;
use crate::panels::curve::Curve;
use crate::ui::palette::Palette;
use crate::ui::theme;
use saute_controls::context::PanelContext;
use saute_session::Mark;
use saute_words::clock::clock;
use saute_words::language::Language;

/// Points drawn at most per curve (chosen: about one a pixel).
pub(super) const MOST_POINTS: usize = 400;
/// Events nearer to the pointer than this are named [points].
const EVENT_NEAR: f32 = 6.0;
/// Height of the lane above the curves in which events are named, and space between two names [points].
const LANE: f32 = 15.0;
const EVENT_APART: f32 = 6.0;
/// How strongly the lines of events are drawn [-] (chosen: behind the curves).
const EVENT_SEEN: f32 = 0.35;

/// Shows the curves with what happened.
pub fn show(state: &PanelContext, ui: &mut Ui, height: f32) {
    let palette = theme::of(ui);
    let mut curves = curves(state, palette);
    let futures = futures(state, palette);
    let settings = state.settings;
    legend(state, ui, &curves);
    let (lane, _) = ui.allocate_exact_size(vec2(ui.available_width(), LANE), Sense::hover());
    let axes = axes(state, "curves", height - LANE).include_y(settings.degrees(0.0)).include_y(settings.degrees(200.0));
    let shown = axes.show(ui, |plot| {
        for curve in &curves {
            plot.line(curve.line(&curve.points, curve.colour));
        }
        for future in &futures {
            future.draw(plot);
        }
        if let Some(goal) = goal_line(state, palette) {
            plot.hline(goal);
        }
        for mark in &state.session.marks {
            let line = VLine::new(mark_words(mark, settings.language), mark.time_s / 60.0);
            plot.vline(line.color(palette.quiet.gamma_multiply(EVENT_SEEN)).width(1.0));
        }
    });
    events(ui, lane, &shown.transform, &state.session.marks, settings.language);
    ends(ui, &shown.transform, &curves);
    futures.iter().for_each(|future| future.mark(ui, &shown.transform));
    curves.extend(futures.into_iter().map(|future| future.curve));
    let spoken = settings.language.text("curves.spoken");
    shown.response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Image, true, spoken));
    read_off(state, ui, &shown.response, &shown.transform, &curves);
}

/// Axes of time and temperature in a plot of a height [points].
pub(super) fn axes<'a>(state: &PanelContext, name: &'static str, height: f32) -> Plot<'a> {
    let settings = state.settings;
    // The axis omits numbers that are closer than this.
    let levels = ((f64::from(height) - 21.0) / 24.0).clamp(2.0, 6.0);
    Plot::new(name)
        .height(height)
        // Time is zoomed and moved; a double click shows all of it again.
        .allow_drag([true, false])
        .allow_zoom([true, false])
        .allow_scroll(false)
        .allow_boxed_zoom(false)
        .show_crosshair(false)
        .label_formatter(|_| None)
        .include_x(0.0)
        .include_x(2.0)
        .y_axis_min_width(28.0)
        .x_grid_spacer(egui_plot::uniform_grid_spacer(|input| spacing(input.bounds.1 - input.bounds.0, 3.0)))
        .y_grid_spacer(egui_plot::uniform_grid_spacer(move |input| spacing(input.bounds.1 - input.bounds.0, levels)))
        .x_axis_label(settings.language.fill("curves.minutes", &[("unit", &settings.unit())]))
}

/// The goal of the food that the panels show in the chosen unit, where it is a temperature.
pub(super) fn goal(state: &PanelContext) -> Option<f64> {
    Some(state.settings.degrees(state.settings.goal(&*of_temperature(state)?)))
}

/// A line at that goal.
pub(super) fn goal_line(state: &PanelContext, palette: &Palette) -> Option<HLine> {
    let line = HLine::new(state.settings.language.text("curves.goal"), goal(state)?);
    Some(line.color(palette.quiet).style(LineStyle::dotted_dense()).width(1.0))
}

/// What happened, in a language; a power is a number and needs none.
fn mark_words(mark: &Mark, l: Language) -> String {
    saute_words::act_words::act_words(&mark.done, l)
}

fn curves(state: &PanelContext, palette: &Palette) -> Vec<Curve> {
    let (settings, rows) = (state.settings, &state.session.recorder.rows);
    let step = rows.len().div_ceil(MOST_POINTS).max(1);
    let series = |pick: &dyn Fn(&saute_recipe::recorder::Row) -> Option<f64>| -> Vec<[f64; 2]> {
        let shown = rows.iter().step_by(step).chain(rows.last());
        shown.filter_map(|r| Some([r.time_s / 60.0, settings.degrees(pick(r)?)])).collect()
    };
    let (piece, l) = (state.session.shown_index(), settings.language);
    let curve = |place: usize, name: &str, style, width, points| Curve {
        name: name.to_owned(),
        mark: String::new(),
        colour: palette.curves[place],
        style,
        width,
        points,
    };
    let mut curves = vec![
        curve(0, l.text("curves.pan"), LineStyle::Solid, 1.6, series(&|r| Some(r.pan_c))),
        curve(1, l.text("curves.core"), LineStyle::Solid, 2.4, series(&|r| r.foods.get(piece).map(|f| f[0]))),
        curve(
            2,
            l.text("curves.underside"),
            LineStyle::dashed_loose(),
            1.6,
            series(&|r| r.foods.get(piece).map(|f| f[2])),
        ),
    ];
    curves.extend(state.session.shown_piece().into_iter().flat_map(|p| state.session.probes.of(p)).map(|probe| {
        let step = probe.series.len().div_ceil(MOST_POINTS).max(1);
        let shown = probe.series.iter().step_by(step).chain(probe.series.last());
        Curve {
            name: probe.name.clone(),
            mark: probe.number.to_string(),
            colour: palette.probe(probe.number),
            style: probe_style(probe.number),
            width: 1.8,
            points: shown.map(|[t, c]| [t / 60.0, settings.degrees(*c)]).collect(),
        }
    }));
    curves
}

/// The line style of a probe, by its number from 1: no two are the same.
fn probe_style(number: usize) -> LineStyle {
    match number {
        1 => LineStyle::Dotted { spacing: 5.0 },
        2 => LineStyle::Dashed { length: 6.0 },
        3 => LineStyle::Dotted { spacing: 9.0 },
        4 => LineStyle::Dashed { length: 16.0 },
        5 => LineStyle::Dotted { spacing: 14.0 },
        _ => LineStyle::Dashed { length: 26.0 },
    }
}

/// The scale of the food that the panels show, where its goal is a temperature.
fn of_temperature(state: &PanelContext) -> Option<Arc<Scale>> {
    state.scale().filter(|scale| scale.measure() == Measure::Peak)
}

fn legend(state: &PanelContext, ui: &mut Ui, curves: &[Curve]) {
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = vec2(5.0, 2.0);
        for curve in curves.iter().filter(|c| c.mark.is_empty()) {
            sample(ui, curve.colour, curve.style, curve.width);
            ui.label(RichText::new(&curve.name).size(13.0).color(theme::of(ui).text));
            ui.add_space(5.0);
        }
        if of_temperature(state).is_some() {
            sample(ui, theme::of(ui).quiet, LineStyle::dotted_dense(), 1.0);
            ui.label(RichText::new(state.settings.language.text("curves.goal")).size(13.0).color(theme::of(ui).text));
        }
    });
}

/// A short piece of a line, as it is drawn.
pub(super) fn sample(ui: &mut Ui, colour: Color32, style: LineStyle, width: f32) {
    let (rect, _) = ui.allocate_exact_size(vec2(22.0, 12.0), Sense::hover());
    let ends = [rect.left_center(), rect.right_center()];
    let stroke = Stroke::new(width, colour);
    match style {
        LineStyle::Solid => {
            ui.painter().line_segment(ends, stroke);
        }
        LineStyle::Dotted { spacing } => ui.painter().extend(Shape::dotted_line(&ends, colour, spacing, width)),
        LineStyle::Dashed { length } => {
            ui.painter().extend(Shape::dashed_line(&ends, stroke, length.min(9.0), 0.6 * length.min(9.0)));
        }
    }
}

/// What happened, named in the lane above the curves; a name that has no room is a dot, and left to the pointer.
fn events(ui: &Ui, lane: Rect, transform: &PlotTransform, marks: &[Mark], l: Language) {
    let frame = transform.frame();
    let mut free_from = f32::NEG_INFINITY;
    for mark in marks {
        let x = transform.position_from_point_x(mark.time_s / 60.0);
        if !(frame.left()..=frame.right()).contains(&x) {
            continue;
        }
        let ink = theme::of(ui).quiet;
        let text = ui.painter().layout_no_wrap(mark_words(mark, l), FontId::proportional(11.0), ink);
        let half = 0.5 * text.size().x;
        let left = (x - half).clamp(lane.left(), lane.right() - 2.0 * half);
        if left >= free_from {
            free_from = left + 2.0 * half + EVENT_APART;
            ui.painter().galley(pos2(left, lane.top()), text, ink);
        } else {
            ui.painter().circle_filled(pos2(x, frame.top() + 3.0), 2.0, ink);
        }
    }
}

/// The numbers of the probes at the ends of their curves; those that would overlap make room.
fn ends(ui: &Ui, transform: &PlotTransform, curves: &[Curve]) {
    let painter = ui.painter().with_clip_rect(transform.frame().intersect(ui.clip_rect()));
    let mut taken: Vec<Rect> = Vec::new();
    for curve in curves.iter().filter(|c| !c.mark.is_empty()) {
        let Some(last) = curve.points.last() else { continue };
        let end = transform.position_from_point(&PlotPoint::from(*last));
        let mut at = Rect::from_center_size(pos2(end.x - 6.0, end.y - 8.0), vec2(9.0, 12.0));
        while let Some(other) = taken.iter().find(|t| t.intersects(at)) {
            at = at.translate(vec2(other.left() - at.right() - 1.0, 0.0));
        }
        taken.push(at);
        painter.text(at.center(), Align2::CENTER_CENTER, &curve.mark, FontId::proportional(11.5), curve.colour);
    }
}

/// The values at the time under the pointer.
pub(super) fn read_off(
    state: &PanelContext,
    ui: &Ui,
    response: &egui::Response,
    transform: &PlotTransform,
    curves: &[Curve],
) {
    let Some(at) = response.hover_pos().filter(|at| transform.frame().contains(*at)) else { return };
    let minutes = transform.value_from_position(at).x;
    let frame = transform.frame();
    let line = [pos2(at.x, frame.top()), pos2(at.x, frame.bottom())];
    ui.painter().line_segment(line, Stroke::new(1.0, theme::of(ui).quiet));
    let values: Vec<(&Curve, f64)> = curves.iter().filter_map(|c| Some((c, value_at(&c.points, minutes)?))).collect();
    for (curve, value) in &values {
        let point = transform.position_from_point(&PlotPoint::new(minutes, *value));
        ui.painter().circle(point, 3.0, curve.colour, Stroke::new(1.0, theme::of(ui).on_accent));
    }
    let l = state.settings.language;
    let near = |mark: &&Mark| (transform.position_from_point_x(mark.time_s / 60.0) - at.x).abs() < EVENT_NEAR;
    let events: Vec<String> = state.session.marks.iter().filter(near).map(|m| mark_words(m, l)).collect();
    let area = Area::new(Id::unique("curve-values")).order(Order::Tooltip).interactable(false);
    // Left of the pointer: what comes next stays in sight.
    area.fixed_pos(at + vec2(-12.0, -8.0)).pivot(Align2::RIGHT_BOTTOM).show(ui.ctx(), |ui| {
        theme::of(ui).panel().fill(theme::of(ui).solid).inner_margin(8).show(ui, |ui| {
            ui.spacing_mut().item_spacing.y = 1.0;
            let line = |ui: &mut Ui, text: RichText| ui.add(egui::Label::new(text.size(13.0)).extend());
            line(ui, RichText::new(clock(60.0 * minutes)).strong());
            for (curve, value) in &values {
                let value = format!("{value:.0}");
                let open: [(&str, &dyn std::fmt::Display); 3] =
                    [("name", &curve.name), ("value", &value), ("unit", &state.settings.unit())];
                let text = l.fill("curves.value", &open);
                line(ui, RichText::new(text).color(curve.colour));
            }
            if !events.is_empty() {
                line(ui, RichText::new(events.join(l.text("doneness.list_joint"))).color(theme::of(ui).accent));
            }
        });
    });
}

/// Returns the value of a curve at a time; none outside of its ends.
fn value_at(points: &[[f64; 2]], x: f64) -> Option<f64> {
    let upper = points.partition_point(|p| p[0] < x);
    let (low, high) = (points.get(upper.checked_sub(1)?)?, points.get(upper)?);
    let share = if high[0] > low[0] { (x - low[0]) / (high[0] - low[0]) } else { 0.0 };
    Some(low[1] + share * (high[1] - low[1]))
}

/// Grid lines at round steps, at most `most` over a span: each label then has the room that it needs to be shown.
fn spacing(span: f64, most: f64) -> [f64; 3] {
    // Below a minute where time is zoomed.
    let round = [0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0];
    let step = round.into_iter().find(|s| span / s <= most).unwrap_or(1000.0);
    [step; 3]
}
