//! Extents of collision shapes: support function, radius and outline.

use glam::{DQuat, DVec3};
use saute_food::Solid;

/// Support function: reach of a solid from its origin along a unit direction in its own frame [m].
pub fn reach(solid: &Solid, along: DVec3) -> f64 {
    let farthest =
        |points: &mut dyn Iterator<Item = DVec3>| points.map(|p| p.dot(along)).fold(f64::NEG_INFINITY, f64::max);
    match solid {
        Solid::Cylinder { radius, half_height } => radius * libm::hypot(along.x, along.y) + half_height * along.z.abs(),
        Solid::Cuboid { half } => DVec3::from_array(*half).dot(along.abs()),
        Solid::Capsules(capsules) => capsules
            .iter()
            .flat_map(|c| c.ends.map(|e| DVec3::from_array(e).dot(along) + c.radius))
            .fold(f64::NEG_INFINITY, f64::max),
        Solid::Surface { points, .. } => farthest(&mut points.iter().map(|p| DVec3::from_array(*p))),
        Solid::Hulls(hulls) => farthest(&mut hulls.iter().flatten().map(|p| DVec3::from_array(*p))),
    }
}

/// Radius of the circle about the origin that encloses a solid, seen along z [m].
pub fn radius(solid: &Solid) -> f64 {
    let far = |p: &[f64; 3]| libm::hypot(p[0], p[1]);
    match solid {
        Solid::Cylinder { radius, .. } => *radius,
        Solid::Cuboid { half } => far(half),
        Solid::Capsules(capsules) => {
            capsules.iter().flat_map(|c| c.ends.map(|e| far(&e) + c.radius)).fold(0.0, f64::max)
        }
        Solid::Surface { points, .. } => points.iter().map(far).fold(0.0, f64::max),
        Solid::Hulls(hulls) => hulls.iter().flatten().map(far).fold(0.0, f64::max),
    }
}

/// Points whose convex hull is the outline of a rotated solid seen from above, about its origin [m].
pub fn outline(solid: &Solid, rotation: DQuat) -> Vec<[f64; 2]> {
    let seen = |p: DVec3| {
        let q = rotation * p;
        [q.x, q.y]
    };
    match solid {
        Solid::Cylinder { radius, half_height } => (0..ROUND)
            .flat_map(|k| {
                let (sin, cos) = libm::sincos(core::f64::consts::TAU * k as f64 / ROUND as f64);
                [-1.0, 1.0].map(|z| seen(DVec3::new(radius * cos, radius * sin, z * half_height)))
            })
            .collect(),
        Solid::Cuboid { half } => (0..8)
            .map(|k| {
                let sign = |bit: usize| if k >> bit & 1 == 0 { -1.0 } else { 1.0 };
                seen(DVec3::new(sign(0) * half[0], sign(1) * half[1], sign(2) * half[2]))
            })
            .collect(),
        Solid::Capsules(capsules) => capsules
            .iter()
            .flat_map(|c| {
                c.ends.into_iter().flat_map(move |end| {
                    let [x, y] = seen(DVec3::from_array(end));
                    (0..ROUND / 2).map(move |k| {
                        let (sin, cos) = libm::sincos(2.0 * core::f64::consts::TAU * k as f64 / ROUND as f64);
                        [x + c.radius * cos, y + c.radius * sin]
                    })
                })
            })
            .collect(),
        Solid::Surface { points, .. } => points.iter().map(|p| seen(DVec3::from_array(*p))).collect(),
        Solid::Hulls(hulls) => hulls.iter().flatten().map(|p| seen(DVec3::from_array(*p))).collect(),
    }
}

/// Points on a circle [-] (chosen: a polygon of 48 corners deviates by 0.2 %).
const ROUND: usize = 48;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solids_reach_as_far_as_their_surfaces() {
        let diagonal = DVec3::new(0.6, 0.0, 0.8);
        assert!((reach(&Solid::Cylinder { radius: 0.02, half_height: 0.005 }, diagonal) - 0.016).abs() < 1e-15);
        assert!((reach(&Solid::Cuboid { half: [0.02, 1.0, 0.01] }, -diagonal) - 0.02).abs() < 1e-15);
    }
}
