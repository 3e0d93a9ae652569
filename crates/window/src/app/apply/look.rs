//! Cut, split view, colour map and camera by acts.

use saute_kitchen::Place;
use saute_picture::View;
use saute_picture::colour::map::TemperatureMap;
use saute_picture::stage::{CUT_YAW, nearness};
use saute_scene::camera::Camera;

use crate::app::SauteApp;

/// Last place of the cut on either side, as a share of the half-length [-] (chosen: a slice remains).
const LAST_SLICE: f64 = 0.95;

impl SauteApp {
    /// Shows or hides the cut. In the pan its face points towards +x, so the camera moves to that side.
    pub(crate) fn toggle_slice(&mut self) {
        self.sights.slice = if self.sights.slice.is_some() { None } else { Some(0.0) };
        let in_pan = self.session.shown_piece().is_some_and(saute_kitchen::Piece::in_pan);
        if self.sights.slice.is_some() && in_pan && !(0.35..2.6).contains(&self.sights.camera.yaw) {
            self.sights.camera.yaw = CUT_YAW;
        }
    }

    /// Moves the cut by a share of the half-length [-]; it stays within the food.
    pub(super) fn shift_slice(&mut self, by: f64) {
        self.sights.slice = Some((self.sights.slice.unwrap_or(0.0) + by).clamp(-LAST_SLICE, LAST_SLICE));
    }

    /// Shows the look next to the view, or the view alone. If the view is the look, it becomes the temperature.
    pub(super) fn toggle_split(&mut self) {
        self.settings.split = !self.settings.is_split();
        if self.settings.split && self.settings.view == View::Look {
            self.settings.view = View::Temperature;
        }
    }

    /// Shows all controls, or the few of a first cook; states the way back to who did not come by the key.
    pub(super) fn more_or_few(&mut self, ctx: &egui::Context) {
        self.settings.few = !self.settings.few;
        if !self.settings.few && ctx.input(|i| i.pointer.any_click()) {
            self.say("notice.all_controls");
        }
    }

    pub(super) fn toggle_projector(&mut self) {
        self.settings.projector = !self.settings.projector;
        if self.settings.projector {
            self.settings.panels_hidden = false;
            self.say("notice.projects");
        }
    }

    pub(super) fn next_map(&mut self) {
        self.settings.map = match self.settings.map {
            TemperatureMap::Uniform => TemperatureMap::Paper2013,
            TemperatureMap::Paper2013 => TemperatureMap::Uniform,
        };
    }

    /// Turns the eye [rad].
    pub(crate) fn orbit(&mut self, dx: f32, dy: f32) {
        self.take_eye();
        self.sights.camera.orbit(dx, dy);
    }

    /// Brings the eye nearer (below 1) or farther.
    pub(crate) fn zoom(&mut self, factor: f32) {
        if factor != 1.0 {
            self.take_eye();
        }
        self.sights.camera.zoom(factor);
    }

    pub(crate) fn next_camera(&mut self) {
        self.take_eye();
        self.sights.camera_preset = (self.sights.camera_preset + 1) % 3;
        self.sights.camera = [Camera::three_quarter, Camera::above, Camera::close_up][self.sights.camera_preset]();
        if self.sights.camera_preset == 2 {
            self.sights.camera.zoom(self.session.shown_piece().map_or(1.0, nearness));
        }
        let on_board = matches!(self.session.shown_piece().map(|p| p.place), Some(Place::Rest(_) | Place::Waiting));
        if self.sights.camera_preset == 2 && on_board {
            self.sights.camera.target = saute_picture::waiting::FIRST_ON_BOARD;
        }
    }
}
