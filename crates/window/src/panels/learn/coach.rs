//! The coach's sentences below the advice: what happens and why, and the next cue.

use egui::{Align, Label, Layout, RichText, Ui, vec2};
use saute_kitchen::advice::coaching::Coaching;

use super::hear;
use crate::ui::theme;
use saute_controls::act::Acts;
use saute_controls::context::PanelContext;
use saute_session::hearing::example::Example;
use saute_words::coach_words;

/// Height of two lines of the sentence [points].
const TWO_LINES: f32 = 29.0;

/// Shows both where the coach is on; on a narrow window the cue alone.
pub fn show(state: &PanelContext, coaching: Option<&Coaching>, ui: &mut Ui, acts: &mut Acts, cue_alone: bool) {
    let Some(coaching) = coaching.filter(|_| state.reads_out()) else { return };
    let palette = theme::of(ui);
    let happening = coach_words::happening(coaching, state.settings.speech());
    if let Some(cue) = coach_words::cue(coaching, state.settings.speech()) {
        let example = coaching.cue.and_then(Example::of_cue);
        ui.allocate_ui_with_layout(
            vec2(ui.available_width(), hear::HEIGHT),
            Layout::left_to_right(Align::Center),
            |ui| {
                hear::button(state, example, ui, acts);
                let words = Label::new(RichText::new(cue).size(13.0).strong()).truncate();
                ui.add(words).on_hover_text(cue);
            },
        );
    }
    if !cue_alone {
        let words = Label::new(RichText::new(&happening).size(12.5).color(palette.quiet));
        // A second line only where there is room for it.
        let fits = ui.available_height() >= TWO_LINES;
        ui.add(if fits { words.wrap() } else { words.truncate() }).on_hover_text(&happening);
    }
}
