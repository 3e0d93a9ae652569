//! What was found: three values with their intervals, how well they describe what was measured, and the curves.

use egui::{RichText, Ui, vec2};
use egui_plot::{Line, Plot, PlotPoints, Points};
use saute_kitchen::celsius;
use saute_plan::fit::found::{Estimate, Worst};
use saute_plan::fit::observed::Quantity;
use saute_plan::fit::run::Fitted;
use saute_words::clock::clock;

use super::at_home_state::AtHomeState;
use crate::ui::theme;
use saute_controls::act::{Act, Acts, LearnAct};
use saute_controls::at_home::AtHomeAct;
use saute_controls::context::PanelContext;
use saute_session::at_home::fitting::FitStatus;
use saute_session::at_home::kept::KeptKitchen;

/// Height of the plot [points].
const PLOT: f32 = 210.0;

/// Shows the status of the fit, and the kitchen that is kept.
pub fn show(state: &AtHomeState, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    match state.at_home.standing() {
        FitStatus::Idle => {}
        FitStatus::Fitting(share) => fitting(state, ui, acts, *share),
        FitStatus::Refused(why) => {
            ui.label(RichText::new(l.fill("athome.refused", &[("why", &why.words(l))])).color(theme::of(ui).accent));
        }
        FitStatus::Found(fitted) => found(state, fitted, ui, acts),
    }
    if let Some(kept) = &state.settings.kitchen {
        ui.add_space(8.0);
        self::kept(state, kept, ui, acts);
    }
}

fn fitting(state: &PanelContext, ui: &mut Ui, acts: &mut Acts, share: f64) {
    let l = state.settings.language;
    ui.label(RichText::new(l.text("athome.fitting")).size(17.0));
    let bar = egui::ProgressBar::new(share as f32).desired_width(ui.available_width()).fill(theme::of(ui).chosen);
    let spoken = l.fill("athome.progress", &[("percent", &format!("{:.0}", 100.0 * share))]);
    ui.add(bar).widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::ProgressIndicator, true, &spoken));
    ui.label(RichText::new(l.text("athome.meanwhile")).size(13.0).color(theme::of(ui).quiet));
    if ui.add(theme::of(ui).button(l.text("plan.cancel"), false)).clicked() {
        acts.push(Act::Learn(LearnAct::AtHome(AtHomeAct::Cancel)));
    }
}

fn found(state: &AtHomeState, fitted: &Fitted, ui: &mut Ui, acts: &mut Acts) {
    let (l, found) = (state.settings.language, &fitted.found);
    egui::Grid::new("found").num_columns(3).spacing(vec2(18.0, 5.0)).show(ui, |ui| {
        let head = |ui: &mut Ui, key| ui.label(RichText::new(l.text(key)).size(13.0).color(theme::of(ui).quiet));
        head(ui, "athome.value");
        head(ui, "athome.yours");
        head(ui, "athome.interval");
        ui.end_row();
        let mut row = |key, estimate: &Estimate, factor: f64, unit: &str, decimals: usize| {
            let [value, low, high] = [estimate.value, estimate.low, estimate.high].map(|v| factor * v);
            ui.label(l.text(key));
            ui.label(RichText::new(format!("{value:.decimals$}{unit}")).strong());
            ui.label(format!("{low:.decimals$}–{high:.decimals$}{unit}"));
            ui.end_row();
        };
        row("athome.efficiency", &found.hob_efficiency, 100.0, " %", 1);
        row("athome.contact", &found.contact, 1.0, " ×", 2);
        row("athome.thickness", &found.thickness_mm, 1.0, " mm", 1);
    });
    let misfit = format!("{:.2}", found.misfit);
    let (key, colour) = match found.describes() {
        true => ("athome.misfit_good", theme::of(ui).quiet),
        false => ("athome.misfit_bad", theme::of(ui).accent),
    };
    ui.label(RichText::new(l.fill(key, &[("misfit", &misfit), ("values", &found.samples)])).size(13.5).color(colour));
    worst(state, &found.worst, ui);
    plot(state, fitted, ui);
    let keep = if found.describes() { "athome.keep" } else { "athome.keep_anyway" };
    if ui.add(theme::of(ui).primary(l.text(keep))).clicked() {
        acts.push(Act::Learn(LearnAct::AtHome(AtHomeAct::Keep)));
    }
    ui.label(RichText::new(l.text("athome.keep_how")).size(13.0).color(theme::of(ui).quiet));
}

