//! The menu of what there is to learn and to try.

use egui::{Rect, RichText, Ui, vec2};

use crate::panels::cards::frame::{Framed, list};
use crate::ui::{fingers, theme};
use saute_controls::act::{Act, Acts, AppAct, Card, LearnAct};
use saute_controls::context::PanelContext;

/// Width of the card at most [points].
const WIDTH: f32 = 520.0;
/// Height of a button [points].
const HEIGHT: f32 = 30.0;

/// Keys of the name and of what it is, and what its button does.
type LearnRow = (&'static str, &'static str, Act);

/// What the menu offers, in its order.
const ENTRIES: [LearnRow; 7] = [
    ("tutorial.title", "learn.tutorial", Act::Learn(LearnAct::Tutorial(true))),
    ("goals.title", "learn.goals", Act::App(AppAct::Open(Card::Goals))),
    ("plan.title", "learn.plan", Act::App(AppAct::Open(Card::Plan))),
    ("lesson.title", "learn.lessons", Act::App(AppAct::Open(Card::Lessons))),
    ("athome.title", "learn.athome", Act::App(AppAct::Open(Card::AtHome))),
    ("help.first_steps", "learn.first_steps", Act::App(AppAct::Open(Card::FirstSteps))),
    ("help.title", "learn.help", Act::App(AppAct::Open(Card::Help))),
];

/// Shows the menu over everything; Esc, the button or a click beside it closes it.
pub fn show(state: &PanelContext, ui: &Ui, acts: &mut Acts, whole: Rect) {
    let framed = Framed { card: Card::Learn, id: "learn", title: "learn.title", width: WIDTH };
    framed.show(state, ui, acts, whole, |ui, acts| {
        list(ui, whole, |ui| ENTRIES.iter().for_each(|entry| row(state, ui, acts, entry)));
    });
}

fn row(state: &PanelContext, ui: &mut Ui, acts: &mut Acts, (name, what, act): &LearnRow) {
    let l = state.settings.language;
    let size = vec2(ui.available_width(), fingers::height(ui, HEIGHT));
    if ui.add(theme::of(ui).button(l.text(name), false).min_size(size)).clicked() {
        acts.push(act.clone());
    }
    ui.label(RichText::new(l.text(what)).size(13.0).color(theme::of(ui).quiet));
    ui.add_space(6.0);
}
