//! What is inside now: the cut, doneness, temperatures, the goal and the curves.

use egui::{RichText, Ui, vec2};
use saute_kitchen::advice::class_goal;
use saute_kitchen::advice::coaching::Coaching;
use saute_kitchen::food::Scale;
use saute_kitchen::food::change::doneness::Measure;
use saute_kitchen::{Piece, Place, celsius};

use crate::panels::cook::heard;
use crate::panels::learn::coach;
use crate::panels::now::control_place;
use crate::panels::section_read::Inside;
use crate::panels::{ahead, curves, doneness_bar, probes};
use crate::ui::aloud::spoken_value;
use crate::ui::{fingers, theme};
use saute_controls::act::{Act, Acts, AppAct, Card, Setting, ViewAct};
use saute_controls::context::PanelContext;
use saute_controls::goal_choice::named_goal;
use saute_controls::reads_context;
use saute_controls::settings::Settings;
use saute_sound::Snapshot;
use saute_words::clock::clock;
use saute_words::doneness_words;

/// Height of the picture of the cut at most [points].
const CUT_HEIGHT: f32 = 42.0;
/// Difference of the hottest place of the pan from the mean from which it is shown [K] (chosen: less makes no other crust).
const UNEVEN_K: f64 = 5.0;
/// Room for the words of the coach: a line of what to perceive, two of what happens [points].
const COACH_HEIGHT: f32 = 50.0;

/// What the panel reads.
pub struct InsideState<'a> {
    /// What every panel reads.
    pub context: PanelContext<'a>,
    /// Place of the cut (−1…1).
    pub cut_at: f64,
    /// True if the next click puts a probe in.
    pub placing: bool,
    /// What is heard; none where a study leaves no sound.
    pub heard: Option<Snapshot>,
    /// What a coach states of the piece; none where the coach is off.
    pub coaching: Option<&'a Coaching>,
    /// True while a plan is kept to: its guide alone states what to do.
    pub guide_leads: bool,
}

reads_context!(InsideState);

/// Shows the panel.
pub fn show(state: &InsideState, inside: &mut Inside, ui: &mut Ui, acts: &mut Acts) {
    let Some(piece) = state.session.shown_piece() else {
        ui.label(state.settings.language.text("inside.no_food"));
        return;
    };
    if !state.reads_out() {
        return skill(state, ui, acts);
    }
    inside.refresh(state, piece, state.cut_at, ui);
    (ui.spacing_mut().item_spacing.y, ui.spacing_mut().interact_size.y) = (4.0, fingers::height(ui, 26.0));
    goal(state, ui, acts);
    cut(state, inside, ui, acts);
    doneness_bar::show(state, inside, ui, acts);
    readings(state, inside, piece, ui);
    let (open, ahead) = (state.settings.curves_open, saute_controls::ahead_words::are_shown(state));
    if ahead && !open {
        ahead::line::show(state, ui);
    }
    probes::show(state, ui, acts);
    more(state, ui, acts);
    if open {
        heard::show(state, state.heard.as_ref(), ui);
    }
    if open && ahead {
        ahead::table::show(state, ui, acts);
    }
    if open {
        let height = (ui.available_height() - 36.0).clamp(if ahead { 110.0 } else { 128.0 }, 280.0);
        curves::show(state, ui, height);
    }
}

/// Opens and closes the curves with all readings.
fn more(state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
    let open = state.settings.curves_open;
    let l = state.settings.language;
    ui.horizontal(|ui| {
        result(state, ui, acts);
        let text = RichText::new(l.text(if open { "inside.less" } else { "inside.more" })).size(13.0);
        let size = vec2(ui.available_width(), fingers::height(ui, 24.0));
        let button = egui::Button::new(text).min_size(size).truncate();
        if ui.add(button).on_hover_text(crate::bindings::hint(&Act::View(ViewAct::Curves), l)).clicked() {
            acts.push(Act::View(ViewAct::Curves));
        }
    });
}

/// Opens the result, once the food was taken out.
fn result(state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
    let is_out = state.session.shown_piece().is_some_and(|piece| matches!(piece.place, Place::Rest(_)));
    if !is_out {
        return;
    }
    let (l, act) = (state.settings.language, Act::App(AppAct::Open(Card::Result)));
    let text = RichText::new(l.text("result.title")).size(13.0).strong();
    let response = ui.add(egui::Button::new(text).min_size(vec2(64.0, fingers::height(ui, 24.0))));
    control_place::note(ui, &act, response.rect);
    if response.on_hover_text(l.text("result.hint")).clicked() {
        acts.push(act);
    }
}

