//! Which parts of the window shapes cover.

use egui::Rect;
use egui::epaint::{ClippedPrimitive, Primitive};

/// Rectangles that together cover all primitives [points]; none of them overlaps another.
pub(crate) fn covered(primitives: &[ClippedPrimitive]) -> Vec<Rect> {
    let mut rects: Vec<Rect> = Vec::new();
    for primitive in primitives {
        let bounds = match &primitive.primitive {
            Primitive::Mesh(mesh) => mesh.calc_bounds(),
            Primitive::Callback(callback) => callback.rect,
        };
        add(&mut rects, bounds.intersect(primitive.clip_rect));
    }
    rects
}

/// Adds a rectangle, merged with those that it overlaps.
fn add(rects: &mut Vec<Rect>, mut rect: Rect) {
    if !rect.is_positive() {
        return;
    }
    while let Some(place) = rects.iter().position(|other| other.intersects(rect)) {
        rect = rect.union(rects.swap_remove(place));
    }
    rects.push(rect);
}

#[cfg(test)]
mod tests {
    use egui::pos2;

    use super::*;

    fn rect(left: f32, right: f32) -> Rect {
        Rect::from_min_max(pos2(left, 0.0), pos2(right, 1.0))
    }

    #[test]
    fn overlapping_rectangles_become_one_and_others_stay_apart() {
        let mut rects = Vec::new();
        [rect(0.0, 1.0), rect(4.0, 5.0), rect(2.0, 3.0), rect(0.5, 2.5)].into_iter().for_each(|r| add(&mut rects, r));
        rects.sort_by(|a, b| a.min.x.total_cmp(&b.min.x));
        assert_eq!(rects, [rect(0.0, 3.0), rect(4.0, 5.0)]);
    }

    #[test]
    fn nothing_is_covered_by_what_is_clipped_away() {
        let mut rects = Vec::new();
        add(&mut rects, rect(0.0, 1.0).intersect(rect(2.0, 3.0)));
        assert!(rects.is_empty());
    }
}
