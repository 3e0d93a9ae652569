//! The drawing of a loudspeaker.

use egui::{Color32, Painter, Pos2, Shape, Stroke, Vec2, vec2};

/// Angle between the middle and an end of a wave [rad].
const WAVE: f32 = 0.8;

/// A loudspeaker with two waves, or with a cross.
#[derive(Clone, Copy, Debug)]
pub struct Loudspeaker {
    /// Its colour.
    pub ink: Color32,
    /// Its size over that in the bar on top [-].
    pub scale: f32,
    /// True for waves.
    pub on: bool,
}

impl Loudspeaker {
    /// Draws it about a point.
    pub fn paint(self, painter: &Painter, middle: Pos2) {
        let Self { ink, scale, on } = self;
        let at = |x: f32, y: f32| middle + scale * vec2(x - 4.0, y);
        let cone = [(-6.0, -3.0), (-2.5, -3.0), (2.5, -7.5), (2.5, 7.5), (-2.5, 3.0), (-6.0, 3.0)];
        let points = cone.map(|(x, y)| at(x, y));
        // Two convex parts: the box, and the cone before it.
        painter.add(Shape::convex_polygon(vec![points[0], points[1], points[4], points[5]], ink, Stroke::NONE));
        painter.add(Shape::convex_polygon(points[1..5].to_vec(), ink, Stroke::NONE));
        let stroke = Stroke::new(1.8 * scale, ink);
        if !on {
            painter.line_segment([at(6.0, -4.0), at(13.0, 4.0)], stroke);
            painter.line_segment([at(6.0, 4.0), at(13.0, -4.0)], stroke);
            return;
        }
        for radius in [6.0, 10.5] {
            let along = |step: i32| Vec2::angled(WAVE * step as f32 / 4.0);
            let wave = (-4..=4).map(|step| at(1.5, 0.0) + scale * radius * along(step));
            painter.add(Shape::line(wave.collect(), stroke));
        }
    }
}
