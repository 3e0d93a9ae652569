//! How far a solid reaches in a direction.

use glam::DVec3;
use saute_food::Solid;

/// How far a solid reaches from its origin along a unit direction of its own frame [m].
pub fn reach(solid: &Solid, along: DVec3) -> f64 {
    let farthest = |points: &mut dyn Iterator<Item = DVec3>| points.map(|p| p.dot(along)).fold(f64::NEG_INFINITY, f64::max);
    match solid {
        Solid::Cylinder { radius, half_height } => {
            radius * libm::hypot(along.x, along.y) + half_height * along.z.abs()
        }
        Solid::Cuboid { half } => DVec3::from_array(*half).dot(along.abs()),
        Solid::Capsules(capsules) => capsules
            .iter()
            .flat_map(|c| c.ends.map(|e| DVec3::from_array(e).dot(along) + c.radius))
            .fold(f64::NEG_INFINITY, f64::max),
        Solid::Hulls(hulls) => farthest(&mut hulls.iter().flatten().map(|p| DVec3::from_array(*p))),
    }
}

/// Radius of the circle about the origin that a solid covers, seen along z [m].
pub fn radius(solid: &Solid) -> f64 {
    let far = |p: &[f64; 3]| libm::hypot(p[0], p[1]);
    match solid {
        Solid::Cylinder { radius, .. } => *radius,
        Solid::Cuboid { half } => far(half),
        Solid::Capsules(capsules) => {
            capsules.iter().flat_map(|c| c.ends.map(|e| far(&e) + c.radius)).fold(0.0, f64::max)
        }
        Solid::Hulls(hulls) => hulls.iter().flatten().map(far).fold(0.0, f64::max),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use saute_food::Capsule;

    #[test]
    fn solids_reach_as_far_as_their_surfaces() {
        let diagonal = DVec3::new(0.6, 0.0, 0.8);
        assert!((reach(&Solid::Cylinder { radius: 0.02, half_height: 0.005 }, diagonal) - 0.016).abs() < 1e-15);
        assert!((reach(&Solid::Cuboid { half: [0.02, 1.0, 0.01] }, -diagonal) - 0.02).abs() < 1e-15);
        let rod = Capsule { ends: [[-0.03, 0.0, 0.0], [0.03, 0.0, 0.01]], radius: 0.005 };
        assert!((reach(&Solid::Capsules(vec![rod]), diagonal) - 0.031).abs() < 1e-15);
        assert!((radius(&Solid::Capsules(vec![rod])) - 0.035).abs() < 1e-15);
    }
}
