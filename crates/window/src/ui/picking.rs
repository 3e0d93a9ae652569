//! Picking: what is under the pointer, with tolerance for small pieces and a thin rim.

use egui::{Pos2, Vec2};

/// How near to a piece a pointer grabs it [points] (chosen: half a finger).
pub const GRAB: f32 = 24.0;

/// How near to a piece a click or a hovering pointer means it [points] (chosen: an outline's width).
pub const TOUCH: f32 = 5.0;

pub(crate) fn cross(a: Pos2, b: Pos2, c: Pos2) -> f32 {
    (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)
}

/// Distance from a convex outline, 0 inside.
pub(crate) fn distance(outline: &[Pos2], at: Pos2) -> f32 {
    let edges = || (0..outline.len()).map(|i| (outline[i], outline[(i + 1) % outline.len()]));
    if outline.len() > 2 && edges().all(|(a, b)| cross(a, b, at) >= 0.0) {
        return 0.0;
    }
    edges().map(|(a, b)| to_segment(a, b, at)).fold(f32::INFINITY, f32::min)
}

pub(crate) fn to_segment(a: Pos2, b: Pos2, at: Pos2) -> f32 {
    let along: Vec2 = b - a;
    let share = if along.length_sq() > 0.0 { ((at - a).dot(along) / along.length_sq()).clamp(0.0, 1.0) } else { 0.0 };
    (a + along * share).distance(at)
}
