//! The stacked bar of raw, rare, medium and well-done: colour, pattern, words and numbers.

use egui::{Color32, Painter, Rect, Sense, Stroke, Ui, pos2, vec2};
use saute_kitchen::food::{Class, Shares};

use crate::colour_map::class_colour;
use crate::settings::Settings;
use crate::theme;

/// Names of the classes.
pub const NAMES: [&str; 4] = ["raw", "rare", "medium", "well done"];

/// Bounds of the classes in the chosen unit.
fn bounds(settings: &Settings) -> [String; 4] {
    let [a, b, c] = [50.0, 60.0, 70.0].map(|bound| settings.degrees(bound));
    let unit = settings.unit();
    [format!("< {a:.0} {unit}"), format!("{a:.0}–{b:.0}"), format!("{b:.0}–{c:.0}"), format!("> {c:.0} {unit}")]
}

/// Shows the shares of a section.
pub fn show(ui: &mut Ui, settings: &Settings, shares: &Shares) {
    let bounds = bounds(settings);
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), 26.0), Sense::hover());
    let spoken: Vec<String> = NAMES.iter().zip(shares.0).map(|(n, s)| format!("{n} {s:.0} %")).collect();
    response.widget_info(|| {
        egui::WidgetInfo::labeled(egui::accesskit::Role::Label, true, format!("Cross-section: {}", spoken.join(", ")))
    });
    let mut left = rect.left();
    for (class, share) in Class::ALL.into_iter().zip(shares.0) {
        let width = rect.width() * share as f32 / 100.0;
        if width > 0.0 {
            swatch(ui.painter(), Rect::from_min_size(pos2(left, rect.top()), vec2(width, rect.height())), class);
        }
        left += width;
    }
    let caption = "cut through the centre, by highest temperature so far";
    ui.label(egui::RichText::new(caption).size(11.0).color(theme::QUIET));
    ui.columns(4, |columns| {
        for (i, ui) in columns.iter_mut().enumerate() {
            ui.spacing_mut().item_spacing.y = 1.0;
            let (mark, _) = ui.allocate_exact_size(vec2(18.0, 10.0), Sense::hover());
            swatch(ui.painter(), mark, Class::ALL[i]);
            ui.label(egui::RichText::new(format!("{:.0} %", shares.0[i])).size(16.0).strong());
            ui.label(egui::RichText::new(NAMES[i]).size(12.5));
            ui.label(egui::RichText::new(&bounds[i]).size(11.0).color(theme::QUIET));
        }
    });
}

/// A patch in a class's colour and pattern, so that nothing is told by hue alone.
pub fn swatch(painter: &Painter, rect: Rect, class: Class) {
    let [r, g, b] = class_colour(class);
    let painter = painter.with_clip_rect(rect.intersect(painter.clip_rect()));
    painter.rect_filled(rect, 2.0, Color32::from_rgb(r, g, b));
    let ink = Stroke::new(1.2, Color32::from_black_alpha(90));
    let run = rect.width() + rect.height();
    let lines = |slope: f32, gap: f32| {
        let mut x = rect.left() - rect.height();
        while x < rect.left() + run {
            let (low, high) = if slope > 0.0 { (x, x + rect.height()) } else { (x + rect.height(), x) };
            painter.line_segment([pos2(low, rect.bottom()), pos2(high, rect.top())], ink);
            x += gap;
        }
    };
    match class {
        Class::Raw => {}
        Class::Rare => dots(&painter, rect),
        Class::Medium => lines(1.0, 8.0),
        Class::WellDone => {
            lines(1.0, 7.0);
            lines(-1.0, 7.0);
        }
    }
}

fn dots(painter: &Painter, rect: Rect) {
    let mut y = rect.top() + 4.0;
    let mut row = 0;
    while y < rect.bottom() {
        let mut x = rect.left() + if row % 2 == 0 { 4.0 } else { 8.0 };
        while x < rect.right() {
            painter.circle_filled(pos2(x, y), 1.3, Color32::from_black_alpha(100));
            x += 8.0;
        }
        y += 6.0;
        row += 1;
    }
}
