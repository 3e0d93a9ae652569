//! The button that plays what a cue means.

use egui::accesskit::Role;
use egui::{Sense, Ui, WidgetInfo, vec2};
use saute_controls::act::{Act, Acts, AppAct};
use saute_controls::context::PanelContext;
use saute_session::hearing::example::Example;
use saute_session::permits::Permit;

use crate::ui::loudspeaker::Loudspeaker;
use crate::ui::{fingers, theme};

/// Height of the button [points]: a line's, so that the words beside it and below keep their room.
pub const HEIGHT: f32 = 16.0;
/// Its width [points].
const WIDTH: f32 = 24.0;
/// Size of its drawing over that of the switch on top [-].
const SCALE: f32 = 0.8;

/// Shows it where the cue is one to hear, and the sound is on.
pub fn button(state: &PanelContext, example: Option<Example>, ui: &mut Ui, acts: &mut Acts) {
    let may_sound = state.session.permits.allow(&[Permit::Sound]) && state.settings.sound;
    let Some(example) = example.filter(|_| may_sound) else { return };
    let (l, palette) = (state.settings.language, theme::of(ui));
    let (rect, _) = ui.allocate_exact_size(vec2(WIDTH, HEIGHT), Sense::hover());
    // A finger reaches it from around.
    let reach = 0.5 * (fingers::height(ui, HEIGHT) - HEIGHT);
    let response = ui.interact(rect.expand(reach), ui.scope_id().with("hear"), Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, l.text("heard.play")));
    let is_reached = response.hovered() || response.has_focus();
    let drawn = Loudspeaker { ink: if is_reached { palette.text } else { palette.accent }, scale: SCALE, on: true };
    drawn.paint(ui.painter(), rect.center());
    if response.on_hover_text(l.text("heard.play_hint")).clicked() {
        acts.push(Act::App(AppAct::Hear(example)));
    }
}
