//! How a piece lies on another mesh, or on its other face, where no rigid body moves.

use core::f64::consts::PI;

use glam::{DQuat, DVec3};

use crate::dynamics::{PanShape, Pose};
use crate::piece::piece_state::Piece;

impl Piece {
    /// Height of its lowest patch over the surface of the pan, which has the pose `pan` [m]; none outside the pan.
    pub(super) fn lowest_over(&self, surface: &PanShape, pan: &Pose) -> Option<f64> {
        let seen = self.pose.seen_from(pan);
        let over = |p: &saute_food::PatchPose| surface.over(seen.to_world(DVec3::from_array(p.position)));
        self.patch_poses().iter().filter_map(over).map(|over| over.gap).min_by(f64::total_cmp)
    }

    /// Moves it along the pan's axis so that its lowest patch is at a height over the surface [m].
    pub(super) fn lower_to(&mut self, height: f64, surface: &PanShape, pan: &Pose) {
        if let Some(lowest) = self.lowest_over(surface, pan) {
            self.pose.position += pan.rotation * DVec3::Z * (height - lowest);
        }
    }

    /// Updates its geometry when due. In the pan its lowest patch stays as high over the surface: it sinks as it grows thinner.
    pub(super) fn follow_shape_down(&mut self, surface: &PanShape, pan: &Pose) {
        let sinks = self.in_pan() && self.shape.is_due(&self.state);
        let height = if sinks { self.lowest_over(surface, pan) } else { None };
        self.follow_shape();
        if let Some(height) = height {
            self.lower_to(height, surface, pan);
        }
    }

    /// Turns it over about its long axis and lays it level on its other face.
    pub(super) fn turn_over(&mut self, surface: &PanShape, pan: &Pose) {
        let long = self.pose.rotation * DVec3::X;
        let flat = DVec3::new(long.x, long.y, 0.0);
        let axis = if flat.length() > 0.2 { flat.normalize() } else { DVec3::X };
        self.pose = self.pose.turned(axis, PI);
        self.drape();
        self.level(pan);
        self.lower_to(0.0, surface, pan);
    }

    /// Turns it so that the mean plane of its lower face is parallel to the pan's floor.
    fn level(&mut self, pan: &Pose) {
        let seen = self.pose.seen_from(pan);
        let below: Vec<usize> = self.model.patches_below(seen.up()).collect();
        let places = below
            .iter()
            .map(|&i| (seen.to_world(DVec3::from_array(self.patch_poses()[i].position)), self.model.patches()[i].area));
        if let Some(normal) = plane(&places.collect::<Vec<_>>()) {
            self.pose.rotation =
                (pan.rotation * DQuat::from_rotation_arc(normal, DVec3::Z) * seen.rotation).normalize();
        }
    }
}

/// Upward unit normal of the plane through places with weights, by least squares of their heights; none if they are in a
/// line.
fn plane(places: &[(DVec3, f64)]) -> Option<DVec3> {
    let whole: f64 = places.iter().map(|(_, weight)| weight).sum();
    let middle = places.iter().fold(DVec3::ZERO, |sum, (p, weight)| sum + *p * *weight) / whole;
    let [mut xx, mut xy, mut yy, mut xz, mut yz] = [0.0; 5];
    for (p, weight) in places {
        let d = *p - middle;
        xx += weight * d.x * d.x;
        xy += weight * d.x * d.y;
        yy += weight * d.y * d.y;
        xz += weight * d.x * d.z;
        yz += weight * d.y * d.z;
    }
    let determinant = xx * yy - xy * xy;
    (determinant > 1e-9 * xx * yy).then(|| {
        let [slope_x, slope_y] = [yy * xz - xy * yz, xx * yz - xy * xz].map(|v| v / determinant);
        DVec3::new(-slope_x, -slope_y, 1.0).normalize()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_plane_through_a_slope_has_its_normal_and_a_line_has_none() {
        let at = |x: f64, y: f64| (DVec3::new(x, y, 0.3 + 0.1 * x - 0.2 * y), 1.0 + x);
        let normal = plane(&[at(0.0, 0.0), at(1.0, 0.0), at(0.0, 1.0), at(1.0, 2.0)]).expect("a plane");
        assert!((normal - DVec3::new(-0.1, 0.2, 1.0).normalize()).length() < 1e-12);
        assert!(plane(&[at(0.0, 0.0), at(1.0, 1.0), at(2.0, 2.0)]).is_none());
    }
}
