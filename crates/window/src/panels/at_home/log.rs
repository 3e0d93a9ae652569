//! The log of a thermometer: its columns, their unit, its times, and how it reads.

use egui::{DragValue, RichText, Ui, vec2};
use saute_plan::fit::log::log_error::{LogError, Question};
use saute_plan::fit::log::logger::loggers;
use saute_plan::fit::log::reading::{CurveRead, Pick, Reading};
use saute_plan::fit::log::times::TimeForm;
use saute_plan::fit::log::unit::Unit;
use saute_session::at_home::open_log::{Columns, OpenLog};
use saute_session::at_home::why_not::WhyNoFit;
use saute_words::clock::clock;

use super::at_home_state::AtHomeState;
use super::entry::file_name;
use crate::ui::theme;
use saute_controls::act::{Act, Acts, AppAct, LearnAct};
use saute_controls::at_home::AtHomeAct;
use saute_controls::context::PanelContext;

/// Shows the log with its columns, or the way to one.
pub fn show(state: &AtHomeState, ui: &mut Ui, acts: &mut Acts) {
    let (l, entered) = (state.settings.language, &state.at_home.entered);
    ui.horizontal_wrapped(|ui| {
        if ui.add(theme::of(ui).button(l.text("athome.choose_file"), false)).clicked() {
            acts.push(Act::App(AppAct::ChooseFile));
        }
        if entered.log.is_some() && ui.add(theme::of(ui).button(l.text("athome.no_log"), false)).clicked() {
            acts.push(Act::Learn(LearnAct::AtHome(AtHomeAct::NoLog)));
        }
        // Beside the buttons: on a low window the button that fits is then still seen.
        if let Some(open) = &entered.log {
            let parts: [(&str, &dyn std::fmt::Display); 2] =
                [("file", &file_name(&open.name)), ("rows", &open.log.rows())];
            ui.label(RichText::new(l.fill("athome.log_is", &parts)).size(13.5));
        }
    });
    let Some(open) = &entered.log else {
        ui.label(RichText::new(l.text("athome.log_how")).size(13.0).color(theme::of(ui).quiet));
        return;
    };
    let mut columns = *open.columns();
    egui::Grid::new("columns").num_columns(2).spacing(vec2(10.0, 6.0)).show(ui, |ui| {
        maker(state, ui, &mut columns);
        choices(state, ui, open, &mut columns);
        shift(state, ui, &mut columns);
    });
    match open.reading() {
        Ok(reading) => as_read(state, ui, reading),
        Err(error) => question(state, ui, error, &mut columns),
    }
    if columns != *open.columns() {
        acts.push(Act::Learn(LearnAct::AtHome(AtHomeAct::Columns(columns))));
    }
}

/// The preset of a maker.
fn maker(state: &PanelContext, ui: &mut Ui, columns: &mut Columns) {
    let l = state.settings.language;
    let none = l.text("athome.by_file");
    let shown = columns.choices.logger.map_or(none, |logger| &logger.name);
    ui.label(l.text("athome.maker"));
    let combo = egui::ComboBox::from_id_salt("maker").selected_text(shown).width(230.0);
    let response = combo.show_ui(ui, |ui| {
        ui.selectable_value(&mut columns.choices.logger, None, none);
        for logger in loggers() {
            ui.selectable_value(&mut columns.choices.logger, Some(logger), &logger.name);
        }
    });
    spoken(&response.response, format!("{}: {shown}", l.text("athome.maker")));
    ui.end_row();
}

/// The columns and their unit.
fn choices(state: &PanelContext, ui: &mut Ui, open: &OpenLog, columns: &mut Columns) {
    let reading = open.reading().ok();
    let by_header = reading.map(|reading| open.log.headers().iter().position(|header| *header == reading.time_column));
    let mut time = columns.choices.time.or(by_header.flatten());
    column(state, ui, open, "athome.time", &mut time, false);
    if time != by_header.flatten() {
        columns.choices.time = time;
    }
    let read =
        |curve: fn(&Reading) -> &Option<CurveRead>| reading.and_then(|reading| curve(reading).as_ref()).map(|c| c.at);
    let mut picks = [
        ("athome.core", &mut columns.choices.core, read(|r| &r.core)),
        ("athome.pan", &mut columns.choices.pan, read(|r| &r.pan)),
    ];
    for (key, pick, read) in &mut picks {
        let shown = match pick {
            Pick::ByHeader => *read,
            Pick::No => None,
            Pick::Column(at) => Some(*at),
        };
        let mut chosen = shown;
        column(state, ui, open, key, &mut chosen, true);
        if chosen != shown {
            **pick = chosen.map_or(Pick::No, Pick::Column);
        }
    }
    unit(state, ui, columns);
}

