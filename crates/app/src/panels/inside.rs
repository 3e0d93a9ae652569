//! What is inside now: the cut, doneness, temperatures, the goal and the curves.

use egui::{RichText, TextureHandle, TextureOptions, Ui, vec2};
use saute_kitchen::food::Shares;
use saute_kitchen::{Piece, Place, celsius};

use crate::app::SauteApp;
use crate::panels::{curves, doneness_bar};
use crate::section_picture::section_picture;
use crate::theme;

/// Pictures of the cut are painted at this scale [pixels/mm] (chosen: sharp in the panel, 4 ms a picture).
const PER_MM: f64 = 3.2;
/// The picture is painted anew this often [wall s] (chosen).
const REPAINT_S: f64 = 0.4;

/// What the panel keeps between frames.
#[derive(Default)]
pub struct Inside {
    texture: Option<TextureHandle>,
    painted_at: f64,
    painted_for: Option<(u64, i64, crate::View, crate::TemperatureMap, bool)>,
    shares: Shares,
}

/// From here on every cooking oil smokes [°C] (refined oils 200–270).
const TOO_HOT_C: f64 = 270.0;
/// Room for two lines of advice [points].
const ADVICE_HEIGHT: f32 = 40.0;

/// Goals with names: core peak [°C] in the 2013 paper's classes.
const GOALS: [(&str, f64); 3] = [("rare", 54.0), ("medium", 62.0), ("well done", 72.0)];

/// Shows the panel.
pub fn show(app: &mut SauteApp, ui: &mut Ui) {
    if app.session.steak().is_none() {
        ui.label("No food is set out. Choose one under “Steak…”.");
        return;
    }
    refresh(app, ui);
    cut(app, ui);
    doneness_bar::show(ui, &app.settings, &app.inside.shares);
    ui.separator();
    readings(app, ui);
    ui.separator();
    goal(app, ui);
    if app.settings.curves_open {
        ui.separator();
        let height = (ui.available_height() - 32.0).clamp(112.0, 260.0);
        curves::show(app, ui, height);
    }
}

fn refresh(app: &mut SauteApp, ui: &Ui) {
    let now = ui.input(|i| i.time);
    let Some(piece) = app.session.steak() else { return };
    let place = app.slice.unwrap_or(0.0);
    let flipped = piece.state.down == saute_kitchen::food::Side::Top;
    let wanted = (app.session.generation, (place * 1e4) as i64, app.settings.view, app.settings.map, flipped);
    let same = app.inside.painted_for == Some(wanted);
    if same && now - app.inside.painted_at < REPAINT_S {
        return;
    }
    let x = place * crate::stage::half_length(piece);
    let picture = section_picture(&piece.model, &piece.state, x, app.settings.view, app.settings.map, PER_MM);
    let shares = piece.model.cut_shares(&piece.state, &piece.model.cut_across(0.0));
    let image = egui::ColorImage::from_rgba_unmultiplied([picture.width, picture.height], &picture.rgba);
    match &mut app.inside.texture {
        Some(texture) => texture.set(image, TextureOptions::LINEAR),
        None => app.inside.texture = Some(ui.ctx().load_texture("cut", image, TextureOptions::LINEAR)),
    }
    app.inside.shares = shares;
    app.inside.painted_at = now;
    app.inside.painted_for = Some(wanted);
}

fn cut(app: &mut SauteApp, ui: &mut Ui) {
    let Some(texture) = &app.inside.texture else { return };
    let width = ui.available_width();
    let size = texture.size_vec2();
    let scale = (width / size.x).min(92.0 / size.y);
    ui.vertical_centered(|ui| {
        let image =
            egui::Image::new((texture.id(), size * scale)).corner_radius(5).alt_text("Cross-section of the steak");
        ui.add(image);
    });
    let mut place = app.slice.unwrap_or(0.0);
    ui.horizontal(|ui| {
        ui.label(RichText::new("cut at").size(13.0).color(theme::QUIET));
        ui.spacing_mut().slider_width = ui.available_width() - 16.0;
        let slider = egui::Slider::new(&mut place, -0.95..=0.95).show_value(false);
        let response = ui.add(slider);
        response.widget_info(|| egui::WidgetInfo::slider(true, place, "Place of the cut along the steak"));
        if response.changed() {
            app.slice = Some(place);
        }
    });
}