/// What is in place of all readings in skill mode.
fn skill(state: &InsideState, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    ui.label(RichText::new(l.text("skill.title")).size(16.0).strong());
    ui.label(RichText::new(l.text("skill.how")).size(13.5).color(theme::of(ui).quiet));
    // It replaces what a cook hears.
    heard::show(state, state.heard.as_ref(), ui);
    ui.horizontal_wrapped(|ui| {
        result(state, ui, acts);
        let size = vec2(0.0, fingers::height(ui, 24.0));
        let end = egui::Button::new(RichText::new(l.text("skill.end")).size(13.0)).min_size(size);
        if ui.add(end).clicked() {
            acts.push(Act::App(AppAct::Set(Setting::SkillMode(false))));
        }
    });
}

fn cut(state: &InsideState, inside: &Inside, ui: &mut Ui, acts: &mut Acts) {
    let Some(texture) = inside.cut.texture() else { return };
    let width = ui.available_width();
    let size = texture.size_vec2();
    let scale = (width / size.x).min(CUT_HEIGHT / size.y);
    let l = state.settings.language;
    let food = state.session.noun(l);
    let alt = l.fill("inside.section", &[("food", &food)]);
    ui.vertical_centered(|ui| {
        ui.add(egui::Image::new((texture.id(), size * scale)).corner_radius(5).alt_text(alt));
    });
    let mut place = state.cut_at;
    ui.horizontal(|ui| {
        ui.label(RichText::new(l.text("inside.cut_at")).size(13.0).color(theme::of(ui).quiet));
        let beside = if state.placing { 124.0 } else { 84.0 };
        ui.spacing_mut().slider_width = ui.available_width() - beside - 16.0;
        let slider = egui::Slider::new(&mut place, -0.95..=0.95).show_value(false);
        let response = ui.add(slider);
        let name = l.fill("inside.place_of_cut", &[("food", &food)]);
        response.widget_info(|| egui::WidgetInfo::slider(true, place, &name));
        spoken_value(ui, &response, format!("{:.0} %", 50.0 + 50.0 * place));
        if response.changed() {
            acts.push(Act::View(ViewAct::SliceAt(place)));
        }
        probes::add_button(state, state.placing, ui, acts);
    });
}

fn readings(state: &PanelContext, inside: &Inside, piece: &Piece, ui: &mut Ui) {
    let settings = state.settings;
    let kitchen = &state.session.kitchen;
    let mass = 1e3 * piece.mass();
    let lost = 100.0 * (1.0 - mass / state.session.start_mass_g());
    let since = piece.flipped_at().map(|t| kitchen.time_s() - t);
    let hardness = format!("{:.1}", inside.bite[0]);
    let juiciness = inside.bite[1];
    let temperature = |kelvin: f64| settings.temperature(celsius(kelvin));
    let rows = [
        [("inside.core", temperature(piece.core())), ("inside.pan", pan(state))],
        [("inside.underside", temperature(piece.face(true))), ("inside.upper_side", temperature(piece.face(false)))],
        [("inside.mass", grams(mass)), ("inside.lost", format!("{:.1} %", tidy(lost)))],
        [
            ("inside.hardness", settings.language.fill("inside.hardness_value", &[("value", &hardness)])),
            ("inside.juiciness", format!("{juiciness:.0} %")),
        ],
        [("inside.time", clock(kitchen.time_s())), ("inside.since_flip", since.map_or_else(|| "–".into(), clock))],
    ];
    // The rest belongs to the curves.
    let shown = if state.settings.curves_open { rows.len() } else { 2 };
    // With the forecasts the curves are still in sight.
    ui.spacing_mut().interact_size.y =
        if state.settings.curves_open && saute_controls::ahead_words::are_shown(state) { 18.0 } else { 21.0 };
    // The hottest place of an uneven pan is the widest value: it ends before the bar of the open panel.
    egui::Grid::new("readings").num_columns(4).min_col_width(52.0).spacing(vec2(5.0, 3.0)).show(ui, |ui| {
        for row in rows.into_iter().take(shown) {
            for (name, value) in row {
                ui.label(RichText::new(settings.language.text(name)).size(12.5).color(theme::of(ui).quiet));
                ui.label(RichText::new(value).size(15.0).strong());
            }
            ui.end_row();
        }
    });
}

