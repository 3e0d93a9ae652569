//! A bell: it swings while something is due, and is still where nothing is to move.

use egui::{Color32, Pos2, Rect, Stroke, Ui, vec2};

use crate::ui::theme;

/// Swings, and how far it turns [Hz, rad] (chosen).
const SWINGS_HZ: f64 = 2.5;
const SWING: f32 = 0.35;
/// Size for which its outline is given [points].
const DRAWN: f32 = 28.0;

/// A bell.
#[derive(Clone, Copy, Debug)]
pub struct Bell<'a> {
    /// Its size [points].
    pub size: f32,
    /// Its text for those who do not see it.
    pub spoken: &'a str,
    /// True while it rings.
    pub rings: bool,
    /// False where nothing is to move.
    pub moves: bool,
}

/// Shows it.
pub fn show(ui: &mut Ui, bell: &Bell) {
    let Bell { size, spoken, rings, moves } = *bell;
    let (rect, response) = ui.allocate_exact_size(vec2(size, size), egui::Sense::hover());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Image, true, spoken));
    let palette = theme::of(ui);
    let ink = if rings { palette.accent } else { palette.quiet };
    let swings = rings && moves;
    let angle = if swings {
        ui.ctx().request_repaint();
        SWING * (std::f64::consts::TAU * SWINGS_HZ * ui.input(|i| i.time)).sin() as f32
    } else {
        0.0
    };
    paint(ui, rect, ink, angle);
    response.on_hover_text(spoken);
}

fn paint(ui: &Ui, rect: Rect, ink: Color32, angle: f32) {
    let scale = rect.width() / DRAWN;
    let top = rect.center_top() + vec2(0.0, 3.0 * scale);
    let turned = |x: f32, y: f32| top + scale * (egui::emath::Rot2::from_angle(angle) * vec2(x, y));
    let side = [(2.0, 1.0), (6.0, 5.0), (7.0, 13.0), (10.0, 18.0)];
    let right = side.iter().map(|(x, y)| turned(*x, *y));
    let left = side.iter().rev().map(|(x, y)| turned(-*x, *y));
    let outline: Vec<Pos2> = right.chain(left).collect();
    ui.painter().add(egui::Shape::convex_polygon(outline, ink, Stroke::NONE));
    ui.painter().circle_filled(turned(0.0, 20.5), 2.8 * scale, ink);
}