/// Where the fit misses most.
fn worst(state: &PanelContext, worst: &Worst, ui: &mut Ui) {
    let (l, settings) = (state.settings.language, state.settings);
    let (key, unit): (&str, &str) = match worst.quantity {
        Quantity::Pan => ("athome.pan", settings.unit()),
        Quantity::Core | Quantity::CorePeak => ("athome.core", settings.unit()),
        Quantity::Mass => ("athome.weight", "g"),
    };
    let value = |value: f64| match worst.quantity {
        Quantity::Mass => format!("{:.1} {unit}", 1e3 * value),
        _ => format!("{:.1} {unit}", settings.degrees(celsius(value))),
    };
    let at = if worst.at_s.is_finite() { clock(worst.at_s) } else { l.text("athome.at_end").to_owned() };
    let (read, expected) = (value(worst.read), value(worst.expected));
    let parts: [(&str, &dyn std::fmt::Display); 4] =
        [("at", &at), ("what", &l.text(key)), ("read", &read), ("expected", &expected)];
    ui.label(RichText::new(l.fill("athome.worst", &parts)).size(13.0).color(theme::of(ui).quiet));
}

/// What was measured as points, what the fitted kitchen would have shown as lines.
fn plot(state: &AtHomeState, fitted: &Fitted, ui: &mut Ui) {
    let (l, settings, palette) = (state.settings.language, state.settings, theme::of(ui));
    let degrees = |(at_s, kelvin): &(f64, f64)| [at_s / 60.0, settings.degrees(celsius(*kelvin))];
    ui.horizontal(|ui| {
        for (place, key) in [(0, "athome.pan"), (1, "athome.core")] {
            ui.label(RichText::new(l.text(key)).size(13.0).strong().color(palette.curves[place]));
        }
        ui.label(RichText::new(l.text("athome.plot_how")).size(13.0).color(palette.quiet));
    });
    let samples = state.at_home.observed().samples();
    let measured = |quantity: Quantity| -> Vec<[f64; 2]> {
        let own = samples.iter().filter(|s| s.quantity == quantity && s.at_s.is_finite());
        own.map(|s| degrees(&(s.at_s, s.value))).collect()
    };
    let shown = Plot::new("fitted")
        .height(PLOT)
        .allow_scroll(false)
        .allow_drag(false)
        .allow_zoom(false)
        .allow_boxed_zoom(false)
        .show_crosshair(false)
        .x_axis_label(l.fill("curves.minutes", &[("unit", &settings.unit())]))
        .show(ui, |plot| {
            let curves = [
                (&fitted.curves.pan, Quantity::Pan, 0, "athome.pan"),
                (&fitted.curves.core, Quantity::Core, 1, "athome.core"),
            ];
            for (curve, quantity, place, key) in curves {
                let (name, colour) = (l.text(key), palette.curves[place]);
                let points: Vec<[f64; 2]> = curve.iter().map(degrees).collect();
                plot.line(
                    Line::new(l.fill("athome.fitted_curve", &[("what", &name)]), PlotPoints::from(points))
                        .color(colour)
                        .width(2.0),
                );
                let points = measured(quantity);
                if !points.is_empty() {
                    let name = l.fill("athome.measured_curve", &[("what", &name)]);
                    plot.points(Points::new(name, PlotPoints::from(points)).color(colour).radius(3.0));
                }
            }
        });
    let spoken = l.text("athome.plot_spoken");
    shown.response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Image, true, spoken));
}

/// The kitchen that is kept, and the ways to it and from it.
fn kept(state: &PanelContext, kept: &KeptKitchen, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    let percent = |share: f64| format!("{:.0}", 100.0 * share);
    let [efficiency, low, high] = kept.hob_efficiency.map(percent);
    let [contact, least, most] = kept.contact.map(|factor| format!("{factor:.2}"));
    let parts: [(&str, &dyn std::fmt::Display); 6] = [
        ("efficiency", &efficiency),
        ("low", &low),
        ("high", &high),
        ("contact", &contact),
        ("least", &least),
        ("most", &most),
    ];
    ui.label(RichText::new(l.text("athome.kept")).strong());
    ui.label(l.fill("athome.kept_is", &parts));
    super::chip::show(state, ui, acts);
    if ui.add(theme::of(ui).button(l.text("athome.forget"), false)).clicked() {
        acts.push(Act::Learn(LearnAct::AtHome(AtHomeAct::Forget)));
    }
}
