//! The button that plays what a cue means.

use egui::accesskit::Role;
use egui::{Ui, WidgetInfo, vec2};
use saute_controls::act::{Act, Acts, AppAct};
use saute_controls::context::PanelContext;
use saute_session::hearing::example::Example;
use saute_session::permits::Permit;

use crate::ui::loudspeaker::Loudspeaker;
use crate::ui::{fingers, theme};

/// Size of the button [points]: the words beside it keep their room.
const WIDTH: f32 = 26.0;
const HEIGHT: f32 = 20.0;

/// Shows it where the cue is one to hear, and the sound is on.
pub fn button(state: &PanelContext, example: Option<Example>, ui: &mut Ui, acts: &mut Acts) {
    let may_sound = state.session.permits.allow(&[Permit::Sound]) && state.settings.sound;
    let Some(example) = example.filter(|_| may_sound) else { return };
    let (l, palette) = (state.settings.language, theme::of(ui));
    let response = ui.add(palette.button("", false).min_size(vec2(WIDTH, fingers::height(ui, HEIGHT))));
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, l.text("heard.play")));
    let drawn = Loudspeaker { ink: palette.accent, scale: 0.7, on: true };
    drawn.paint(ui.painter(), response.rect.center());
    if response.on_hover_text(l.text("heard.play_hint")).clicked() {
        acts.push(Act::App(AppAct::Hear(example)));
    }
}
