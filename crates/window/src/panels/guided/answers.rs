//! Fields of a card: steps, numbers, choices, and free text.

use egui::{RichText, TextEdit, Ui, vec2};
use saute_study::{Answer, Answering, LIKERT_STEPS};

use super::Entries;
use crate::ui::theme;
use saute_controls::context::PanelContext;

/// Width of a field for a number, and of one for text [points].
const NUMBER: f32 = 110.0;
const TEXT: f32 = 420.0;

/// Shows a question with its field; returns the answer, once there is one in its range.
pub(super) fn item(
    state: &PanelContext,
    ui: &mut Ui,
    (id, text): (&str, &str),
    answering: &Answering,
    entries: &mut Entries,
) -> Option<Answer> {
    let name = ui.label(RichText::new(text).size(15.0)).id;
    let answer = match answering {
        Answering::Likert(ends) => steps(state, ui, id, ends, entries),
        Answering::Number(range, unit) => number(state, ui, id, (*range, unit), entries, name),
        Answering::Choice(choices) => choice(state, ui, id, choices, entries),
        Answering::Text => free_text(state, ui, id, entries, name),
    };
    ui.add_space(8.0);
    answer
}

fn steps(
    state: &PanelContext,
    ui: &mut Ui,
    id: &str,
    [low, high]: &[String; 2],
    entries: &mut Entries,
) -> Option<Answer> {
    let l = state.settings.language;
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        ui.spacing_mut().button_padding.x = 4.0;
        for step in 1..=usize::from(LIKERT_STEPS) {
            let on = entries.places.get(id) == Some(&step);
            let response = ui.add(theme::of(ui).button(&step.to_string(), on).min_size(vec2(40.0, theme::TOUCH)));
            let spoken = l.fill("guided.step", &[("step", &step), ("low", low), ("high", high)]);
            response.widget_info(|| egui::WidgetInfo::selected(egui::accesskit::Role::RadioButton, true, on, &spoken));
            if response.clicked() {
                entries.places.insert(id.to_owned(), step);
            }
        }
    });
    let ends = l.fill("guided.ends", &[("low", low), ("high", high)]);
    ui.label(RichText::new(ends).size(12.5).color(theme::of(ui).quiet));
    entries.places.get(id).map(|step| Answer::Number(*step as f64))
}

fn number(
    state: &PanelContext,
    ui: &mut Ui,
    id: &str,
    ([low, high], unit): ([f64; 2], &str),
    entries: &mut Entries,
    name: egui::Id,
) -> Option<Answer> {
    let text = entries.texts.entry(id.to_owned()).or_default();
    let value = text.trim().replace(',', ".").parse::<f64>().ok().filter(|v| (low..=high).contains(v));
    ui.horizontal(|ui| {
        theme::field(ui, TextEdit::singleline(text).desired_width(NUMBER)).labelled_by(name);
        ui.label(unit);
        if value.is_none() {
            let range = state.settings.language.fill("guided.range", &[("low", &low), ("high", &high)]);
            ui.label(RichText::new(range).size(12.5).color(theme::of(ui).quiet));
        }
    });
    value.map(Answer::Number)
}

fn choice(state: &PanelContext, ui: &mut Ui, id: &str, choices: &[String], entries: &mut Entries) -> Option<Answer> {
    ui.horizontal_wrapped(|ui| {
        for (place, choice) in choices.iter().enumerate() {
            let on = entries.places.get(id) == Some(&place);
            let words = state.settings.language.called("class", choice);
            if ui.add(theme::of(ui).button(words, on)).clicked() {
                entries.places.insert(id.to_owned(), place);
            }
        }
    });
    entries.places.get(id).map(|place| Answer::Choice(*place))
}

fn free_text(state: &PanelContext, ui: &mut Ui, id: &str, entries: &mut Entries, name: egui::Id) -> Option<Answer> {
    let text = entries.texts.entry(id.to_owned()).or_default();
    theme::field(ui, TextEdit::singleline(text).desired_width(TEXT.min(ui.available_width()))).labelled_by(name);
    ui.label(RichText::new(state.settings.language.text("guided.no_names")).size(12.5).color(theme::of(ui).accent));
    Some(Answer::Text(text.clone()))
}