fn shift(state: &PanelContext, ui: &mut Ui, columns: &mut Columns) {
    let spoken = state.settings.language.text("athome.shift");
    ui.label(spoken);
    let drag = DragValue::new(&mut columns.shift_s).suffix(" s").range(-7200.0..=7200.0).speed(1.0);
    let shown = ui.add_sized(vec2(110.0, ui.spacing().interact_size.y), drag);
    shown.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::SpinButton, true, spoken));
    ui.end_row();
}

fn column(
    state: &PanelContext,
    ui: &mut Ui,
    open: &OpenLog,
    key: &'static str,
    chosen: &mut Option<usize>,
    may_be_none: bool,
) {
    let l = state.settings.language;
    let none = l.text("athome.no_column");
    ui.label(l.text(key));
    let name = |at: usize| format!("{}: {}", at + 1, open.log.header(at));
    let shown = chosen.map_or_else(|| none.to_owned(), name);
    let combo = egui::ComboBox::from_id_salt(key).selected_text(&shown).width(230.0);
    let response = combo.show_ui(ui, |ui| {
        if may_be_none {
            ui.selectable_value(chosen, None, none);
        }
        for at in 0..open.log.headers().len() {
            ui.selectable_value(chosen, Some(at), name(at));
        }
    });
    spoken(&response.response, format!("{}: {shown}", l.text(key)));
    ui.end_row();
}

fn spoken(response: &egui::Response, text: String) {
    response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::ComboBox, true, &text));
}

fn unit(state: &PanelContext, ui: &mut Ui, columns: &mut Columns) {
    let l = state.settings.language;
    ui.label(l.text("settings.unit"));
    ui.horizontal(|ui| {
        let units = [(l.text("athome.by_header"), None), ("°C", Some(Unit::Celsius)), ("°F", Some(Unit::Fahrenheit))];
        for (text, unit) in units {
            let on = columns.choices.unit == unit;
            if ui.add(theme::of(ui).button(text, on).min_size(vec2(40.0, 30.0))).clicked() {
                columns.choices.unit = unit;
            }
        }
    });
    ui.end_row();
}

/// How the log reads: its times, and the unit of its temperatures.
fn as_read(state: &PanelContext, ui: &mut Ui, reading: &Reading) {
    let l = state.settings.language;
    let form = l.text(form_key(reading.time_form));
    let span = clock(reading.span_s);
    let mut said = l.fill("athome.read_times", &[("form", &form), ("span", &span), ("from", &reading.begins)]);
    for (key, curve) in [("athome.core", &reading.core), ("athome.pan", &reading.pan)] {
        let Some(curve) = curve else { continue };
        let parts: [(&str, &dyn std::fmt::Display); 3] =
            [("what", &l.text(key)), ("unit", &curve.unit.sign()), ("rows", &curve.points.len())];
        said = format!("{said} {}", l.fill("athome.read_curve", &parts));
    }
    ui.label(RichText::new(said).size(13.0).color(theme::of(ui).quiet));
}

/// What is wrong, or what information is missing, with the answers that are possible.
fn question(state: &PanelContext, ui: &mut Ui, error: &LogError, columns: &mut Columns) {
    let l = state.settings.language;
    ui.label(RichText::new(WhyNoFit::from(error.clone()).words(l)).size(13.5).color(theme::of(ui).accent));
    let Some(Question::Times(forms)) = &error.question else { return };
    ui.horizontal_wrapped(|ui| {
        for form in forms {
            if ui.add(theme::of(ui).button(l.text(form_key(*form)), false)).clicked() {
                columns.choices.form = Some(*form);
            }
        }
    });
}

/// Key of the name of what times are.
fn form_key(form: TimeForm) -> &'static str {
    match form {
        TimeForm::Milliseconds => "athome.form_ms",
        TimeForm::Seconds => "athome.form_s",
        TimeForm::Minutes => "athome.form_min",
        TimeForm::Hours => "athome.form_h",
        TimeForm::Days => "athome.form_days",
        TimeForm::MinSec => "athome.form_min_s",
        TimeForm::HourMin => "athome.form_h_min",
        TimeForm::Clock => "athome.form_clock",
        TimeForm::Dated => "athome.form_dated",
        TimeForm::Epoch => "athome.form_epoch",
        TimeForm::WithUnits => "athome.form_units",
    }
}
