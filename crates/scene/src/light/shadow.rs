//! Where the shadow map of the window and the contact map look from.

use glam::{Mat4, Vec3, Vec4};

use crate::light::environment::WINDOW_DIRECTION;

/// Texels along each side of the contact map.
pub(crate) const CONTACT_SIZE: u32 = 256;

/// Half of the extent that casts shadows, seen from the window [m].
const REACH: f32 = 0.56;

/// Maps the world to the clip space of the window's shadow map.
pub(crate) fn light_from_world() -> Mat4 {
    let centre = Vec3::new(0.02, 0.0, 0.02);
    let eye = centre + WINDOW_DIRECTION.normalize() * 1.0;
    let view = glam::camera::rh::view::look_at_mat4(eye, centre, Vec3::Z);
    let up = REACH * 0.82;
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
