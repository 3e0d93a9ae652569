//! What is heard, for those who do not hear it: a caption and a level, made from what the synthesiser gets.

use egui::accesskit::Role;
use egui::{Rect, RichText, Ui, WidgetInfo, vec2};
use saute_session::hearing::caption::{caption, meter};
use saute_sound::Snapshot;

use crate::ui::theme;
use saute_controls::context::PanelContext;

/// Size of the meter [points].
const METER: egui::Vec2 = vec2(84.0, 8.0);

/// Shows both in a line, where sound is allowed.
pub fn show(state: &PanelContext, heard: Option<&Snapshot>, ui: &mut Ui) {
    let Some(heard) = heard else { return };
    let (l, palette) = (state.settings.language, theme::of(ui));
    ui.horizontal(|ui| {
        ui.label(RichText::new(l.text("heard.title")).size(12.5).color(palette.quiet));
        level(ui, meter(heard), |percent| l.fill("heard.level", &[("percent", &percent)]));
        let words = caption(heard).words(heard.lid, l);
        ui.add(egui::Label::new(RichText::new(&words).size(13.0).strong()).truncate()).on_hover_text(&words);
    });
}

/// A bar that is as full as it is loud.
fn level(ui: &mut Ui, full: f32, spoken: impl Fn(String) -> String) {
    let (rect, response) = ui.allocate_exact_size(METER, egui::Sense::hover());
    let palette = theme::of(ui);
    ui.painter().rect_filled(rect, METER.y / 2.0, palette.sunken);
    let filled = Rect::from_min_size(rect.min, vec2(full * METER.x, METER.y));
    ui.painter().rect_filled(filled, METER.y / 2.0, palette.chosen);
    let spoken = spoken(format!("{:.0}", 100.0 * full));
    response.widget_info(|| WidgetInfo::labeled(Role::Meter, true, &spoken));
    response.on_hover_text(spoken);
}
