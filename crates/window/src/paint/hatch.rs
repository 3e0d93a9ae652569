//! Patterns of classes on the panels' swatches.

use egui::{Color32, Painter, Rect, Stroke, pos2};
use saute_picture::colour::hatch::{DOT, INK, LINE, PERIOD, Pattern};

/// Draws the ink of a pattern over a patch of a panel.
pub fn paint(pattern: Pattern, painter: &Painter, rect: Rect) {
    let painter = painter.with_clip_rect(rect.intersect(painter.clip_rect()));
    let ink = Color32::from_black_alpha((255.0 * INK) as u8);
    let stroke = Stroke::new(LINE as f32, ink);
    let period = PERIOD as f32;
    let slanted = |falls: bool| {
        let mut x = rect.left() - rect.height();
        while x < rect.right() {
            let (low, high) = if falls { (x + rect.height(), x) } else { (x, x + rect.height()) };
            painter.line_segment([pos2(low, rect.bottom()), pos2(high, rect.top())], stroke);
            x += period;
        }
    };
    match pattern {
        Pattern::Plain => {}
        Pattern::Dots => dots(&painter, rect, ink),
        Pattern::Levels => {
            let mut y = rect.top() + 3.0;
            while y < rect.bottom() {
                painter.line_segment([pos2(rect.left(), y), pos2(rect.right(), y)], stroke);
                y += 0.625 * period;
            }
        }
        Pattern::Diagonal => slanted(false),
        Pattern::Cross => {
            slanted(false);
            slanted(true);
        }
    }
}

fn dots(painter: &Painter, rect: Rect, ink: Color32) {
    let (period, mut y, mut odd) = (PERIOD as f32, rect.top() + 3.0, false);
    while y < rect.bottom() {
        let mut x = rect.left() + if odd { 0.9 * period } else { 0.4 * period };
        while x < rect.right() {
            painter.circle_filled(pos2(x, y), DOT as f32, ink);
            x += period;
        }
        y += 0.75 * period;
        odd = !odd;
    }
}
