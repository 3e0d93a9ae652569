//! Oil that spatters: drops in the air as short streaks, and spots that lie where drops have landed.

use glam::Vec3;

use crate::input::{DropLook, SceneInput, SpotLook};
use crate::mesh::steam::{CORNERS, PuffVertex};

/// Drops in the air, at most.
pub(crate) const DROPS_MAX: usize = 64;
/// Spots, at most.
pub(crate) const SPOTS_MAX: usize = 600;
/// How long a drop is seen on its way [s] (chosen: a camera's 1/250 s, so that its path reads).
const SHUTTER: f32 = 0.004;
/// A drop is drawn no narrower than this [m] (chosen: half a pixel of a window over the pan).
const NARROWEST: f32 = 3.5e-4;
/// Marks a drop in the air for the shader: added to the random value.
const DROP_MARK: f32 = 1.0;

/// Sprites of the drops in the air.
pub(crate) fn drops(input: &SceneInput) -> Vec<PuffVertex> {
    let eye = input.camera.eye();
    input.spatter.drops.iter().take(DROPS_MAX).flat_map(|drop| streak(drop, eye)).collect()
}

fn streak(drop: &DropLook, eye: Vec3) -> [PuffVertex; 6] {
    let view = (eye - drop.position).normalize_or(Vec3::Z);
    let way = drop.velocity - view * drop.velocity.dot(view);
    let along = way.normalize_or(Vec3::Z.cross(view).normalize_or(Vec3::X));
    let across = view.cross(along);
    let half_width = drop.radius.max(NARROWEST);
    let half_length = half_width + 0.5 * SHUTTER * way.length();
    let share = (drop.radius / half_width).powi(2);
    CORNERS.map(|corner| {
        let offset = along * (corner[0] * half_length) + across * (corner[1] * half_width);
        let position = (drop.position + offset).to_array();
        PuffVertex { position, corner, half_size: 0.0, opacity: share, random: DROP_MARK }
    })
}

/// Sprites of the spots, flat on what they lie on.
pub(crate) fn spots(spots: &[SpotLook]) -> Vec<PuffVertex> {
    spots.iter().rev().take(SPOTS_MAX).flat_map(spot_sprite).collect()
}

fn spot_sprite(spot: &SpotLook) -> [PuffVertex; 6] {
    let (along, across) = spot.normal.any_orthonormal_pair();
    CORNERS.map(|corner| {
        let offset = (along * corner[0] + across * corner[1]) * spot.radius;
        let position = (spot.position + offset).to_array();
        PuffVertex { position, corner, half_size: 0.0, opacity: 1.0, random: 0.0 }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::empty_pan;

    #[test]
    fn every_drop_in_the_air_is_drawn_once_and_longer_the_faster_it_is() {
        let mut scene = empty_pan();
        let drop =
            |speed: f32| DropLook { position: Vec3::new(0.0, 0.0, 0.05), velocity: Vec3::X * speed, radius: 3e-4 };
        let length = |v: &[PuffVertex]| Vec3::from(v[0].position).distance(Vec3::from(v[1].position));
        for count in [0, 1, 5, 40] {
            scene.spatter.drops = vec![drop(1.0); count];
            assert_eq!(drops(&scene).len(), 6 * count);
        }
        scene.spatter.drops = vec![drop(0.0), drop(2.0)];
        let sprites = drops(&scene);
        assert!(length(&sprites[6..]) > 3.0 * length(&sprites[..6]));
    }

    #[test]
    fn a_spot_lies_flat_on_what_it_fell_on() {
        let normal = Vec3::new(-0.6, 0.0, 0.8);
        let spot = SpotLook { position: Vec3::new(0.11, 0.0, 0.03), normal, radius: 1e-3 };
        for vertex in spots(&[spot]) {
            let offset = Vec3::from(vertex.position) - spot.position;
            assert!(offset.dot(normal).abs() < 1e-7 && (offset.length() / 1e-3 - 1.414).abs() < 1e-2);
        }
    }
}
