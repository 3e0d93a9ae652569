//! Unit conversion between the kitchen (SI) and the rigid-body solver (centimetre, gram).
//!
//! The solver uses 32-bit floats, and its collision routines have absolute tolerances of about 0.001 units. In
//! centimetres foods measure a few units, and the tolerances are hundredths of a millimetre. Masses are in grams, which
//! keeps densities near 1; forces are in g·cm/s².

use glam::{DQuat, DVec3};
use rapier3d::math::{Pose as SolverPose, Rotation, Vector};

use super::pose::Pose;

/// Solver units per metre [1/m].
pub const PER_METRE: f64 = 100.0;
/// Solver units of mass per kilogram [1/kg].
pub const PER_KILOGRAM: f64 = 1000.0;

/// Converts a length or point to solver units.
pub fn vector(v: DVec3) -> Vector {
    let v = v * PER_METRE;
    Vector::new(v.x as f32, v.y as f32, v.z as f32)
}

/// Converts a point from solver units [m].
pub fn metres(v: Vector) -> DVec3 {
    DVec3::new(f64::from(v.x), f64::from(v.y), f64::from(v.z)) / PER_METRE
}

/// Converts a vector without length unit, such as an axis or angular velocity.
pub fn plain(v: DVec3) -> Vector {
    Vector::new(v.x as f32, v.y as f32, v.z as f32)
}

/// Converts a pose to solver units.
pub fn solver_pose(pose: &Pose) -> SolverPose {
    let q = pose.rotation;
    let rotation = Rotation::from_xyzw(q.x as f32, q.y as f32, q.z as f32, q.w as f32).normalize();
    SolverPose::from_parts(vector(pose.position), rotation)
}

/// Converts a pose from solver units.
pub fn pose(of: &SolverPose) -> Pose {
    let q = of.rotation;
    let rotation = DQuat::from_xyzw(f64::from(q.x), f64::from(q.y), f64::from(q.z), f64::from(q.w)).normalize();
    Pose { position: metres(of.translation), rotation }
}

/// Converts a force [N] to solver units.
pub fn force(newtons: DVec3) -> Vector {
    plain(newtons * (PER_METRE * PER_KILOGRAM))
}

/// Converts a torque [N·m] to solver units.
pub fn torque(newton_metres: DVec3) -> Vector {
    plain(newton_metres * (PER_METRE * PER_METRE * PER_KILOGRAM))
}
