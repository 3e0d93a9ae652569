//! Between the kitchen's metres and the rigid-body solver's centimetres.
//!
//! The solver works in 32-bit numbers, and its collision routines hold absolute tolerances of about a thousandth of a
//! unit: with centimetres, foods are a few units large and those tolerances hundredths of a millimetre. Masses are in
//! grams, so that densities stay near 1; forces are in g·cm/s².

use glam::{DQuat, DVec3};
use rapier3d::math::{Pose as SolverPose, Rotation, Vector};

use super::pose::Pose;

/// Solver units a metre.
pub const PER_METRE: f64 = 100.0;
/// Solver units of mass a kilogram.
pub const PER_KILOGRAM: f64 = 1000.0;

/// A length or a point, in solver units.
pub fn vector(v: DVec3) -> Vector {
    let v = v * PER_METRE;
    Vector::new(v.x as f32, v.y as f32, v.z as f32)
}

/// A point of the solver [m].
pub fn metres(v: Vector) -> DVec3 {
    DVec3::new(f64::from(v.x), f64::from(v.y), f64::from(v.z)) / PER_METRE
}

/// An axis or turning speed, which has no length in it.
pub fn plain(v: DVec3) -> Vector {
    Vector::new(v.x as f32, v.y as f32, v.z as f32)
}

/// A pose in solver units.
pub fn solver_pose(pose: &Pose) -> SolverPose {
    let q = pose.rotation;
    let rotation = Rotation::from_xyzw(q.x as f32, q.y as f32, q.z as f32, q.w as f32).normalize();
    SolverPose::from_parts(vector(pose.position), rotation)
}

/// A pose of the solver.
pub fn pose(of: &SolverPose) -> Pose {
    let q = of.rotation;
    let rotation = DQuat::from_xyzw(f64::from(q.x), f64::from(q.y), f64::from(q.z), f64::from(q.w)).normalize();
    Pose { position: metres(of.translation), rotation }
}

/// A force [N], in solver units.
pub fn force(newtons: DVec3) -> Vector {
    plain(newtons * (PER_METRE * PER_KILOGRAM))
}

/// A torque [N·m], in solver units.
pub fn torque(newton_metres: DVec3) -> Vector {
    plain(newton_metres * (PER_METRE * PER_METRE * PER_KILOGRAM))
}
