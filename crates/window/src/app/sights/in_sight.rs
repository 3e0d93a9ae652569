//! After a jump, to another cook or another time, the eye finds the food again: it is never left behind a panel or out of the picture.

use egui::Rect;
use glam::Vec3;
use saute_kitchen::Piece;
use saute_picture::stage::{Places, half_length};
use saute_scene::camera::Camera;

use crate::app::SauteApp;
use crate::ui::layout::Pane;
use crate::ui::scene_view::on_screen;
use saute_controls::eye::{EyeView, Glance};

/// Distance of what matters from the edges of the free part [points] (chosen: it does not touch a panel).
const CLEAR: f32 = 8.0;
/// Steps by which the eye goes back until pan and food are seen [-], and shares of the way from the pan to the food at which it looks
/// [-] (chosen).
const BACK: [f32; 7] = [1.0, 1.1, 1.2, 1.3, 1.45, 1.6, 1.8];
const ASIDE: [f32; 4] = [0.0, 0.2, 0.4, 0.6];

impl SauteApp {
    /// Sends the eye to where it sees the food, if it does not since time or the cook was changed.
    pub(super) fn keep_in_sight(&mut self) {
        self.come_back();
        let now = self.session.generation;
        let is_known = self.sights.looked_for == Some(now) && !self.sights.looks_again;
        if is_known || self.session.is_travelling() || self.shows_ways() {
            return;
        }
        let Some(pane) = self.sights.scene.pane else { return };
        self.sights.looks_again = false;
        let is_first = self.sights.looked_for.replace(now).is_none();
        if self.sees_food(&self.eye(), &pane, &self.food_points()) {
            return;
        }
        let to = self.working_view(&pane);
        // At the start nothing was seen before.
        let progress = if is_first { 1.0 } else { 0.0 };
        self.sights.stands_back = true;
        self.sights.glance = Some(Glance { from: self.sights.camera.clone(), to, progress });
    }

    /// Once the food is in the pan, the eye that went aside for it comes back to the pan.
    fn come_back(&mut self) {
        if self.sights.stands_back && self.session.shown_piece().is_some_and(Piece::in_pan) {
            self.look_from(EyeView::Front);
        }
    }

    /// The working view, from as far back and as far aside as it takes to see pan and food; the food alone where there is no such view.
    fn working_view(&self, pane: &Pane) -> Camera {
        let (base, food) = (Camera::three_quarter(), self.food_points());
        let mut points = self.pan_points();
        points.extend(&food);
        let middle = food.iter().sum::<Vec3>() / food.len().max(1) as f32;
        let views = BACK.into_iter().flat_map(|back| ASIDE.map(|aside| (back, aside)));
        let view = |(back, aside): (f32, f32)| {
            let to_food = Vec3::new(middle.x - base.target.x, middle.y - base.target.y, 0.0);
            let target = base.target + to_food * aside;
            Camera { distance: base.distance * back, target, shift: pane.lens_shift(), ..base.clone() }
        };
        let sees = |camera: &Camera| self.sees_food(camera, pane, &points);
        views.map(view).find(sees).unwrap_or_else(|| self.near_food())
    }

    fn sees_food(&self, camera: &Camera, pane: &Pane, points: &[Vec3]) -> bool {
        let free: Rect = pane.free.shrink(CLEAR);
        let aspect = pane.rect.width() / pane.rect.height();
        let is_seen =
            |point: &Vec3| camera.project(*point, aspect).is_some_and(|ndc| free.contains(on_screen(ndc, pane.rect)));
        points.iter().all(is_seen)
    }

    /// Middle and outline of the food that the panels show [m].
    fn food_points(&self) -> Vec<Vec3> {
        let Some(piece) = self.session.shown_piece() else { return Vec::new() };
        let middle = Places::default().piece(&self.session.kitchen, piece).position;
        around(middle, 0.8 * half_length(piece) as f32)
    }

    /// The floor of the pan [m].
    fn pan_points(&self) -> Vec<Vec3> {
        let radius = 1e-3 * self.session.kitchen.pan_model().description.floor.radius_mm as f32;
        around(Vec3::ZERO, radius)
    }
}

fn around(middle: Vec3, radius: f32) -> Vec<Vec3> {
    let to = |x: f32, y: f32| middle + Vec3::new(x * radius, y * radius, 0.0);
    vec![to(-1.0, 0.0), to(1.0, 0.0), to(0.0, -1.0), to(0.0, 1.0)]
}
