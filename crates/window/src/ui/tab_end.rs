//! The end of the Tab order: after the last control, or after Escape, Tab leaves the picture instead of beginning again.

use egui::{Context, Id, Key};

/// Where the focus is between the first and the last control.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct TabEnd {
    /// The control that had the focus at the end of the last frame.
    focused: Option<Id>,
    /// Tab went past the last control: egui gives the focus to the first one in the next frame.
    goes_round: bool,
    /// The end is reached.
    is_reached: bool,
}

impl TabEnd {
    /// Looks where the focus is, at the end of a frame.
    pub(crate) fn look(&mut self, ctx: &Context) {
        let before = std::mem::replace(&mut self.focused, ctx.memory(|memory| memory.focused()));
        if std::mem::take(&mut self.goes_round) {
            return self.stop_at_the_end(ctx);
        }
        let pressed = |key| ctx.input(|input| input.key_pressed(key) && !input.modifiers.any());
        if self.focused.is_some() {
            self.is_reached = false;
        } else if before.is_some() && pressed(Key::Tab) {
            self.goes_round = true;
            ctx.request_repaint();
        } else if before.is_some() && pressed(Key::Escape) {
            self.is_reached = true;
        }
    }

    /// Takes the focus from the first control, to which egui has just given it.
    fn stop_at_the_end(&mut self, ctx: &Context) {
        if let Some(first) = self.focused.take() {
            ctx.memory_mut(|memory| memory.surrender_focus(first));
        }
        self.is_reached = true;
    }

    /// Returns true if Tab, or Shift+Tab for `back`, leaves the picture now; whoever comes back begins at the first control.
    pub(crate) fn leaves(&mut self, back: bool) -> bool {
        self.focused.is_none() && !self.goes_round && (back || std::mem::take(&mut self.is_reached))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::{Event, Modifiers, RawInput};

    /// Two buttons, and what is pressed.
    fn frame(ctx: &Context, end: &mut TabEnd, key: Option<Key>) -> Option<Id> {
        let pressed =
            |key| Event::Key { key, physical_key: None, pressed: true, repeat: false, modifiers: Modifiers::NONE };
        let input = RawInput { events: key.map(pressed).into_iter().collect(), ..RawInput::default() };
        let _ = ctx.run_ui(input, |ui| {
            let _ = (ui.button("one"), ui.button("two"));
            end.look(ui.ctx());
        });
        ctx.memory(|memory| memory.focused())
    }

    #[test]
    fn tab_leaves_after_the_last_control_and_escape_lets_it_go_anywhere() {
        let (ctx, mut end) = (Context::default(), TabEnd::default());
        frame(&ctx, &mut end, None);
        assert!(end.leaves(true) && !end.leaves(false), "nothing has the keys yet");
        let first = frame(&ctx, &mut end, Some(Key::Tab));
        assert!(first.is_some() && !end.leaves(true) && !end.leaves(false));
        assert_ne!(frame(&ctx, &mut end, Some(Key::Tab)), first);
        frame(&ctx, &mut end, Some(Key::Tab));
        assert_eq!(frame(&ctx, &mut end, None), None, "it does not go round");
        assert!(end.leaves(false) && !end.leaves(false), "once: who comes back begins anew");
        assert_eq!(frame(&ctx, &mut end, Some(Key::Tab)), first);
        assert!(!end.leaves(false));
        assert_eq!(frame(&ctx, &mut end, Some(Key::Escape)), None);
        assert!(end.leaves(false));
    }
}
