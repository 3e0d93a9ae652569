//! What is inside now: the cut, doneness, temperatures, the goal and the curves.

use egui::{RichText, TextureHandle, TextureOptions, Ui, vec2};
use saute_kitchen::food::{Scale, Shares};
use saute_kitchen::heat::Layout;
use saute_kitchen::{Piece, Place, celsius};
use saute_picture::colour::map::TemperatureMap;
use saute_picture::cut::section::section_picture;
use saute_picture::view::View;

use crate::app::SauteApp;
use crate::panels::{curves, doneness_bar, probes};
use crate::settings::Settings;
use crate::ui::theme;

/// Pictures of the cut of a steak are painted at this scale [pixels/mm] (chosen: sharp in the panel, 4 ms a picture).
const PER_MM: f64 = 3.2;
/// Width of the picture's place in the panel [points]; narrower pieces are painted finer.
const PANEL_WIDTH: f64 = 290.0;
/// The picture is painted anew this often [wall s] (chosen).
const REPAINT_S: f64 = 0.4;

/// What the panel keeps between frames.
#[derive(Default)]
pub struct Inside {
    texture: Option<TextureHandle>,
    painted_at: f64,
    painted_for: Option<Painted>,
    /// Doneness of the section, by the chosen scale.
    pub(crate) shares: Shares,
    /// Names and mean shares of what heat has changed.
    pub(crate) changed: Vec<(String, f64)>,
    /// Hardness over that of the raw food [-] and juiciness [%].
    bite: [f64; 2],
}

/// What a picture of the cut was painted for.
#[derive(Clone, Debug, PartialEq)]
struct Painted {
    generation: u64,
    place: i64,
    view: View,
    map: TemperatureMap,
    scale: Option<String>,
    flipped: bool,
}

/// From here on every cooking oil smokes [°C] (refined oils 200–270).
const TOO_HOT_C: f64 = 270.0;
/// Height of the picture of the cut at most [points].
const CUT_HEIGHT: f32 = 84.0;
/// Room for two lines of advice [points].
const ADVICE_HEIGHT: f32 = 40.0;

/// How far into a class its goal for the core lies [K] (chosen: within every class, clear of its bound).
const GOAL_INTO_CLASS: f64 = 2.0;

/// Shows the panel.
pub fn show(app: &mut SauteApp, ui: &mut Ui) {
    if app.session.steak().is_none() {
        ui.label(app.settings.language.text("inside.no_food"));
        return;
    }
    refresh(app, ui);
    cut(app, ui);
    doneness_bar::show(app, ui);
    ui.separator();
    readings(app, ui);
    ui.separator();
    goal(app, ui);
    probes::show(app, ui);
    if app.settings.curves_open {
        ui.separator();
        let height = (ui.available_height() - 32.0).clamp(112.0, 260.0);
        curves::show(app, ui, height);
    }
}

/// Reads everything anew and paints the cut, every now and then and as soon as it should look different.
fn refresh(app: &mut SauteApp, ui: &Ui) {
    let now = ui.input(|i| i.time);
    let Some(wanted) = Painted::wanted(app) else { return };
    let same = app.inside.painted_for.as_ref() == Some(&wanted);
    if same && now - app.inside.painted_at < REPAINT_S {
        return;
    }
    read(app);
    paint(app, ui, &wanted);
    app.inside.painted_at = now;
    app.inside.painted_for = Some(wanted);
}

impl Painted {
    fn wanted(app: &SauteApp) -> Option<Self> {
        Some(Self {
            generation: app.session.generation,
            place: (app.slice.unwrap_or(0.0) * 1e4) as i64,
            view: app.settings.view,
            map: app.settings.map,
            scale: app.scale().map(|s| s.id.clone()),
            flipped: app.session.steak()?.upside_down(),
        })
    }
}

fn read(app: &mut SauteApp) {
    let scale = app.scale();
    let Some(piece) = app.session.steak() else { return };
    let (model, state) = (&piece.model, &piece.state);
    let shares = scale.map(|s| model.cut_shares(state, &model.cut_across(0.0), &s)).unwrap_or_default();
    let means = state.changed.iter().map(|field| model.volume_mean(field));
    let changed = model.kinetics().names().into_iter().map(str::to_owned).zip(means).collect();
    app.inside.bite = [model.hardness_index(state), model.juiciness_pct(state)];
    (app.inside.shares, app.inside.changed) = (shares, changed);
}

