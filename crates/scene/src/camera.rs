//! The eye: an orbit camera over the hob.

use std::f32::consts::{FRAC_PI_2, TAU};

use glam::{Mat4, Vec2, Vec3, Vec4Swizzles};

/// Field of view of the window [rad].
pub const FIELD_OF_VIEW: f32 = 35.0 * std::f32::consts::PI / 180.0;

/// Nearest and farthest distance that is drawn, along the axis of the eye [m].
pub(crate) const NEAR: f32 = 0.04;
pub(crate) const FAR: f32 = 6.0;
/// Lowest look: the counter still fills the lower half and the eye stays above the glass (chosen).
pub const PITCH_MIN: f32 = 0.21;
const PITCH_MAX: f32 = FRAC_PI_2;
/// Nearest eye [m].
pub const DISTANCE_MIN: f32 = 0.14;
/// Farthest eye [m].
pub const DISTANCE_MAX: f32 = 1.5;
/// How far from the middle the eye may go towards the wall behind the hob [m] (chosen: a hand's breadth before the plaster,
/// which is at 0.6 m).
pub const WALL_FROM: f32 = 0.52;

/// An eye that circles a target.
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    /// Angle around the vertical [rad]; 0 looks from the cook's side, positive moves the eye to the right.
    pub yaw: f32,
    /// Angle above the horizontal [rad].
    pub pitch: f32,
    /// Distance from the target [m].
    pub distance: f32,
    /// Point looked at [m].
    pub target: Vec3,
    /// Lens shift in normalised device coordinates: where the target appears, so that the pan can be centred in the
    /// part of the window that no panel covers.
    pub shift: [f32; 2],
    /// Field of view along the shorter side of a portrait picture, else along its height [rad].
    pub field_of_view: f32,
}

impl Default for Camera {
    fn default() -> Self {
        Self::three_quarter()
    }
}

impl Camera {
    /// From the cook's side, half above: the working view.
    pub fn three_quarter() -> Self {
        Self::looking(0.10, 49.0, 0.60, Vec3::new(0.062, -0.006, 0.018))
    }

    /// From straight above, as in a mirror over the hob.
    pub fn above() -> Self {
        Self::looking(0.0, 89.9, 0.56, Vec3::new(0.0, -0.01, 0.02))
    }

    /// Near the food, for a cut.
    pub fn close_up() -> Self {
        Self::looking(0.12, 36.0, 0.22, Vec3::new(0.0, 0.0, 0.018))
    }

    fn looking(yaw: f32, pitch_degrees: f32, distance: f32, target: Vec3) -> Self {
        Self { yaw, pitch: pitch_degrees.to_radians(), distance, target, shift: [0.0; 2], field_of_view: FIELD_OF_VIEW }
    }

    /// From a direction [rad] and a distance [m], within the limits.
    pub fn from_direction([yaw, pitch]: [f32; 2], distance: f32, target: Vec3) -> Self {
        let mut camera = Self { distance: 1.0, pitch: 0.0, yaw: 0.0, target, ..Self::three_quarter() };
        camera.orbit(yaw, pitch);
        camera.zoom(distance);
        camera
    }

    /// Turns the eye around the target by angles [rad], within the limits.
    pub fn orbit(&mut self, dx: f32, dy: f32) {
        self.yaw = (self.yaw + dx).rem_euclid(TAU);
        self.pitch = (self.pitch + dy).clamp(PITCH_MIN, PITCH_MAX);
    }

    /// Multiplies the distance, within the limits.
    pub fn zoom(&mut self, factor: f32) {
        self.distance = (self.distance * factor).clamp(DISTANCE_MIN, DISTANCE_MAX);
    }

    /// Position of the eye [m].
    pub fn eye(&self) -> Vec3 {
        self.target - self.forward() * self.distance
    }

    /// The camera with its eye in the room: nearer to its target where it would look from behind the wall.
    pub fn in_room(mut self) -> Self {
        let beyond = self.eye().y - WALL_FROM;
        let back = -self.forward().y;
        if beyond > 0.0 && back > 0.0 {
            self.distance = (self.distance - beyond / back).max(DISTANCE_MIN);
        }
        self
    }

    /// Unit vector from the eye to the target.
    pub fn forward(&self) -> Vec3 {
        let (sin_yaw, cos_yaw) = self.yaw.sin_cos();
        let (sin_pitch, cos_pitch) = self.pitch.sin_cos();
        Vec3::new(-sin_yaw * cos_pitch, cos_yaw * cos_pitch, -sin_pitch)
    }

    /// Maps the world to clip space (depth 0–1) for a picture of the given width over height.
    pub fn view_projection(&self, aspect: f32) -> Mat4 {
        self.projection(aspect) * self.view()
    }

    /// Maps the world to the space of the eye (x right, y up, z towards the eye).
    pub(crate) fn view(&self) -> Mat4 {
        glam::camera::rh::view::look_at_mat4(self.eye(), self.target, self.up())
    }

