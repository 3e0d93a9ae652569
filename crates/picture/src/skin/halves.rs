//! A piece that a knife has halved, opened like a book: its halves turn towards the cook about the far end of the cut.

use glam::{Mat4, Vec3};
use saute_kitchen::Piece;
use saute_scene::input::{FoodLook, SliceLook};

/// How far each half turns [rad] (chosen: both cut faces are seen from the cook's side).
const OPENS: f32 = 0.62;
/// Gap between the halves at the far end [m] (chosen).
const GAP: f32 = 0.006;

/// The two halves of a look; `cut` is the plane between them, its hidden side along its normal.
pub(crate) fn opened(piece: &Piece, look: FoodLook, cut: SliceLook) -> [FoodLook; 2] {
    let normal = look.world_from_rest.transform_vector3(cut.normal).with_z(0.0).normalize_or(Vec3::X);
    let across = Vec3::new(-normal.y, normal.x, 0.0);
    // The hinge is away from the cook, who is at −y.
    let away = if across.y >= 0.0 { 1.0 } else { -1.0 };
    let half_width = 0.5 * piece.model.size()[0].min(piece.model.size()[1]) as f32;
    let hinge = look.world_from_rest.transform_point3(cut.point) + across * (away * half_width);
    let turned = |side: f32| {
        let turn = Mat4::from_rotation_z(side * away * -OPENS);
        let shift = Mat4::from_translation(normal * (-side * 0.5 * GAP));
        shift * Mat4::from_translation(hinge) * turn * Mat4::from_translation(-hinge) * look.world_from_rest
    };
    let (near, far) = (turned(1.0), turned(-1.0));
    let other = mirrored(&cut);
    let half = |world_from_rest, slice| FoodLook { world_from_rest, slice: Some(slice), ..look.clone() };
    [half(near, SliceLook { ghost: false, ..cut }), half(far, other)]
}

/// The same cut seen from its other side.
pub(crate) fn mirrored(cut: &SliceLook) -> SliceLook {
    let vertices = cut.vertices.iter().map(|v| {
        let normal = (-Vec3::from(v.normal)).to_array();
        saute_scene::input::FoodVertex { normal, ..*v }
    });
    SliceLook {
        point: cut.point,
        normal: -cut.normal,
        vertices: vertices.collect(),
        triangles: cut.triangles.iter().map(|[a, b, c]| [*a, *c, *b]).collect(),
        ghost: false,
    }
}
