//! The button that plays what a cue means.

use egui::{Button, RichText, Ui};
use saute_controls::act::{Act, Acts, AppAct};
use saute_controls::context::PanelContext;
use saute_session::hearing::example::Example;
use saute_session::permits::Permit;

use crate::ui::theme;

/// Shows it where the cue is one to hear, and the sound is on.
pub fn button(state: &PanelContext, example: Option<Example>, ui: &mut Ui, acts: &mut Acts) {
    let may_sound = state.session.permits.allow(&[Permit::Sound]) && state.settings.sound;
    let Some(example) = example.filter(|_| may_sound) else { return };
    let (l, palette) = (state.settings.language, theme::of(ui));
    let text = RichText::new(l.text("heard.play")).size(12.0).color(palette.accent);
    if ui.add(Button::new(text).small()).on_hover_text(l.text("heard.play_hint")).clicked() {
        acts.push(Act::App(AppAct::Hear(example)));
    }
}
