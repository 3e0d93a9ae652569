//! The card of the lessons.

use egui::{Rect, RichText, ScrollArea, Ui, vec2};
use saute_study::class::{Scenario, shipped};

use crate::panels::cards::frame::Framed;
use crate::ui::{fingers, theme};
use saute_controls::act::GuidedAct;
use saute_controls::act::{Act, Acts, Card, LearnAct};
use saute_controls::context::PanelContext;

/// Width of the card at most [points].
const WIDTH: f32 = 520.0;
/// Height of a button [points].
const HEIGHT: f32 = 30.0;

/// Shows the lessons over everything; Esc, the button or a click beside it closes it.
pub fn show(state: &PanelContext, ui: &Ui, acts: &mut Acts, whole: Rect) {
    let framed = Framed { card: Card::Lessons, id: "lessons", title: "lesson.title", width: WIDTH };
    framed.show(state, ui, acts, whole, |ui, acts| {
        let list = ScrollArea::vertical().max_height(whole.height() - 140.0);
        list.show(ui, |ui| {
            ui.label(RichText::new(state.settings.language.text("lesson.what")).size(13.0).color(theme::of(ui).quiet));
            for (id, text) in shipped::SHIPPED {
                // A test reads all of them.
                if let Ok(scenario) = Scenario::parse(text, id, &state.session.library) {
                    row(state, ui, acts, id, &scenario);
                }
            }
        });
    });
}

fn row(state: &PanelContext, ui: &mut Ui, acts: &mut Acts, id: &str, scenario: &Scenario) {
    let language = state.settings.language.code();
    let size = vec2(ui.available_width(), fingers::height(ui, HEIGHT));
    if ui.add(theme::of(ui).button(scenario.title.of(language), false).min_size(size)).clicked() {
        acts.push(Act::Learn(LearnAct::Guided(GuidedAct::Lesson(id.to_owned()))));
    }
    ui.label(RichText::new(scenario.intro.of(language)).size(13.0).color(theme::of(ui).quiet));
    ui.add_space(6.0);
}
