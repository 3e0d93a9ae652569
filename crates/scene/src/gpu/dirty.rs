//! Dirty rectangles: the part of the picture that moving things can touch. Only that part is restored and redrawn.

use glam::{Mat4, Vec2, Vec3, Vec4Swizzles};

use crate::gpu::foods::world_positions;
use crate::input::{SceneInput, SpotLook};
use crate::mesh::steam::PuffVertex;

/// Nearer than this to the eye a point may cover any pixel [m].
const NEAR: f32 = 0.05;
/// Room for a pixel's edge and for the outline of round shapes between their points [pixels].
const MARGIN: f32 = 4.0;

/// A rectangle of pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct DirtyRect {
    low: Vec2,
    high: Vec2,
}

impl DirtyRect {
    /// Everything.
    pub const WHOLE: Self = Self { low: Vec2::NEG_INFINITY, high: Vec2::INFINITY };
    const NOTHING: Self = Self { low: Vec2::INFINITY, high: Vec2::NEG_INFINITY };

    /// What the pan's floor, the foods and the tool of a scene cover.
    pub fn of_lively(input: &SceneInput, tool: &[Vec3], size: [u32; 2]) -> Self {
        let mut rect = Self::NOTHING;
        let eye = Eye::new(input, size);
        let mut cover = |point: Vec3, radius: f32| rect = rect.union(eye.covered(point, radius));
        let (pan, world_from_pan) = (&input.pan, input.pan.world_from_pan());
        for step in 0..24 {
            let around = Vec2::from_angle(std::f32::consts::TAU * step as f32 / 24.0);
            let floor = (around * pan.floor_radius * 1.01).extend(pan.thickness);
            cover(world_from_pan.transform_point3(floor), 0.0);
        }
        tool.iter().for_each(|point| cover(*point, 0.0));
        let foods = input.foods.iter().map(|food| eye.covered_by(world_positions(food)));
        foods.fold(rect, Self::union)
    }

    /// What spots of oil cover.
    pub fn of_spots(input: &SceneInput, spots: &[SpotLook], size: [u32; 2]) -> Self {
        let eye = Eye::new(input, size);
        let cover = |spot: &SpotLook| eye.covered(spot.position, spot.radius);
        spots.iter().map(cover).fold(Self::NOTHING, Self::union)
    }

    /// What the steam of a scene covers.
    pub fn of_sprites(input: &SceneInput, puffs: &[PuffVertex], size: [u32; 2]) -> Self {
        let eye = Eye::new(input, size);
        let cover = |puff: &PuffVertex| eye.covered(Vec3::from(puff.position), 1.7 * puff.half_size);
        puffs.iter().map(cover).fold(Self::NOTHING, Self::union)
    }

    pub fn union(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// Left, top, width, height within a picture.
    pub fn scissor(self, size: [u32; 2]) -> [u32; 4] {
        let limit = Vec2::new(size[0] as f32, size[1] as f32);
        let low = (self.low - MARGIN).floor().clamp(Vec2::ZERO, limit);
        let high = (self.high + MARGIN).ceil().clamp(low, limit);
        [low.x, low.y, high.x - low.x, high.y - low.y].map(|v| v as u32)
    }
}

/// Accumulates where on the picture something is.
struct Eye {
    clip_from_world: Mat4,
    size: Vec2,
    /// Pixels a metre covers at a distance of one metre.
    scale: f32,
}

impl Eye {
    fn new(input: &SceneInput, size: [u32; 2]) -> Self {
        let size = Vec2::new(size[0] as f32, size[1] as f32);
        let clip_from_world = input.view_projection(size.x / size.y);
        Self { clip_from_world, size, scale: 0.5 * size.y * clip_from_world.row(1).truncate().length() }
    }

    /// Pixels that a body with these corners covers; none where it is beyond an edge of the picture.
    fn covered_by(&self, corners: impl Iterator<Item = Vec3>) -> DirtyRect {
        let (mut rect, mut beyond) = (DirtyRect::NOTHING, u8::MAX);
        for corner in corners {
            rect = rect.union(self.covered(corner, 0.0));
            beyond &= self.edges_before(corner);
        }
        if beyond == 0 { rect } else { DirtyRect::NOTHING }
    }

    /// The edges of the picture beyond which a point is, a bit for each, and one for the plane of the eye.
    fn edges_before(&self, point: Vec3) -> u8 {
        let clip = self.clip_from_world * point.extend(1.0);
        let inside = [clip.w + clip.x, clip.w - clip.x, clip.w + clip.y, clip.w - clip.y, clip.w];
        inside.iter().enumerate().map(|(edge, inside)| u8::from(*inside < 0.0) << edge).sum()
    }

    /// Pixels that a sphere covers, y downwards.
    fn covered(&self, point: Vec3, radius: f32) -> DirtyRect {
        let clip = self.clip_from_world * point.extend(1.0);
        if clip.w - radius < NEAR {
            return DirtyRect::WHOLE;
        }
        let centre = (clip.xy() / clip.w * Vec2::new(0.5, -0.5) + 0.5) * self.size;
        let reach = Vec2::splat(radius * self.scale / (clip.w - radius));
        DirtyRect { low: centre - reach, high: centre + reach }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::{Doneness, empty_pan, steak_in_pan};

    #[test]
    fn the_rectangle_holds_every_food_vertex() {
        let scene = steak_in_pan(Doneness::Raw);
        let size = [960, 540];
        let [left, top, width, height] = DirtyRect::of_lively(&scene, &[], size).scissor(size);
        for point in scene.foods.iter().flat_map(world_positions) {
            let ndc = scene.camera.project(point, 960.0 / 540.0).expect("in front of the eye");
            let x = (ndc[0] * 0.5 + 0.5) * 960.0;
            let y = (0.5 - ndc[1] * 0.5) * 540.0;
            assert!(x >= left as f32 && x <= (left + width) as f32, "{x}");
            assert!(y >= top as f32 && y <= (top + height) as f32, "{y}");
        }
    }

    #[test]
    fn a_food_out_of_sight_is_not_drawn_over_the_picture() {
        let rect = |x: f32, y: f32| {
            let mut scene = steak_in_pan(Doneness::Raw);
            (scene.foods[0].world_from_rest.w_axis.x, scene.foods[0].world_from_rest.w_axis.y) = (x, y);
            DirtyRect::of_lively(&scene, &[], [960, 540])
        };
        let pan = DirtyRect::of_lively(&empty_pan(), &[], [960, 540]);
        for [x, y] in [[5.0, 0.0], [-5.0, 1.0], [0.0, -9.0], [3.0, -9.0]] {
            assert_eq!(rect(x, y), pan, "{x} {y}");
        }
        assert_ne!(rect(0.3, 0.0), pan);
    }

    #[test]
    fn an_empty_pan_leaves_most_of_the_picture_alone() {
        let [.., width, height] = DirtyRect::of_lively(&empty_pan(), &[], [960, 540]).scissor([960, 540]);
        assert!(width * height < 960 * 540 / 2 && width * height > 10_000);
    }

    #[test]
    fn the_whole_is_the_whole() {
        assert_eq!(DirtyRect::WHOLE.scissor([7, 5]), [0, 0, 7, 5]);
    }
}
