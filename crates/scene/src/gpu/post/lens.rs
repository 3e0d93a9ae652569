//! The uniform block of the passes after the scene.

use glam::{Vec3, Vec4};

use crate::camera::{FAR, NEAR};
use crate::gpu::foods::world_positions;
use crate::input::SceneInput;

/// Share of the light of glints that the lens scatters (chosen: seen around the window's image, not elsewhere).
const BLOOM: f32 = 0.045;
/// Share of light that the corners lose (chosen: not noticed as such).
const VIGNETTE: f32 = 0.10;
/// Width of the aperture [m] (chosen: a long lens wide open, stopped down until all of a pan is sharp).
const APERTURE: f32 = 0.013;
/// Depth behind the food that is still sharp [m] (chosen: half a pan).
const SHARP_BEHIND: f32 = 0.10;

/// Mirrors `Lens` in `post/lens.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
pub(crate) struct LensUniform {
    part: Vec4,
    whole: Vec4,
    projection: Vec4,
    depth: Vec4,
}

impl LensUniform {
    /// The lens of the best level: sharp up to the farthest food.
    pub fn new(input: &SceneInput, size: [u32; 2]) -> Self {
        Self::sharp_until(input, size, sharp_until(input))
    }

    /// The lens of the other levels, whose picture of what does not move is kept while foods move: sharp up to behind what
    /// the eye looks at.
    pub fn on_target(input: &SceneInput, size: [u32; 2]) -> Self {
        Self::sharp_until(input, size, input.camera.distance + 2.0 * SHARP_BEHIND)
    }

    /// A buffer for it.
    pub fn buffer(device: &wgpu::Device) -> wgpu::Buffer {
        device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("lens"),
            size: size_of::<Self>() as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        })
    }

    fn sharp_until(input: &SceneInput, size: [u32; 2], sharp_until: f32) -> Self {
        let [width, height] = size.map(|side| side as f32);
        let (whole, origin) = input.tile.map_or((size, [0; 2]), |tile| (tile.whole, tile.origin));
        let projection = input.projection(width / height);
        let shift = -projection.z_axis;
        Self {
            part: Vec4::new(width, height, origin[0] as f32, origin[1] as f32),
            whole: Vec4::new(whole[0] as f32, whole[1] as f32, BLOOM, VIGNETTE),
            projection: Vec4::new(projection.x_axis.x, projection.y_axis.y, shift.x, shift.y),
            depth: Vec4::new(NEAR, FAR, sharp_until, APERTURE * input.photo.aperture),
        }
    }
}

/// Distance along the axis of the eye that is sharp [m]: the middle of the foods that are looked at, or what is looked at.
pub(crate) fn sharp_distance(input: &SceneInput) -> f32 {
    let (eye, forward) = (input.camera.eye(), input.camera.forward());
    let away = |point: Vec3| (point - eye).dot(forward);
    let foods: Vec<f32> = input.foods.iter().flat_map(world_positions).map(away).collect();
    let nearest = foods.iter().copied().fold(f32::INFINITY, f32::min);
    let farthest = foods.iter().copied().fold(0.0, f32::max);
    // The nearer half is what the eye goes to.
    if farthest > 0.0 { nearest + 0.4 * (farthest - nearest) } else { input.camera.distance }
}

/// Distance along the axis of the eye up to which the picture is sharp [m]: the farthest food, or the pan.
fn sharp_until(input: &SceneInput) -> f32 {
    let (eye, forward) = (input.camera.eye(), input.camera.forward());
    let away = |point: Vec3| (point - eye).dot(forward);
    let foods = input.foods.iter().flat_map(world_positions).map(away).fold(0.0, f32::max);
    if foods > 0.0 { foods + SHARP_BEHIND } else { away(input.pan.position) + 2.0 * SHARP_BEHIND }
}