fn paint(app: &mut SauteApp, ui: &Ui, wanted: &Painted) {
    let Some(piece) = app.session.steak() else { return };
    let x = app.slice.unwrap_or(0.0) * saute_picture::stage::half_length(piece);
    let colours = wanted.view.colour_map(wanted.map, app.scale().as_deref());
    let picture = section_picture(piece, x, wanted.view, colours.as_ref(), per_mm(piece));
    let image = egui::ColorImage::from_rgba_unmultiplied([picture.width, picture.height], &picture.rgba);
    match &mut app.inside.texture {
        Some(texture) => texture.set(image, TextureOptions::LINEAR),
        None => app.inside.texture = Some(ui.ctx().load_texture("cut", image, TextureOptions::LINEAR)),
    }
}

/// Fineness at which the cut of a piece is sharp in the panel [pixels/mm].
fn per_mm(piece: &Piece) -> f64 {
    let model = &piece.model;
    // A cut that follows a curved body shows all of its length.
    let across = 1e3
        * match model.mesh().layout() {
            Layout::Along(mesh, _) => mesh.thickness(),
            Layout::Upright(_) | Layout::Cells(_) => model.size()[0].min(model.size()[1]),
        };
    (PANEL_WIDTH / across).clamp(PER_MM, 8.0 * PER_MM)
}

fn cut(app: &mut SauteApp, ui: &mut Ui) {
    let Some(texture) = &app.inside.texture else { return };
    let width = ui.available_width();
    let size = texture.size_vec2();
    let scale = (width / size.x).min(CUT_HEIGHT / size.y);
    let l = app.settings.language;
    let noun = app.session.noun();
    let food = l.called("noun", &noun);
    let alt = l.fill("inside.section", &[("food", &food)]);
    ui.vertical_centered(|ui| {
        ui.add(egui::Image::new((texture.id(), size * scale)).corner_radius(5).alt_text(alt));
    });
    let mut place = app.slice.unwrap_or(0.0);
    ui.horizontal(|ui| {
        ui.label(RichText::new(l.text("inside.cut_at")).size(13.0).color(theme::of(ui).quiet));
        let beside = if app.scene.placing { 124.0 } else { 84.0 };
        ui.spacing_mut().slider_width = ui.available_width() - beside - 16.0;
        let slider = egui::Slider::new(&mut place, -0.95..=0.95).show_value(false);
        let response = ui.add(slider);
        let name = l.fill("inside.place_of_cut", &[("food", &food)]);
        response.widget_info(|| egui::WidgetInfo::slider(true, place, &name));
        if response.changed() {
            app.slice = Some(place);
        }
        probes::add_button(app, ui);
    });
}

fn readings(app: &SauteApp, ui: &mut Ui) {
    let Some(piece) = app.session.steak() else { return };
    let settings = &app.settings;
    let kitchen = &app.session.kitchen;
    let mass = 1e3 * piece.mass();
    let lost = 100.0 * (1.0 - mass / app.session.start_mass_g());
    let since = piece.flipped_at.map(|t| kitchen.time_s() - t);
    let hardness = format!("{:.1}", app.inside.bite[0]);
    let juiciness = app.inside.bite[1];
    let temperature = |kelvin: f64| settings.temperature(celsius(kelvin));
    let rows = [
        [("inside.core", temperature(piece.core())), ("inside.pan", temperature(kitchen.pan_temperature()))],
        [("inside.underside", temperature(piece.face(true))), ("inside.upper_side", temperature(piece.face(false)))],
        [("inside.mass", grams(mass)), ("inside.lost", format!("{:.1} %", tidy(lost)))],
        [
            ("inside.hardness", settings.language.fill("inside.hardness_value", &[("value", &hardness)])),
            ("inside.juiciness", format!("{juiciness:.0} %")),
        ],
        [("inside.time", clock(kitchen.time_s())), ("inside.since_flip", since.map_or_else(|| "–".into(), clock))],
    ];
    ui.spacing_mut().interact_size.y = 21.0;
    egui::Grid::new("readings").num_columns(4).min_col_width(56.0).spacing(vec2(10.0, 3.0)).show(ui, |ui| {
        for row in rows {
            for (name, value) in row {
                ui.label(RichText::new(settings.language.text(name)).size(12.5).color(theme::of(ui).quiet));
                ui.label(RichText::new(value).size(15.0).strong());
            }
            ui.end_row();
        }
    });
}

/// A mass with as many places as it takes to see it change.
fn grams(mass: f64) -> String {
    if mass < 50.0 { format!("{mass:.1} g") } else { format!("{mass:.0} g") }
}

/// A percentage rounded to a tenth; adding zero turns −0.0 into 0.0, which would print as −0.0.
fn tidy(percent: f64) -> f64 {
    (10.0 * percent).round() / 10.0 + 0.0
}

/// Minutes and seconds.
pub fn clock(seconds: f64) -> String {
    let whole = seconds.max(0.0) as u64;
    format!("{}:{:02}", whole / 60, whole % 60)
}

