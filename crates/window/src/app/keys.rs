//! Keys that do something at once: which act a press means, and whose a key is.

use egui::{Context, Event, Key};

use super::SauteApp;
use crate::bindings::BINDINGS;
use saute_controls::act::{Act, TimeAct};

impl SauteApp {
    /// Carries out what was pressed since the last frame. A text field takes all keys, a widget with the focus only those
    /// by which it is used.
    pub(super) fn take_keys(&mut self, ctx: &Context) {
        self.settings.size = crate::ui::display::by_keys(self.settings.size, ctx);
        if ctx.text_edit_focused() {
            return;
        }
        let focused = ctx.egui_wants_keyboard_input();
        let chords: Vec<Act> = ctx.input(|i| i.events.iter().filter_map(chord).collect());
        if !self.card_is_open() {
            chords.into_iter().for_each(|act| self.act(act, ctx));
        }
        let keys: Vec<Key> = ctx.input(|i| i.events.iter().filter_map(plain_press).collect());
        for key in keys.into_iter().filter(|key| !(focused && uses_widgets(*key))) {
            let Some(binding) = BINDINGS.iter().find(|b| b.key == key) else { continue };
            let traits = binding.act.traits();
            let framed = self.photo_is_open() && traits.frames_photo;
            if !self.card_is_open() || traits.over_cards || framed {
                self.act(binding.act.clone(), ctx);
            }
        }
    }
}

/// The key of a press without Ctrl, Alt or Shift, by the modifiers of the press itself: they may be up again before the
/// frame ends. With Shift, letters move the pan.
fn plain_press(event: &Event) -> Option<Key> {
    match event {
        Event::Key { key, pressed: true, modifiers, .. } if modifiers.is_none() => Some(*key),
        _ => None,
    }
}

/// The act of a press with Ctrl.
fn chord(event: &Event) -> Option<Act> {
    let Event::Key { key, pressed: true, modifiers, .. } = event else { return None };
    match (key, modifiers.command && !modifiers.alt, modifiers.shift) {
        (Key::Z, true, false) => Some(Act::Time(TimeAct::Undo)),
        (Key::Z, true, true) | (Key::Y, true, _) => Some(Act::Time(TimeAct::Redo)),
        _ => None,
    }
}

/// Keys by which a button is pressed and a slider moved.
fn uses_widgets(key: Key) -> bool {
    matches!(key, Key::Space | Key::Enter | Key::ArrowLeft | Key::ArrowRight | Key::ArrowUp | Key::ArrowDown)
}
