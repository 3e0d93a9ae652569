//! What was observed: what was cooked, the log of a thermometer, and values by hand.

use egui::{RichText, TextEdit, Ui, vec2};

use super::at_home_state::AtHomeState;
use crate::ui::theme;
use saute_controls::act::{Act, Acts, LearnAct};
use saute_controls::at_home::AtHomeAct;
use saute_controls::at_home::SCALE;
use saute_controls::context::PanelContext;
use saute_session::at_home::entered::{Cooked, Row, Seen};
use saute_words::doneness_words;

/// Most rows by hand [-] (chosen: who has more has a log).
const MOST_ROWS: usize = 40;

/// Shows what is entered, and the button that fits.
pub fn show(state: &AtHomeState, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    ui.label(RichText::new(l.text("athome.cooked")).strong());
    cooked(state, ui, acts);
    ui.add_space(6.0);
    ui.label(RichText::new(l.text("athome.log")).strong());
    super::log::show(state, ui, acts);
    ui.add_space(6.0);
    ui.label(RichText::new(l.text("athome.by_hand")).strong());
    rows(state, ui, acts);
    ui.add_space(6.0);
    let size = vec2(ui.available_width(), theme::TOUCH);
    let button = theme::of(ui).primary(l.text("athome.fit")).min_size(size);
    if ui.add_enabled(!state.at_home.is_fitting(), button).clicked() {
        acts.push(Act::Learn(LearnAct::AtHome(AtHomeAct::Fit)));
    }
}

/// What was cooked, and the file of a recipe.
fn cooked(state: &AtHomeState, ui: &mut Ui, acts: &mut Acts) {
    let (l, entered) = (state.settings.language, &state.at_home.entered);
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = vec2(5.0, 5.0);
        for cooked in Cooked::ALL {
            let (text, on) = (l.text(cooked.words()), entered.cooked == cooked);
            let response = ui.add(theme::of(ui).button(text, on));
            response.widget_info(|| egui::WidgetInfo::selected(egui::accesskit::Role::RadioButton, true, on, text));
            if response.clicked() {
                acts.push(Act::Learn(LearnAct::AtHome(AtHomeAct::Cooked(cooked))));
            }
        }
    });
    let said = match (&entered.recipe, entered.cooked) {
        (Some((name, _)), Cooked::File) => l.fill("athome.recipe_is", &[("file", &file_name(name))]),
        (_, Cooked::File) => l.text("athome.recipe_how").to_owned(),
        (_, Cooked::Plan) => l.text("athome.plan_how").to_owned(),
        (_, Cooked::Shown) => l.text("athome.shown_how").to_owned(),
    };
    ui.label(RichText::new(said).size(13.0).color(theme::of(ui).quiet));
}

/// The name of a file without its folders.
pub(super) fn file_name(path: &str) -> &str {
    path.rsplit(['/', '\\']).next().unwrap_or(path)
}

/// Values by hand, a row each.
fn rows(state: &AtHomeState, ui: &mut Ui, acts: &mut Acts) {
    let (l, entered) = (state.settings.language, &state.at_home.entered);
    let mut rows = entered.rows.clone();
    let mut gone = None;
    for (at, row) in rows.iter_mut().enumerate() {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 5.0;
            one(state, ui, at, row);
            let remove = ui.add(theme::of(ui).button("×", false).min_size(vec2(30.0, 30.0)));
            let spoken = l.fill("athome.remove_row", &[("row", &(at + 1))]);
            remove.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Button, true, &spoken));
            if remove.clicked() {
                gone = Some(at);
            }
        });
    }
    if let Some(at) = gone {
        rows.remove(at);
    }
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = vec2(5.0, 5.0);
        for seen in Seen::ALL {
            let text = l.fill("athome.add", &[("what", &l.text(seen.words()))]);
            let button = theme::of(ui).button(&text, false);
            if ui.add_enabled(rows.len() < MOST_ROWS, button).clicked() {
                rows.push(Row { seen, time: String::new(), value: String::new() });
            }
        }
    });
    if !rows.is_empty() {
        ui.label(RichText::new(l.text("athome.rows_how")).size(13.0).color(theme::of(ui).quiet));
    }
    if rows != entered.rows {
        acts.push(Act::Learn(LearnAct::AtHome(AtHomeAct::Rows(rows))));
    }
}

fn one(state: &PanelContext, ui: &mut Ui, at: usize, row: &mut Row) {
    let l = state.settings.language;
    let what = l.text(row.seen.words());
    let cell = vec2(112.0, ui.spacing().interact_size.y);
    ui.allocate_ui(cell, |ui| {
        ui.set_min_size(cell);
        ui.label(what);
    });
    let field = |ui: &mut Ui, text: &mut String, hint: &str, width: f32, spoken: String| {
        let edit = TextEdit::singleline(text).hint_text(hint).desired_width(width);
        theme::field(ui, edit)
            .widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::TextInput, true, &spoken));
    };
    let number = at + 1;
    let end = l.text("athome.at_end");
    let hint = if matches!(row.seen, Seen::Weight | Seen::Class) { end } else { "1:30" };
    field(ui, &mut row.time, hint, 64.0, l.fill("athome.time_of", &[("row", &number), ("what", &what)]));
    if row.seen == Seen::Class {
        return class(state, ui, at, row);
    }
    let unit = if row.seen == Seen::Weight { "g" } else { state.settings.unit() };
    field(ui, &mut row.value, unit, 84.0, l.fill("athome.value_of", &[("row", &number), ("what", &what)]));
}

fn class(state: &PanelContext, ui: &mut Ui, at: usize, row: &mut Row) {
    let l = state.settings.language;
    let Some(scale) = state.session.library.scale(SCALE) else { return };
    if row.value.is_empty() {
        row.value = scale.class.iter().find(|class| class.name == "medium").map_or(String::new(), |c| c.name.clone());
    }
    let shown = doneness_words::class(scale, &row.value, l).to_owned();
    let combo = egui::ComboBox::from_id_salt(("class", at)).selected_text(&shown).width(104.0);
    let response = combo.show_ui(ui, |ui| {
        for class in &scale.class {
            ui.selectable_value(&mut row.value, class.name.clone(), doneness_words::class(scale, &class.name, l));
        }
    });
    let spoken = format!("{}: {shown}", l.text(Seen::Class.words()));
    response.response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::ComboBox, true, &spoken));
}
