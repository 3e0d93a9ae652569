//! Fingers on a touch screen: once they are detected, every control is as high as a thumb is wide.

use egui::{Context, Id, Ui};

use crate::ui::theme::TOUCH;

/// Notes that fingers use the window: a finger was seen, or `is_coarse`: the system states that the main pointer is none of a mouse.
/// A machine with both keeps what fingers need.
pub fn note(ctx: &Context, is_coarse: bool) {
    if (is_coarse || ctx.input(|i| i.has_touch_screen())) && !are_used(ctx) {
        ctx.data_mut(|data| data.insert_temp(id(), true));
        ctx.all_styles_mut(|style| style.spacing.interact_size.y = TOUCH);
    }
}

/// Returns true if fingers use the window.
pub fn are_used(ctx: &Context) -> bool {
    ctx.data(|data| data.get_temp(id())).unwrap_or(false)
}

/// Returns the height of a control that has `usual` for a mouse [points].
pub fn height(ui: &Ui, usual: f32) -> f32 {
    if are_used(ui.ctx()) { usual.max(TOUCH) } else { usual }
}

fn id() -> Id {
    Id::unique("fingers")
}
