//! Pan, surface and core against time.

use egui::{RichText, Ui};
use egui_plot::{Line, LineStyle, Plot, PlotPoints, VLine};

use crate::app::SauteApp;
use crate::theme;

/// Points drawn at most per curve (chosen: about one a pixel).
const MOST_POINTS: usize = 400;

/// Shows the curves with what happened.
pub fn show(app: &SauteApp, ui: &mut Ui, height: f32) {
    let settings = &app.settings;
    let rows = &app.session.recorder.rows;
    let step = rows.len().div_ceil(MOST_POINTS).max(1);
    let series = |pick: &dyn Fn(&saute_kitchen::recorder::Row) -> Option<f64>| -> Vec<[f64; 2]> {
        let shown = rows.iter().step_by(step).chain(rows.last());
        shown.filter_map(|r| Some([r.time_s / 60.0, settings.degrees(pick(r)?)])).collect()
    };
    let piece = app.session.steak_index();
    let lines = [
        ("pan", series(&|r| Some(r.pan_c))),
        ("core", series(&|r| r.foods.get(piece).map(|f| f[0]))),
        ("underside", series(&|r| r.foods.get(piece).map(|f| f[2]))),
    ];
    let unit = settings.unit();
    ui.horizontal(|ui| {
        for (i, name) in ["— pan", "— core", "- - underside"].into_iter().enumerate() {
            ui.label(RichText::new(name).size(13.0).color(theme::CURVES[i]));
        }
        if app.scale().is_some() {
            ui.label(RichText::new("··· goal").size(13.0).color(theme::QUIET));
        }
    });
    Plot::new("curves")
        .height(height)
        .allow_drag(false)
        .allow_zoom(false)
        .allow_scroll(false)
        .allow_boxed_zoom(false)
        .include_y(settings.degrees(0.0))
        .include_y(settings.degrees(200.0))
        .include_x(0.0)
        .include_x(2.0)
        .y_axis_min_width(28.0)
        .x_grid_spacer(egui_plot::uniform_grid_spacer(|input| spacing(input.bounds.1 - input.bounds.0, 3.0)))
        .y_grid_spacer(egui_plot::uniform_grid_spacer(|input| spacing(input.bounds.1 - input.bounds.0, 6.0)))
        .x_axis_label(format!("minutes · {unit}"))
        .show(ui, |plot| {
            for (i, (name, points)) in lines.into_iter().enumerate() {
                let style = [LineStyle::Solid, LineStyle::Solid, LineStyle::dashed_loose()][i];
                let width = [1.6, 2.4, 1.6][i];
                plot.line(Line::new(name, PlotPoints::from(points)).color(theme::CURVES[i]).style(style).width(width));
            }
            if app.scale().is_some() {
                let goal = egui_plot::HLine::new("goal", settings.degrees(settings.goal_c));
                plot.hline(goal.color(theme::QUIET).style(LineStyle::dotted_dense()).width(1.0));
            }
            for mark in &app.session.marks {
                let line = VLine::new(mark.label.clone(), mark.time_s / 60.0)
                    .color(egui::Color32::from_white_alpha(46))
                    .width(1.0);
                plot.vline(line.allow_hover(true).name(""));
            }
        });
}

/// Grid lines at round steps, at most `most` over a span: each label then has the room that it needs to be shown.
fn spacing(span: f64, most: f64) -> [f64; 3] {
    let round = [1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0];
    let step = round.into_iter().find(|s| span / s <= most).unwrap_or(1000.0);
    [step; 3]
}