/// The mean temperature of the pan's floor, and of its hottest place where that is another.
fn pan(state: &PanelContext) -> String {
    let kitchen = &state.session.kitchen;
    let [mean, hottest] = [kitchen.pan_temperature(), kitchen.hottest_temperature()].map(celsius);
    let l = state.settings.language;
    if hottest - mean < UNEVEN_K {
        return state.settings.temperature(mean);
    }
    let mean = format!("{:.0}", state.settings.degrees(mean));
    l.fill("inside.pan_uneven", &[("mean", &mean), ("hottest", &state.settings.temperature(hottest))])
}

/// A mass with as many places as it takes to see it change.
fn grams(mass: f64) -> String {
    if mass < 50.0 { format!("{mass:.1} g") } else { format!("{mass:.0} g") }
}

/// A percentage rounded to a tenth; adding zero turns −0.0 into 0.0, which would print as −0.0.
fn tidy(percent: f64) -> f64 {
    (10.0 * percent).round() / 10.0 + 0.0
}

fn goal(state: &InsideState, ui: &mut Ui, acts: &mut Acts) {
    let Some(scale) = state.scale() else {
        return coached(state, ui, acts);
    };
    let l = state.settings.language;
    // Japanese names are wide: the last of them may need a second line.
    ui.horizontal_wrapped(|ui| {
        let many = scale.class.len() > 4;
        (ui.spacing_mut().button_padding.x, ui.spacing_mut().item_spacing.x) =
            if many { (3.0, 2.0) } else { (6.0, 4.0) };
        let text = RichText::new(l.text("inside.goal")).size(if many { 11.0 } else { 12.5 }).underline();
        if ui
            .add(egui::Button::new(text.color(theme::of(ui).quiet)).frame(false))
            .on_hover_text(goal_hint(state))
            .clicked()
        {
            acts.push(Act::App(AppAct::Open(Card::Goals)));
        }
        goals(state.settings, &scale, ui, acts);
        let share = scale.measure() == Measure::Share;
        let goal = state.settings.goal(&scale);
        let mut shown = if share { goal } else { state.settings.degrees(goal) };
        let range = if share { 1.0..=99.0 } else { state.settings.degrees(45.0)..=state.settings.degrees(85.0) };
        let unit = if share { " %".to_owned() } else { format!(" {}", state.settings.unit()) };
        let drag = egui::DragValue::new(&mut shown).range(range).speed(0.2).max_decimals(0).suffix(unit);
        let response = ui.add(drag);
        response.widget_info(|| {
            egui::WidgetInfo::labeled(egui::accesskit::Role::SpinButton, true, l.text("inside.goal_spoken"))
        });
        if response.changed() {
            acts.push(Act::App(AppAct::Set(Setting::Goal(if share { shown } else { state.settings.celsius(shown) }))));
        }
    });
    coached(state, ui, acts);
}

/// The goal that the cook is judged by.
fn goal_hint(state: &PanelContext) -> String {
    let l = state.settings.language;
    let named = named_goal(state.session, state.settings);
    named.map_or_else(
        || l.text("inside.goals_hint").to_owned(),
        |goal| l.fill("inside.goal_named", &[("goal", &l.named("goal", &goal.name, &goal.names))]),
    )
}

/// A button for each class but the least done.
fn goals(settings: &Settings, scale: &Scale, ui: &mut Ui, acts: &mut Acts) {
    for (place, class) in scale.class.iter().enumerate().skip(1) {
        let goal = class_goal(scale, place);
        let name = doneness_words::class(scale, &class.name, settings.language);
        let name = RichText::new(name).size(if scale.class.len() > 4 { 11.5 } else { 15.0 });
        let on = (settings.goal(scale) - goal).abs() < 0.5;
        if ui.selectable_label(on, name).on_hover_text(settings.language.text("inside.goal_hint")).clicked() {
            acts.push(Act::App(AppAct::Set(Setting::Goal(goal))));
        }
    }
}

/// What a coach states of the cook: what to perceive next, and what happens.
fn coached(state: &InsideState, ui: &mut Ui, acts: &mut Acts) {
    // Always the same height, so that what is below stays where it is.
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), COACH_HEIGHT), egui::Sense::hover());
    let mut child = ui.new_child(egui::UiBuilder::new().max_rect(rect));
    child.set_clip_rect(rect.expand(2.0).intersect(ui.clip_rect()));
    child.spacing_mut().item_spacing.y = 1.0;
    if state.guide_leads {
        let words = state.settings.language.text("plan.leads");
        child.add(egui::Label::new(RichText::new(words).size(13.0)).truncate()).on_hover_text(words);
    }
    coach::show(state, state.coaching, &mut child, acts, false);
}
