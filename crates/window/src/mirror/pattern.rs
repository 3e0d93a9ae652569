//! The calibration's pattern on black: a cross and a number for each mark, and the sheet's outline and folds between.

use egui::{Color32, Painter, Pos2, Rect, Stroke, pos2};
use glam::DVec2;

use saute_mirror::rig::{MARKS, Rig};
use saute_mirror::warp::Warp;

/// Half a cross [points] (chosen: a centimetre on the table).
const ARM: f32 = 16.0;
/// Points along each line of the sheet (chosen: a bow shows).
const STEPS: u32 = 24;
/// Height of a number on the sheet, in halves of its depth, and where it is beside its mark (chosen: 7 mm).
const DIGIT: f64 = 0.07;

/// Strokes of the digits 1 to 9 in a box one wide and two high, from the upper left (the seven segments).
const SEGMENTS: [[[f64; 2]; 2]; 7] = [
    [[0.0, 0.0], [1.0, 0.0]],
    [[1.0, 0.0], [1.0, 1.0]],
    [[1.0, 1.0], [1.0, 2.0]],
    [[0.0, 2.0], [1.0, 2.0]],
    [[0.0, 1.0], [0.0, 2.0]],
    [[0.0, 0.0], [0.0, 1.0]],
    [[0.0, 1.0], [1.0, 1.0]],
];
/// Which segments each digit from 1 to 9 has.
const DIGITS: [&[usize]; MARKS] = [
    &[1, 2],
    &[0, 1, 6, 4, 3],
    &[0, 1, 6, 2, 3],
    &[5, 6, 1, 2],
    &[0, 5, 6, 2, 3],
    &[0, 5, 6, 4, 3, 2],
    &[0, 1, 2],
    &[0, 1, 2, 3, 4, 5, 6],
    &[0, 1, 2, 3, 5, 6],
];

/// What the pattern is drawn from.
pub struct Pattern<'a> {
    /// The rig whose sheet it is.
    pub rig: &'a Rig,
    /// As it is calibrated now.
    pub warp: &'a Warp,
    /// Where the marks are shown [pixels].
    pub pixels: [DVec2; MARKS],
    /// The mark that keys move.
    pub chosen: usize,
}

impl Pattern<'_> {
    /// Draws it over a rectangle, in which pixels are a given number to a point.
    pub fn paint(&self, painter: &Painter, rect: Rect, pixels_per_point: f32) {
        let at = |pixel: DVec2| rect.min + egui::vec2(pixel.x as f32, pixel.y as f32) / pixels_per_point;
        painter.rect_filled(rect, 0.0, Color32::BLACK);
        for [from, to] in LINES {
            let line = Stroke::new(1.0, Color32::from_gray(70));
            self.bowed(painter, &at, from, to, line);
        }
        for (mark, pixel) in self.pixels.iter().enumerate() {
            let colour = if mark == self.chosen { Color32::from_rgb(255, 190, 60) } else { Color32::WHITE };
            let stroke = Stroke::new(1.5, colour);
            let centre = at(*pixel);
            let arm = |x: f32, y: f32| [centre - egui::vec2(x, y), centre + egui::vec2(x, y)];
            painter.line_segment(arm(ARM, 0.0), stroke);
            painter.line_segment(arm(0.0, ARM), stroke);
            if mark == self.chosen {
                painter.circle_stroke(centre, 0.6 * ARM, stroke);
            }
            self.number(painter, &at, mark, stroke);
        }
    }

    /// A line of the sheet as the lens bows it.
    fn bowed(&self, painter: &Painter, at: &dyn Fn(DVec2) -> Pos2, from: [f64; 2], to: [f64; 2], stroke: Stroke) {
        let [from, to] = [from, to].map(DVec2::from_array);
        let along = (0..=STEPS).map(|k| from.lerp(to, f64::from(k) / f64::from(STEPS)));
        painter.line(along.filter_map(|place| self.shown(place)).map(at).collect(), stroke);
    }

    /// A mark's number, upright for the eye however the mirror turns it.
    fn number(&self, painter: &Painter, at: &dyn Fn(DVec2) -> Pos2, mark: usize, stroke: Stroke) {
        let size = self.rig.sheet.size;
        let wide = DIGIT * size.y / size.x;
        let places = self.rig.sheet.marks()[mark] - self.rig.sheet.middle;
        let mut corner = 2.0 * places.truncate() / size;
        // Towards the middle of the sheet, where there is room.
        corner.x += if corner.x > 0.5 { -2.0 * wide } else { wide };
        corner.y += if corner.y < -0.5 { 3.0 * DIGIT } else { -DIGIT };
        for segment in DIGITS[mark] {
            let ends = SEGMENTS[*segment].map(|[x, y]| corner + DVec2::new(x * wide, -y * DIGIT));
            if let [Some(a), Some(b)] = ends.map(|place| self.shown(place)) {
                painter.line_segment([at(a), at(b)], stroke);
            }
        }
    }

    /// The pixel that shows a point of the sheet, in halves of its sides.
    fn shown(&self, place: DVec2) -> Option<DVec2> {
        let seen = self.rig.seen(self.rig.eye, self.rig.sheet.point(place))?;
        Some(self.warp.pixel(seen))
    }
}

/// The sheet's outline and folds, in halves of its sides.
const LINES: [[[f64; 2]; 2]; 6] = [
    [[-1.0, 1.0], [1.0, 1.0]],
    [[1.0, 1.0], [1.0, -1.0]],
    [[1.0, -1.0], [-1.0, -1.0]],
    [[-1.0, -1.0], [-1.0, 1.0]],
    [[-1.0, 0.0], [1.0, 0.0]],
    [[0.0, -1.0], [0.0, 1.0]],
];

/// The mark nearest to a place, if one is near [points].
pub fn nearest(pixels: &[DVec2; MARKS], place: Pos2, rect: Rect, pixels_per_point: f32) -> Option<usize> {
    let away = |pixel: &DVec2| {
        let at = rect.min + egui::vec2(pixel.x as f32, pixel.y as f32) / pixels_per_point;
        at.distance(pos2(place.x, place.y))
    };
    let near = pixels.iter().enumerate().map(|(mark, pixel)| (mark, away(pixel)));
    near.filter(|(_, far)| *far < 2.5 * ARM).min_by(|a, b| a.1.total_cmp(&b.1)).map(|(mark, _)| mark)
}
