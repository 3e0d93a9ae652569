//! The eye on its way to what matters: food that was taken out, a cut face, a chosen view.

use crate::app::SauteApp;
use glam::Vec3;
use saute_controls::eye::{EyeView, Glance};
use saute_kitchen::{Piece, Place};
use saute_picture::stage::{Places, following, nearness};
use saute_scene::camera::Camera;

/// Time that the eye takes [s] (chosen: seen as a movement, over before it is waited for).
const GLANCE_S: f32 = 0.7;

/// Direction of the eye to food on the board [rad]: from the cook's side, half above (chosen: upper side and cut face are
/// seen).
const OVER_BOARD: [f32; 2] = [0.10, 0.80];

/// Distance of the eye from a steak on the board, and from its cut face [m] (chosen: the steak fills half of what no panel
/// covers).
const TO_FOOD: f32 = 0.40;

const TO_CUT: f32 = 0.34;

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
        (self.sights.glance, self.sights.stands_back) = (None, false);
    }

    /// Moves the eye through `wall` seconds; food that a button took out is looked at as soon as it lies on the board and
    /// nothing else fries.
    pub(crate) fn move_eye(&mut self, wall: f32) {
        self.keep_in_sight();
        let lies = |piece: &Piece| matches!(piece.place, Place::Rest(_));
        let arrived = self.sights.taken_out.as_ref().and_then(|id| self.session.kitchen.piece(id)).is_some_and(lies);
        if arrived {
            self.sights.taken_out = None;
            if !self.session.kitchen.pieces().iter().any(Piece::in_pan) {
                self.glance_at(self.food_view(TO_FOOD));
            }
        }
        let Some(glance) = &mut self.sights.glance else { return };
        glance.progress += if crate::ui::display::moves_less(&self.settings) { 1.0 } else { wall / GLANCE_S };
        self.sights.camera = glance.at();
        if glance.progress >= 1.0 {
            self.sights.glance = None;
        }
    }

    fn glance_at(&mut self, to: Camera) {
        (self.sights.camera_preset, self.sights.stands_back) = (0, false);
        self.sights.glance = Some(Glance { from: self.sights.camera.clone(), to, progress: 0.0 });
    }

    /// The food alone, near.
    pub(super) fn near_food(&self) -> Camera {
        self.food_view(TO_FOOD)
    }

    fn food_view(&self, distance: f32) -> Camera {
        let Some(piece) = self.session.shown_piece() else { return Camera::close_up() };
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
