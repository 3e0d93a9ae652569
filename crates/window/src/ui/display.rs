//! The interface as it was set: its theme, its size, and whether what glides jumps.

use egui::gui_zoom::kb_shortcuts::{ZOOM_IN, ZOOM_IN_SECONDARY, ZOOM_OUT, ZOOM_RESET};
use egui::style::ScrollAnimation;
use egui::{Context, Style, ThemePreference, Vec2, vec2};
use saute_controls::settings::Settings;
use saute_controls::settings::interface_size::InterfaceSize;
use saute_controls::settings::theme::Theme;

use crate::ui::layout::TINY;

/// Room that the panels need at least [points] (chosen: a phone, on which two rows hold all views; a window of 1280 ×
/// 720 at 150 %).
const ROOM: Vec2 = vec2(390.0, 470.0);

/// Gives the interface the chosen theme and size.
pub(crate) fn display(settings: &Settings, ctx: &Context) {
    ctx.set_theme(match settings.theme {
        Theme::Dark => ThemePreference::Dark,
        Theme::Light => ThemePreference::Light,
        Theme::System => ThemePreference::System,
    });
    still_interface(ctx, moves_less(settings));
    let size = if settings.projector { InterfaceSize::Largest } else { settings.size };
    ctx.set_zoom_factor(fitting(size, ctx));
}

/// Lets the interface unfold, scroll and blink, or not.
fn still_interface(ctx: &egui::Context, still: bool) {
    if (ctx.global_style().animation_time == 0.0) != still {
        ctx.all_styles_mut(|style| {
            style.animation_time = if still { 0.0 } else { Style::default().animation_time };
            style.scroll_animation = if still { ScrollAnimation::none() } else { ScrollAnimation::default() };
            style.visuals.text_cursor.blink = !still;
        });
    }
}

/// Returns true if nothing glides that can jump: as chosen, else as the system wishes.
pub fn moves_less(settings: &Settings) -> bool {
    settings.less_motion.unwrap_or_else(crate::system::wants_less_motion)
}

/// The factor of a size, or the largest smaller one that leaves the panels room in the window [-].
fn fitting(size: InterfaceSize, ctx: &Context) -> f32 {
    let window = ctx.content_rect().size() * ctx.zoom_factor();
    // A wide window keeps its controls.
    let room = if window.x > window.y { vec2(TINY, ROOM.y) } else { ROOM };
    let most = (window / room).min_elem().max(1.0);
    size.factor().min(most)
}

/// The size after the keys that enlarge (Ctrl +) and shrink (Ctrl −) have been taken.
pub(crate) fn by_keys(size: InterfaceSize, ctx: &Context) -> InterfaceSize {
    let [larger, smaller, usual] = ctx.input_mut(|i| {
        let larger = i.consume_shortcut(&ZOOM_IN) || i.consume_shortcut(&ZOOM_IN_SECONDARY);
        [larger, i.consume_shortcut(&ZOOM_OUT), i.consume_shortcut(&ZOOM_RESET)]
    });
    match () {
        () if usual => InterfaceSize::Usual,
        () if larger => size.larger(),
        () if smaller => size.smaller(),
        () => size,
    }
}
