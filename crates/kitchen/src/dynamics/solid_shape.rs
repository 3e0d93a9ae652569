//! Collision shapes of foods for the rigid-body solver.

use glam::DVec3;
use rapier3d::math::{Pose as SolverPose, Rotation, Vector};
use rapier3d::prelude::SharedShape;
use saute_food::Solid;

use super::scale;

/// Convex shapes of a solid with their poses in the body.
pub fn shapes(solid: &Solid) -> Vec<(SolverPose, SharedShape)> {
    let point = |p: &[f64; 3]| scale::vector(DVec3::from_array(*p));
    let length = |v: f64| (v * scale::PER_METRE) as f32;
    let here = SolverPose::IDENTITY;
    match solid {
        // The solver's cylinders stand along y.
        Solid::Cylinder { radius, half_height } => {
            let upright = SolverPose::from_rotation(Rotation::from_rotation_x(core::f32::consts::FRAC_PI_2));
            vec![(upright, SharedShape::cylinder(length(*half_height), length(*radius)))]
        }
        Solid::Cuboid { half } => vec![(here, SharedShape::cuboid(length(half[0]), length(half[1]), length(half[2])))],
        Solid::Capsules(capsules) => capsules
            .iter()
            .map(|c| (here, SharedShape::capsule(point(&c.ends[0]), point(&c.ends[1]), length(c.radius))))
            .collect(),
        Solid::Surface { points, triangles } => {
            let points: Vec<Vector> = points.iter().map(point).collect();
            convex_parts(&points, triangles).into_iter().map(|hull| (here, hull)).collect()
        }
        Solid::Hulls(hulls) => hulls
            .iter()
            .filter_map(|points| SharedShape::convex_hull(&points.iter().map(point).collect::<Vec<Vector>>()))
            .map(|hull| (here, hull))
            .collect(),
    }
}

/// Convex decomposition of a closed surface; its convex hull if that fails.
fn convex_parts(points: &[Vector], triangles: &[[u32; 3]]) -> Vec<SharedShape> {
    let whole = SharedShape::convex_decomposition(points, triangles);
    if let Some(compound) = whole.as_compound() {
        return compound.shapes().iter().map(|(_, shape)| shape.clone()).collect();
    }
    SharedShape::convex_hull(points).into_iter().collect()
}

/// Name of a collision shape for tables.
pub fn name(solid: &Solid) -> &'static str {
    match solid {
        Solid::Cylinder { .. } => "cylinder",
        Solid::Cuboid { .. } => "cuboid",
        Solid::Capsules(_) => "capsules",
        Solid::Surface { .. } => "convex decomposition",
        Solid::Hulls(_) => "convex hulls",
    }
}