    /// A step of the eye to its right and up [m].
    pub(crate) fn aside(&self, step: Vec2) -> Vec3 {
        self.forward().cross(self.up()) * step.x + self.up() * step.y
    }

    /// Maps the space of the eye (x right, y up, z towards the eye) to clip space.
    pub(crate) fn projection(&self, aspect: f32) -> Mat4 {
        let vertical_fov =
            if aspect < 1.0 { 2.0 * ((0.5 * self.field_of_view).tan() / aspect).atan() } else { self.field_of_view };
        let shift = Mat4::from_translation(Vec3::new(self.shift[0], self.shift[1], 0.0));
        shift * glam::camera::rh::proj::directx::perspective(vertical_fov, aspect, NEAR, FAR)
    }

    /// The ray through a point of the picture, given in normalised device coordinates (y up): origin and unit
    /// direction.
    pub fn ray(&self, ndc: [f32; 2], aspect: f32) -> (Vec3, Vec3) {
        let world_from_clip = self.view_projection(aspect).inverse();
        let near = world_from_clip.project_point3(Vec3::new(ndc[0], ndc[1], 0.0));
        let far = world_from_clip.project_point3(Vec3::new(ndc[0], ndc[1], 1.0));
        (self.eye(), (far - near).normalize())
    }

    /// Where a point appears, in normalised device coordinates (y up); `None` behind the eye.
    pub fn project(&self, world: Vec3, aspect: f32) -> Option<[f32; 2]> {
        let clip = self.view_projection(aspect) * world.extend(1.0);
        (clip.w > NEAR).then(|| (clip.xy() / clip.w).to_array())
    }

    /// Perpendicular to `forward` even when looking straight down.
    fn up(&self) -> Vec3 {
        let (sin_yaw, cos_yaw) = self.yaw.sin_cos();
        let (sin_pitch, cos_pitch) = self.pitch.sin_cos();
        Vec3::new(-sin_yaw * sin_pitch, cos_yaw * sin_pitch, cos_pitch)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn presets() -> [Camera; 3] {
        [Camera::three_quarter(), Camera::above(), Camera::close_up()]
    }

    #[test]
    fn ray_through_a_projected_point_hits_the_point() {
        let point = Vec3::new(0.04, -0.02, 0.03);
        for mut camera in presets() {
            camera.shift = [0.2, -0.1];
            for aspect in [0.46, 1.0, 1.78] {
                let ndc = camera.project(point, aspect).expect("in front of the eye");
                let (origin, direction) = camera.ray(ndc, aspect);
                let nearest = origin + direction * (point - origin).dot(direction);
                assert!(nearest.distance(point) < 1e-4, "{camera:?} {aspect}: {nearest}");
            }
        }
    }

    #[test]
    fn the_target_appears_at_the_shift() {
        for mut camera in presets() {
            camera.shift = [0.25, 0.1];
            let ndc = camera.project(camera.target, 1.5).expect("in front of the eye");
            assert!((ndc[0] - 0.25).abs() < 1e-4 && (ndc[1] - 0.1).abs() < 1e-4, "{ndc:?}");
        }
    }

    #[test]
    fn screen_right_is_world_right_from_the_cooks_side() {
        let camera = Camera { yaw: 0.0, ..Camera::three_quarter() };
        let left = camera.project(Vec3::new(-0.1, 0.0, 0.0), 1.0).expect("visible");
        let right = camera.project(Vec3::new(0.1, 0.0, 0.0), 1.0).expect("visible");
        let back = camera.project(Vec3::new(0.0, 0.1, 0.0), 1.0).expect("visible");
        assert!(left[0] < 0.0 && right[0] > 0.0 && back[1] > left[1]);
    }

    #[test]
    fn orbit_and_zoom_stay_within_the_limits() {
        let mut camera = Camera::three_quarter();
        camera.orbit(100.0, -100.0);
        assert!(camera.eye().z > 0.0 && camera.yaw < TAU);
        camera.orbit(0.0, 100.0);
        assert!(camera.pitch <= PITCH_MAX);
        camera.zoom(1e-6);
        assert!(camera.distance >= DISTANCE_MIN);
        camera.zoom(1e9);
        assert!(camera.distance <= DISTANCE_MAX);
    }

    #[test]
    fn the_eye_stays_in_the_room() {
        for yaw in 0..64u8 {
            let mut camera = Camera::three_quarter();
            camera.orbit(0.1 * f32::from(yaw), -10.0);
            camera.zoom(10.0);
            let kept = camera.clone().in_room();
            assert!(kept.eye().y < WALL_FROM + 1e-4, "{}", kept.eye());
            assert!((kept.forward() - camera.forward()).length() < 1e-6, "it looks the same way");
        }
        assert_eq!(Camera::three_quarter().in_room(), Camera::three_quarter());
    }

    #[test]
    fn a_point_behind_the_eye_has_no_image() {
        let camera = Camera::three_quarter();
        assert_eq!(camera.project(camera.eye() - camera.forward(), 1.0), None);
    }
}