fn readings(app: &SauteApp, ui: &mut Ui) {
    let Some(piece) = app.session.steak() else { return };
    let settings = &app.settings;
    let kitchen = &app.session.kitchen;
    let mass = 1e3 * piece.mass();
    let lost = 100.0 * (1.0 - mass / app.session.start_mass_g());
    let since = piece.flipped_at.map(|t| kitchen.time_s() - t);
    let temperature = |kelvin: f64| settings.temperature(celsius(kelvin));
    let rows = [
        [("Core", temperature(piece.core())), ("Pan", temperature(kitchen.pan_temperature()))],
        [("Underside", temperature(piece.face(true))), ("Upper side", temperature(piece.face(false)))],
        [("Mass", format!("{mass:.0} g")), ("Lost", format!("{lost:.1} %"))],
        [("Time", clock(kitchen.time_s())), ("Since flip", since.map_or_else(|| "–".into(), clock))],
    ];
    egui::Grid::new("readings").num_columns(4).min_col_width(56.0).spacing(vec2(10.0, 4.0)).show(ui, |ui| {
        for row in rows {
            for (name, value) in row {
                ui.label(RichText::new(name).size(12.5).color(theme::QUIET));
                ui.label(RichText::new(value).size(15.0).strong());
            }
            ui.end_row();
        }
    });
}

/// Minutes and seconds.
pub fn clock(seconds: f64) -> String {
    let whole = seconds.max(0.0) as u64;
    format!("{}:{:02}", whole / 60, whole % 60)
}

fn goal(app: &mut SauteApp, ui: &mut Ui) {
    ui.horizontal(|ui| {
        ui.spacing_mut().button_padding.x = 7.0;
        ui.label(RichText::new("Goal").size(12.5).color(theme::QUIET));
        for (name, celsius) in GOALS {
            let on = (app.settings.goal_c - celsius).abs() < 0.5;
            if ui.selectable_label(on, name).clicked() {
                app.settings.goal_c = celsius;
            }
        }
        let mut degrees = app.settings.degrees(app.settings.goal_c);
        let range = app.settings.degrees(45.0)..=app.settings.degrees(85.0);
        let drag =
            egui::DragValue::new(&mut degrees).range(range).speed(0.2).max_decimals(0).suffix(app.settings.unit());
        let response = ui.add(drag);
        response
            .widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::SpinButton, true, "Goal for the core"));
        if response.changed() {
            app.settings.goal_c = app.settings.celsius(degrees);
        }
    });
    show_advice(app, ui);
}

/// Shows what to do next.
pub fn show_advice(app: &mut SauteApp, ui: &mut Ui) {
    let (text, now) = advice(app);
    let text = RichText::new(text).size(14.5);
    let label = egui::Label::new(if now { text.color(theme::ACCENT).strong() } else { text });
    // Always the same height, so that the curves below stay where they are.
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), ADVICE_HEIGHT), egui::Sense::hover());
    ui.scope_builder(egui::UiBuilder::new().max_rect(rect), |ui| ui.add(label));
}

/// What to do next, in the cook's words, and whether it is to be done now.
fn advice(app: &mut SauteApp) -> (String, bool) {
    let goal = app.settings.goal_c;
    let forecast = app.session.forecast();
    let Some(piece) = app.session.steak() else { return (String::new(), false) };
    let pan = celsius(app.session.kitchen.pan_temperature());
    match (piece.place, forecast) {
        (Place::Waiting, _) if pan < 160.0 && app.session.kitchen.hob_w() == 0.0 => {
            ("Turn the hob on and let the pan get hot.".into(), false)
        }
        (Place::Waiting, _) if pan < 160.0 => {
            (format!("The pan is heating; a drop of water should dance at {}.", app.settings.temperature(180.0)), false)
        }
        (Place::Waiting | Place::Pan(_), _) if pan > TOO_HOT_C => {
            ("The pan is too hot and the oil smokes: turn the hob down, or use the wet cloth.".into(), true)
        }
        (Place::Waiting, _) => ("The pan is hot. Put the steak in.".into(), true),
        (Place::Pan(_), Some(f)) if f.peak_c >= goal => {
            (format!("Take it out now: resting will bring the core to {}.", app.settings.temperature(f.peak_c)), true)
        }
        (Place::Pan(_), Some(f)) => {
            let later = format!("Taken out now, the core would peak at {}.", app.settings.temperature(f.peak_c));
            (
                if wet_below(piece) {
                    format!("{later} The underside is wet; it will brown when it dries.")
                } else {
                    later
                },
                false,
            )
        }
        (Place::Rest(_), _) => {
            let peak = app.settings.temperature(celsius(piece.core_peak.0));
            (format!("Resting. The core has reached {peak}."), false)
        }
        _ => (String::new(), false),
    }
}

fn wet_below(piece: &Piece) -> bool {
    celsius(piece.face(true)) < 106.0
}