fn goal(app: &mut SauteApp, ui: &mut Ui) {
    let Some(scale) = app.scale() else {
        show_advice(app, ui);
        return;
    };
    let l = app.settings.language;
    ui.horizontal(|ui| {
        let many = scale.class.len() > 4;
        (ui.spacing_mut().button_padding.x, ui.spacing_mut().item_spacing.x) =
            if many { (4.0, 2.0) } else { (7.0, 8.0) };
        ui.label(RichText::new(l.text("inside.goal")).size(if many { 11.0 } else { 12.5 }).color(theme::of(ui).quiet));
        goals(&mut app.settings, ui, &scale);
        let mut degrees = app.settings.degrees(app.settings.goal_c);
        let range = app.settings.degrees(45.0)..=app.settings.degrees(85.0);
        let drag =
            egui::DragValue::new(&mut degrees).range(range).speed(0.2).max_decimals(0).suffix(app.settings.unit());
        let response = ui.add(drag);
        response.widget_info(|| {
            egui::WidgetInfo::labeled(egui::accesskit::Role::SpinButton, true, l.text("inside.goal_spoken"))
        });
        if response.changed() {
            app.settings.goal_c = app.settings.celsius(degrees);
        }
    });
    show_advice(app, ui);
}

/// A button for each class but the least done.
fn goals(settings: &mut Settings, ui: &mut Ui, scale: &Scale) {
    for class in scale.class.iter().skip(1) {
        let goal = class.from_c + GOAL_INTO_CLASS;
        let name = RichText::new(settings.language.called("class", &class.name)).size(if scale.class.len() > 4 {
            11.5
        } else {
            15.0
        });
        if ui.selectable_label((settings.goal_c - goal).abs() < 0.5, name).clicked() {
            settings.goal_c = goal;
        }
    }
}

/// Shows what to do next.
pub fn show_advice(app: &mut SauteApp, ui: &mut Ui) {
    let (text, now) = advice(app);
    let text = RichText::new(text).size(14.5);
    let label = egui::Label::new(if now { text.color(theme::of(ui).accent).strong() } else { text });
    // Always the same height, so that the curves below stay where they are.
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), ADVICE_HEIGHT), egui::Sense::hover());
    ui.scope_builder(egui::UiBuilder::new().max_rect(rect), |ui| ui.add(label));
}

/// What to do next, in the cook's words, and whether it is to be done now.
fn advice(app: &mut SauteApp) -> (String, bool) {
    let (goal, l) = (app.settings.goal_c, app.settings.language);
    let forecast = app.session.forecast();
    let at = |key, celsius: f64| l.fill(key, &[("temperature", &app.settings.temperature(celsius))]);
    let Some(piece) = app.session.steak() else { return (String::new(), false) };
    let pan = celsius(app.session.kitchen.pan_temperature());
    match (piece.place, forecast) {
        (Place::Waiting, _) if pan < 160.0 && app.session.kitchen.hob_w() == 0.0 => {
            (l.text("advice.turn_on").to_owned(), false)
        }
        (Place::Waiting, _) if pan < 160.0 => (at("advice.heating", 180.0), false),
        (Place::Waiting | Place::Pan(_), _) if pan > TOO_HOT_C => (l.text("advice.too_hot").to_owned(), true),
        (Place::Waiting, _) => (l.fill("advice.put_in", &[("food", &l.called("noun", &app.session.noun()))]), true),
        (Place::Pan(_), _) if app.scale().is_none() && wet_below(piece) => (l.text("advice.wet").to_owned(), false),
        (Place::Pan(_), _) if app.scale().is_none() => (l.text("advice.browns").to_owned(), false),
        (Place::Pan(_), Some(f)) if f.peak_c >= goal => (at("advice.take_out", f.peak_c), true),
        (Place::Pan(_), Some(f)) => {
            (at(if wet_below(piece) { "advice.would_peak_wet" } else { "advice.would_peak" }, f.peak_c), false)
        }
        (Place::Rest(_), _) => {
            let peak = celsius(piece.core_peak.0);
            let Some(scale) = app.scale() else { return (at("advice.resting", peak), false) };
            let class = l.called("class", scale.name_of(piece.core_peak.0));
            let temperature = app.settings.temperature(peak);
            let scale = l.called("scale", &scale.name);
            let open: [(&str, &dyn std::fmt::Display); 3] =
                [("temperature", &temperature), ("class", &class), ("scale", &scale)];
            (l.fill("advice.resting_class", &open), false)
        }
        _ => (String::new(), false),
    }
}

fn wet_below(piece: &Piece) -> bool {
    celsius(piece.face(true)) < 106.0
}
