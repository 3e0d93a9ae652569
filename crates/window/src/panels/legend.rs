//! The legend of the present view.

use egui::{Align2, Color32, FontId, Painter, Rect, RichText, Sense, Stroke, Ui, pos2, vec2};
use saute_kitchen::food::Scale;
use saute_picture::colour::map::{ColourMap, Tone};

use crate::ui::{fingers, theme};
use saute_controls::act::{Act, Acts, ViewAct};
use saute_controls::context::PanelContext;
use saute_controls::spoken::view_words::ViewWords;
use saute_words::doneness_words;
use saute_words::language::Language;

/// Size of the bar with its marks at most [points].
const BAR: egui::Vec2 = vec2(300.0, 34.0);
/// Height of the bar alone, and room left free between two marks [points].
const BAR_HEIGHT: f32 = 14.0;
const BETWEEN_MARKS: f32 = 5.0;

/// Shows what the colours mean, at most `width` points wide: nothing for the natural look.
pub fn show(state: &PanelContext, ui: &mut Ui, acts: &mut Acts, width: f32) {
    let (view, scale) = (state.settings.view, state.scale());
    let Some(map) = view.colour_map(state.settings.map, scale.as_deref()) else { return };
    ui.spacing_mut().item_spacing.y = 4.0;
    match scale.filter(|_| map.stepped) {
        Some(scale) => classes(ui, &scale, state.settings.language, width),
        None => {
            ui.label(RichText::new(view.meaning(state.settings.speech())).size(12.5).color(theme::of(ui).quiet));
            bar(state, ui, acts, &map, width);
        }
    }
}

fn bar(state: &PanelContext, ui: &mut Ui, acts: &mut Acts, map: &ColourMap, width: f32) {
    let view = state.settings.view;
    let changes = view.is_of_temperature(state.scale().as_deref());
    let sense = if changes { Sense::click() } else { Sense::hover() };
    let height = if changes { fingers::height(ui, BAR.y) } else { BAR.y };
    let (rect, response) = ui.allocate_exact_size(vec2(BAR.x.min(width), height), sense);
    let l = state.settings.language;
    let (role, key) = if changes {
        (egui::accesskit::Role::Button, "legend.spoken_change")
    } else {
        (egui::accesskit::Role::Label, "legend.spoken")
    };
    let spoken = l.fill(key, &[("meaning", &view.meaning(state.settings.speech()))]);
    response.widget_info(|| egui::WidgetInfo::labeled(role, true, &spoken));
    paint_table(ui.painter(), Rect::from_min_size(rect.min, vec2(rect.width(), BAR_HEIGHT)), map);
    marks(state, ui, rect, map);
    if changes && response.on_hover_text(l.text("legend.change")).clicked() {
        acts.push(Act::View(ViewAct::Map));
    }
}

fn paint_table(painter: &Painter, bar: Rect, map: &ColourMap) {
    let columns = bar.width() as usize;
    for i in 0..columns {
        let value = map.from + (map.to - map.from) * i as f64 / columns as f64;
        let [r, g, b] = map.colour(value);
        let left = bar.left() + i as f32;
        let column = Rect::from_min_max(pos2(left, bar.top()), pos2(left + 1.5, bar.bottom()));
        painter.rect_filled(column, 0.0, Color32::from_rgb(r, g, b));
    }
}

/// A tick at every value worth a mark, a number where there is room for one.
fn marks(state: &PanelContext, ui: &Ui, rect: Rect, map: &ColourMap) {
    let (view, font) = (state.settings.view, FontId::proportional(11.5));
    let (painter, bottom) = (ui.painter(), rect.top() + BAR_HEIGHT);
    let mut free_from = f32::NEG_INFINITY;
    for &value in view.spec().marks.iter().filter(|v| (map.from..=map.to).contains(*v)) {
        let x = rect.left() + map.coordinate(value) * rect.width();
        painter.line_segment([pos2(x, bottom), pos2(x, bottom + 4.0)], Stroke::new(1.0, theme::of(ui).quiet));
        let text = painter.layout_no_wrap(view.mark(value, state.settings.speech()), font.clone(), theme::of(ui).text);
        // The first and the last number stay within the bar.
        let half = 0.5 * text.size().x;
        let left = (x - half).clamp(rect.left(), rect.right() - 2.0 * half);
        if left >= free_from {
            free_from = left + 2.0 * half + BETWEEN_MARKS;
            painter.galley(pos2(left, bottom + 4.0), text, theme::of(ui).text);
        }
    }
}

/// The classes of a scale with their patterns, under its label.
fn classes(ui: &mut Ui, scale: &Scale, l: Language, width: f32) {
    let label = l.fill("doneness.by_scale", &[("scale", &doneness_words::label(scale, l))]);
    let label = RichText::new(label).size(12.5).color(theme::of(ui).quiet);
    ui.label(label);
    ui.allocate_ui(vec2(width.min(2.0 * BAR.x), 0.0), |ui| {
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing = vec2(10.0, 4.0);
            for (place, class) in scale.class.iter().enumerate() {
                let name = doneness_words::class(scale, &class.name, l);
                let text = ui.painter().layout_no_wrap(name.to_owned(), FontId::proportional(13.0), theme::of(ui).text);
                let size = vec2(28.0 + text.size().x, 18.0);
                let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
                response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Label, true, name));
                let mark = Rect::from_min_size(rect.min, vec2(22.0, 18.0));
                super::doneness_bar::swatch(ui.painter(), mark, Tone::of(scale, place));
                let at = Align2::LEFT_CENTER.anchor_size(mark.right_center() + vec2(6.0, 0.0), text.size()).min;
                ui.painter().galley(at, text, theme::of(ui).text);
            }
        });
    });
}
