//! The eye on its way to what matters: food that was taken out, a cut face, a chosen view.

use glam::Vec3;
use saute_kitchen::{Piece, Place};
use saute_picture::stage::{Places, following, nearness};
use saute_scene::camera::Camera;

use crate::app::SauteApp;

/// Time that the eye takes [s] (chosen: seen as a movement, over before it is waited for).
const GLANCE_S: f32 = 0.7;
/// Direction of the eye to food on the board [rad]: from the cook's side, half above (chosen: upper side and cut face are
/// seen).
const OVER_BOARD: [f32; 2] = [0.10, 0.80];
/// Distance of the eye from a steak on the board, and from its cut face [m] (chosen: the steak fills half of what no panel
/// covers).
const TO_FOOD: f32 = 0.40;
const TO_CUT: f32 = 0.34;

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
pub(crate) struct Glance {
    from: Camera,
    to: Camera,
    progress: f32,
}

impl Glance {
    fn at(&self) -> Camera {
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

impl SauteApp {
    /// Sends the eye to a view.
    pub(crate) fn look_from(&mut self, view: EyeView) {
        let to = match view {
            EyeView::Front => Camera::three_quarter(),
            EyeView::Above => Camera::above(),
            EyeView::Food => self.food_view(TO_FOOD),
        };
        self.glance_at(to);
    }

    /// Turns the eye to the food that the panels show, as the knife has opened it.
    pub(crate) fn look_at_cut(&mut self) {
        self.glance_at(self.food_view(TO_CUT));
    }

    /// A hand on the eye ends its own way.
    pub(crate) fn take_eye(&mut self) {
        self.glance = None;
    }

    /// Moves the eye through `wall` seconds; food that a button took out is looked at as soon as it lies on the board and
    /// nothing else fries.
    pub(crate) fn move_eye(&mut self, wall: f32) {
        let lies = |piece: &Piece| matches!(piece.place, Place::Rest(_));
        let arrived = self.taken_out.as_ref().and_then(|id| self.session.kitchen.piece(id)).is_some_and(lies);
        if arrived {
            self.taken_out = None;
            if !self.session.kitchen.pieces().iter().any(Piece::in_pan) {
                self.glance_at(self.food_view(TO_FOOD));
            }
        }
        let Some(glance) = &mut self.glance else { return };
        glance.progress += if self.settings.moves_less() { 1.0 } else { wall / GLANCE_S };
        self.camera = glance.at();
        if glance.progress >= 1.0 {
            self.glance = None;
        }
    }

    fn glance_at(&mut self, to: Camera) {
        self.camera_preset = 0;
        self.glance = Some(Glance { from: self.camera.clone(), to, progress: 0.0 });
    }

    fn food_view(&self, distance: f32) -> Camera {
        let Some(piece) = self.session.steak() else { return Camera::close_up() };
        let [yaw, pitch] = OVER_BOARD;
        // Where it will lie, while the picture may still show it on its way.
        let target = Places::default().piece(&self.session.kitchen, piece).position - self.eye_follows();
        Camera { yaw, pitch, distance: distance * nearness(piece), target, ..Camera::three_quarter() }
    }

    /// How far the eye has followed the pan [m].
    fn eye_follows(&self) -> Vec3 {
        let still = Camera::three_quarter();
        following(&still, self.places().followed(&self.session.kitchen)).target - still.target
    }
}
