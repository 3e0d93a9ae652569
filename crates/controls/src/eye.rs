//! The eye on its way to what matters: food that was taken out, a cut face, a chosen view.

use saute_scene::camera::Camera;

/// A view that a button chooses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EyeView {
    /// The working view, to which the eye is reset.
    Front,
    /// From straight above.
    Above,
    /// Near the food that the panels show.
    Food,
}

impl EyeView {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Front, Self::Above, Self::Food];
}

/// A way of the eye.
#[derive(Clone, Debug)]
pub struct Glance {
    /// Where it begins.
    pub from: Camera,
    /// Where it ends.
    pub to: Camera,
    /// Share of it that is done; above 1 it has ended [-].
    pub progress: f32,
}

impl Glance {
    /// Returns the eye at the present progress.
    pub fn at(&self) -> Camera {
        let t = self.progress.min(1.0);
        let s = t * t * (3.0 - 2.0 * t);
        let mix = |a: f32, b: f32| a + s * (b - a);
        Camera {
            yaw: self.from.yaw + s * shorter_turn(self.to.yaw - self.from.yaw),
            pitch: mix(self.from.pitch, self.to.pitch),
            distance: mix(self.from.distance, self.to.distance),
            target: self.from.target.lerp(self.to.target, s),
            ..self.to.clone()
        }
    }
}

/// The same turn by at most half a circle [rad].
fn shorter_turn(by: f32) -> f32 {
    use std::f32::consts::{PI, TAU};
    (by + PI).rem_euclid(TAU) - PI
}
