//! The pan as a surface: projection onto floor and wall, and its colliders.

use core::f64::consts::TAU;

use rapier3d::math::Vector;
use rapier3d::prelude::{ColliderBuilder, SharedShape};

use crate::pan::pan_description::PanDescription;

use super::pose::{Pose, about, rotation_between};
use super::scale;
use glam::{DQuat, DVec3};

/// Wedges of the wall [-] (chosen: they deviate from the cone by half a millimetre).
const WALL_PIECES: usize = 32;
/// Outward extent of the wall's wedges at their foot [m] (chosen: fast food cannot pass within one step).
const WALL_DEPTH: f64 = 0.02;

/// Steepest tilt of a held pan [rad] (chosen: about 60°, food falls out).
const STEEPEST: f64 = 1.0;

/// Floor and wall of a pan: a disc and a truncated cone, in the pan's frame; the origin is the centre of the floor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PanShape {
    /// Radius of the floor [m].
    pub floor: f64,
    /// Radius of the rim [m].
    pub rim: f64,
    /// Height of the rim above the floor [m].
    pub height: f64,
    /// Thickness of the floor, ridges included [m].
    pub thickness: f64,
}

/// Projection of a point onto the pan's surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OverPan {
    /// Signed distance from the surface; negative behind it [m].
    pub gap: f64,
    /// Unit normal of the surface, into the pan [-].
    pub normal: DVec3,
    /// Place on the pan's unrolled mesh [m].
    pub on_mesh: [f64; 2],
}

impl PanShape {
    /// The surface of a described pan.
    pub fn of(pan: &PanDescription) -> Self {
        let mm = |v: f64| 1e-3 * v;
        Self {
            floor: mm(pan.floor.radius_mm),
            rim: mm(pan.wall.rim_radius_mm),
            height: mm(pan.wall.height_mm),
            // Food lies on the tops of ridges.
            thickness: mm(pan.floor.thickness_mm + pan.ridges.as_ref().map_or(0.0, |r| r.height_mm)),
        }
    }

    /// Limits a pose: displacement and lift up to `farthest` [m], tilt up to `STEEPEST`, clear of the glass.
    pub fn within_reach(&self, wanted: &Pose, farthest: f64) -> Pose {
        let mut turn = rotation_between(DQuat::IDENTITY, wanted.rotation);
        turn.z = 0.0;
        let rotation = about(turn.clamp_length_max(STEEPEST));
        let at = wanted.position.truncate().clamp_length_max(farthest);
        let lift = wanted.position.z - self.thickness - self.raise(rotation);
        self.standing(at.to_array(), lift.clamp(0.0, farthest), rotation)
    }

    /// Length of the wall from floor to rim [m].
    fn slope(&self) -> f64 {
        libm::hypot(self.rim - self.floor, self.height)
    }

    /// Projects a point onto floor or wall; `None` beyond the rim.
    pub fn over(&self, p: DVec3) -> Option<OverPan> {
        let r = libm::hypot(p.x, p.y);
        if r <= self.floor {
            return Some(OverPan { gap: p.z, normal: DVec3::Z, on_mesh: [p.x, p.y] });
        }
        let length = self.slope();
        let (out, rise) = ((self.rim - self.floor) / length, self.height / length);
        let along = (r - self.floor) * out + p.z * rise;
        if along > length {
            return None;
        }
        let gap = p.z * out - (r - self.floor) * rise;
        let (x, y) = (p.x / r, p.y / r);
        let mesh = self.floor + along.max(0.0);
        Some(OverPan { gap, normal: DVec3::new(-x * rise, -y * rise, out), on_mesh: [x * mesh, y * mesh] })
    }

    /// Height of floor or wall at a distance from the axis [m]; beyond the rim its height.
    pub fn surface_height(&self, r: f64) -> f64 {
        self.height * ((r - self.floor) / (self.rim - self.floor)).clamp(0.0, 1.0)
    }

    /// Returns true if a point is over the pan: inside the rim and not below the floor.
    pub fn holds(&self, p: DVec3) -> bool {
        libm::hypot(p.x, p.y) < self.rim && p.z > -self.thickness - 0.01
    }

    /// Rise of a rotated pan so that the edge of its floor clears the glass [m].
    pub fn raise(&self, rotation: DQuat) -> f64 {
        let up = rotation * DVec3::Z;
        self.floor * libm::hypot(up.x, up.y)
    }

    /// Pose of a pan whose lowest edge is `lift` above the glass [m].
    pub fn standing(&self, at: [f64; 2], lift: f64, rotation: DQuat) -> Pose {
        let z = self.thickness + lift + self.raise(rotation);
        Pose { position: DVec3::new(at[0], at[1], z), rotation }
    }

    /// Collider of the floor: a half space, which stops bodies at any speed. Foods outside the pan do not collide with it.
    pub fn floor_collider(&self) -> ColliderBuilder {
        ColliderBuilder::new(SharedShape::halfspace(Vector::Z))
    }

    /// Colliders of the wall: wedges, steep inside, sloping down outside.
    pub fn wall_colliders(&self) -> impl Iterator<Item = ColliderBuilder> + '_ {
        (0..WALL_PIECES).filter_map(|i| {
            let angle = |k: usize| TAU * k as f64 / WALL_PIECES as f64;
            let mut points = Vec::new();
            for k in [i, i + 1] {
                let (sin, cos) = libm::sincos(angle(k));
                let corners = [
                    (self.floor, 0.0),
                    (self.rim, self.height),
                    (self.rim + WALL_DEPTH, 0.0),
                    (self.floor, -self.thickness),
                ];
                points.extend(corners.map(|(r, z)| scale::vector(DVec3::new(r * cos, r * sin, z))));
            }
            ColliderBuilder::convex_hull(&points)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAN: PanShape = PanShape { floor: 0.1, rim: 0.13, height: 0.04, thickness: 0.002 };

    #[test]
    fn gaps_are_distances_from_floor_and_wall() {
        let over = PAN.over(DVec3::new(0.03, 0.04, 0.007)).expect("over the floor");
        assert_eq!((over.gap, over.on_mesh), (0.007, [0.03, 0.04]));
        // Half way up the wall (3-4-5), 5 mm in front of it.
        let p = DVec3::new(0.115 - 0.8 * 0.005, 0.0, 0.02 + 0.6 * 0.005);
        let over = PAN.over(p).expect("over the wall");
        assert!((over.gap - 0.005).abs() < 1e-12 && (over.on_mesh[0] - 0.125).abs() < 1e-12, "{over:?}");
        assert!((over.normal - DVec3::new(-0.8, 0.0, 0.6)).length() < 1e-12);
        assert!(PAN.over(DVec3::new(0.15, 0.0, 0.05)).is_none());
    }

    #[test]
    fn the_wall_closes_the_pan() {
        assert_eq!(PAN.wall_colliders().count(), WALL_PIECES);
        assert!((PAN.surface_height(0.115) - 0.02).abs() < 1e-12);
    }
}
