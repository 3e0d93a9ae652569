//! What the eye takes for unmoved.

use glam::{Mat4, Vec3};

use crate::input::FoodVertex;

/// A piece of which no point has moved by more than this looks the same [m] (chosen: a seventh of a pixel).
const TOLERANCE: f32 = 1e-4;
/// No point of a food is further from its origin than this [m] (chosen: half a large steak's diagonal).
const LEVER: f32 = 0.15;

/// True when two poses put no point of a food further apart than the eye sees.
pub(crate) fn stays(a: &Mat4, b: &Mat4) -> bool {
    let turned = [a.x_axis - b.x_axis, a.y_axis - b.y_axis, a.z_axis - b.z_axis];
    let turn = turned.iter().map(|axis| axis.length_squared()).sum::<f32>().sqrt();
    (a.w_axis - b.w_axis).length() + turn * LEVER < TOLERANCE
}

/// True when no point of a shape is further from where it was than the eye sees.
pub(crate) fn same_shape(a: &[FoodVertex], b: &[FoodVertex]) -> bool {
    let near = |a: &FoodVertex, b: &FoodVertex| Vec3::from(a.position).abs_diff_eq(b.position.into(), TOLERANCE);
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| near(a, b))
}
