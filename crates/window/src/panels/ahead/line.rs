//! Forecasts in one line, under the readings.

use egui::{Label, RichText, Sense, Ui, UiBuilder, vec2};
use saute_plan::forecast::Question;

use crate::ui::theme;
use saute_controls::ahead_words::{age_words, class, class_of_peak};
use saute_controls::context::PanelContext;

/// Its height, which it keeps while there is nothing to show [points].
const HEIGHT: f32 = 16.0;
/// How far ahead it looks [s].
const AHEAD_S: f64 = 120.0;

/// Shows the line.
pub fn show(state: &PanelContext, ui: &mut Ui) {
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), HEIGHT), Sense::hover());
    let Some((words, is_current)) = words(state) else { return };
    let ink = if is_current { theme::of(ui).text } else { theme::of(ui).quiet };
    let mut child = ui.new_child(UiBuilder::new().max_rect(rect));
    let label = Label::new(RichText::new(&words).size(13.0).color(ink)).truncate();
    let hint = state.settings.language.text(if is_current { "ahead.line_hint" } else { "ahead.stale" });
    child.add(label).on_hover_text(format!("{words}\n{hint}"));
}

/// The words, and whether they still apply.
fn words(state: &PanelContext) -> Option<(String, bool)> {
    let (settings, l) = (state.settings, state.settings.language);
    let as_it_is = state.session.foreseen(Question::AsItIs)?;
    let shown = |kelvin: f64| settings.temperature(saute_kitchen::celsius(kelvin));
    let core = shown(as_it_is.core_in(AHEAD_S).0);
    let out = state.session.foreseen(Question::TakeOut);
    let last = out.as_ref().unwrap_or(&as_it_is);
    if !(as_it_is.is_current && last.is_current) {
        // What was foreseen in the pan would frighten once it is out.
        return Some((l.text("ahead.stale").to_owned(), false));
    }
    // One number for one question: the advice above answers it too.
    let expected = state.session.expected_peak_c();
    let peak = expected.map_or_else(|| shown(last.answer.outlook.peak.core), |c| settings.temperature(c));
    let age = age_words(state, &as_it_is);
    let class = expected.and_then(|c| class_of_peak(state, c)).or_else(|| class(state, &last.answer.outlook));
    // An age takes the room of the class.
    let peak = match class.filter(|_| age.is_none()) {
        Some(class) => l.fill("ahead.peak_class", &[("peak", &peak), ("class", &class)]),
        None => peak,
    };
    let key = if out.is_some() { "ahead.line" } else { "ahead.line_out" };
    let mut words = l.fill(key, &[("core", &core), ("peak", &peak)]);
    if let Some(age) = age {
        words = format!("{words} · {age}");
    }
    Some((words, true))
}
