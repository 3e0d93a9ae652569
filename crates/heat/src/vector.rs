//! Vector operations of [`glam::DVec3`] on arrays, bit for bit the formulas of that type.

use glam::DVec3;

/// A point [m] or a direction [-].
pub type Vec3 = [f64; 3];

/// Returns a − b.
#[inline]
pub fn sub(a: Vec3, b: Vec3) -> Vec3 {
    (DVec3::from(a) - DVec3::from(b)).to_array()
}

/// Returns s a.
#[inline]
pub fn scale(a: Vec3, s: f64) -> Vec3 {
    (DVec3::from(a) * s).to_array()
}

/// Returns the scalar product.
#[inline]
pub fn dot(a: Vec3, b: Vec3) -> f64 {
    DVec3::from(a).dot(b.into())
}

/// Returns the vector product.
#[inline]
pub fn cross(a: Vec3, b: Vec3) -> Vec3 {
    DVec3::from(a).cross(b.into()).to_array()
}

/// Returns the distance of two points [m].
#[inline]
pub fn distance(a: Vec3, b: Vec3) -> f64 {
    DVec3::from(a).distance(b.into())
}

/// Returns the unit vector of a vector, zero for zero [-].
#[inline]
pub fn unit(a: Vec3) -> Vec3 {
    DVec3::from(a).normalize_or_zero().to_array()
}
