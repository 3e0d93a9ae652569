//! Where the shadow map of the window or the lamp and the contact map look from.

use glam::{Mat4, Vec2, Vec3, Vec4};

use crate::input::SceneInput;
use crate::quality::Quality;

/// Texels along each side of the contact map.
pub(crate) const CONTACT_SIZE: u32 = 256;

/// Half of the extent that casts shadows, seen from the light [m], and its height over its width (chosen: hob and board).
const REACH: f32 = 0.56;
const LOW: f32 = 0.82;
/// Half of the extent of the shadow map's fine part [m] (chosen: a pan with its rim).
pub(crate) const FINE_REACH: f32 = 0.19;
/// The fine part follows what it shows in steps [m] (chosen: shadows do not crawl while a pan slides).
const STEP: f32 = 0.01;
/// How soft shadows are [m] (chosen: a window seen from a few centimetres).
const SOFTNESS: f32 = 0.00125;

/// Where the two parts of the shadow map look: the left half fine, at the food, the right one coarse, at everything.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ShadowView {
    /// Unit vector towards the light.
    towards: Vec3,
    /// How much softer than usual shadows are.
    soft: f32,
    /// Middle of the fine part in the clip space of the coarse one.
    middle: Vec2,
}

impl ShadowView {
    /// The fine part looks at the pan, or at the foods where none is near the pan.
    pub fn of(input: &SceneInput) -> Self {
        let places: Vec<Vec3> = input.foods.iter().map(|food| food.world_from_rest.w_axis.truncate()).collect();
        let pan = input.pan.position;
        let in_pan = |place: &Vec3| place.distance(pan) < FINE_REACH;
        let elsewhere = !places.is_empty() && !places.iter().any(in_pan);
        let at = if elsewhere { places.iter().sum::<Vec3>() / places.len() as f32 } else { pan };
        let step = STEP / Vec2::new(REACH, REACH * LOW);
        let towards = input.towards_light();
        let middle = coarse(towards).project_point3(at).truncate();
        let soft = input.sample.map_or(1.0, |sample| sample.softness());
        Self { towards, soft, middle: (middle / step).round() * step }
    }

    /// Maps the world to the clip space of the coarse part.
    pub fn coarse(&self) -> Mat4 {
        coarse(self.towards)
    }

    /// Maps the world to the clip space of the fine part.
    pub fn fine(&self) -> Mat4 {
        let scale = REACH / FINE_REACH;
        Mat4::from_scale(Vec3::new(scale, scale, 1.0))
            * Mat4::from_translation(-self.middle.extend(0.0))
            * self.coarse()
    }

    /// Middle of the fine part, scale to it from the coarse one, and sample step as a share of the coarse part.
    pub fn uniform(&self, quality: Quality) -> Vec4 {
        // Soft shadows are wider where a texel is.
        let texel = 2.0 * FINE_REACH / quality.map_sizes()[0] as f32;
        let step = (self.soft * SOFTNESS).max(1.2 * texel) / (2.0 * REACH);
        self.middle.extend(REACH / FINE_REACH).extend(step)
    }
}

fn coarse(towards: Vec3) -> Mat4 {
    let centre = Vec3::new(0.02, 0.0, 0.02);
    let eye = centre + towards;
    let view = glam::camera::rh::view::look_at_mat4(eye, centre, Vec3::Z);
    let up = REACH * LOW;
    glam::camera::rh::proj::directx::orthographic(-REACH, REACH, -up, up, 0.3, 1.7) * view
}

/// A view of the food from below: the height of its underside over a rectangle of the counter.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ContactMap {
    low: Vec3,
    extent: Vec3,
}

impl Default for ContactMap {
    fn default() -> Self {
        Self { low: Vec3::new(-0.50, -0.25, -0.02), extent: Vec3::new(1.0, 0.5, 0.2) }
    }
}

impl ContactMap {
    /// Maps the world to clip space; depth grows with height.
    pub fn clip_from_world(&self) -> Mat4 {
        // Rows of the picture grow with y, so the y of clip space falls.
        let scale = Vec3::new(2.0 / self.extent.x, -2.0 / self.extent.y, 1.0 / self.extent.z);
        let shift = Vec3::new(-1.0, 1.0, 0.0) - self.low * scale;
        Mat4::from_translation(shift) * Mat4::from_scale(scale)
    }

    pub fn rect(&self) -> Vec4 {
        Vec4::new(self.low.x, self.low.y, 1.0 / self.extent.x, 1.0 / self.extent.y)
    }

    pub fn height(&self) -> Vec4 {
        Vec4::new(self.low.z, 1.0 / self.extent.z, 1.3 / CONTACT_SIZE as f32, 0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_contact_map_covers_its_rectangle() {
        let map = ContactMap::default();
        let low = map.clip_from_world().project_point3(map.low);
        let high = map.clip_from_world().project_point3(map.low + map.extent);
        assert!(low.abs_diff_eq(Vec3::new(-1.0, 1.0, 0.0), 1e-5), "{low}");
        assert!(high.abs_diff_eq(Vec3::new(1.0, -1.0, 1.0), 1e-5), "{high}");
    }
}
