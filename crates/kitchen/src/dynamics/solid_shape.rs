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
        // The solver's cylinders are along y.
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

/// Largest number of triangles whose convexity is looked at [-] (chosen: the look costs less than the decomposition).
const MOST_LOOKED_AT: usize = 2000;
/// Farthest that a corner of a convex surface may protrude from a face, over the size of the surface [-] (chosen: a few
/// times the rounding of single precision).
const FLAT: f32 = 1e-5;

/// Returns true if a closed surface has no corner in front of any of its faces.
fn is_convex(points: &[Vector], triangles: &[[u32; 3]]) -> bool {
    let size = points.iter().map(|p| p.length()).fold(0.0, f32::max);
    let behind = |[a, b, c]: [Vector; 3]| {
        let normal = (b - a).cross(c - a).normalize_or_zero();
        points.iter().all(|p| (*p - a).dot(normal) <= FLAT * size)
    };
    triangles.len() <= MOST_LOOKED_AT && triangles.iter().all(|t| behind(t.map(|i| points[i as usize])))
}

/// Convex decomposition of a closed surface; its convex hull if it is convex, or if that fails.
fn convex_parts(points: &[Vector], triangles: &[[u32; 3]]) -> Vec<SharedShape> {
    if is_convex(points, triangles)
        && let Some(hull) = SharedShape::convex_hull(points)
    {
        return vec![hull];
    }
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
