//! The strings of a device in the scene: rods as thick and light as they pull, in dashes through the worktop, with
//! their newtons.

use crate::app::SauteApp;
use crate::desktop::hand::strings_view::{STROKE, Seen, colour, number, project, radius};
use crate::ui::layout::Pane;
use crate::ui::palette::Palette;
use crate::ui::theme;
use egui::{Painter, Rect, Shape, Stroke, Ui, vec2};
use glam::Vec3;
use saute_haptics::{Health, Pose, STRINGS, StringRig};
use saute_scene::camera::Camera;
use saute_scene::mesh::props::COUNTER_Z;

/// Dash and gap below the worktop, and what a metre there is as a stroke from a metre away [points] (chosen: as wide as
/// the rods).
const DASH: [f32; 2] = [5.0, 4.0];

/// How far the eye steps back at once, until no panel covers a motor [-] (chosen).
const STEP_BACK: f32 = 1.04;

impl SauteApp {
    /// Shows the strings from so far away that all motors are seen, or hides them and goes back.
    pub(super) fn turn_strings(&mut self) {
        let Some(rig) = self.session.hands.strung().and_then(|device| device.strings) else { return };
        if let Some(distance) = self.session.hands.eye_before.take() {
            self.sights.camera.distance = distance;
            return;
        }
        self.session.hands.eye_before = Some(self.sights.camera.distance);
        let Some(pane) = self.sights.scene.pane else { return };
        let seen = |eye: &Camera, at: Vec3| project(eye, pane.rect, at).is_some_and(|p| pane.free.contains(p));
        let mut before = 0.0;
        while before != self.sights.camera.distance && !rig.motor.iter().all(|m| seen(&self.eye(), m.as_vec3())) {
            before = self.sights.camera.distance;
            self.sights.camera.zoom(STEP_BACK);
        }
    }

    /// Draws what the scene does not: strings below the worktop, motors, and newtons.
    pub(super) fn draw_strings(&self, ui: &Ui, pane: &Pane) {
        let (strings, eye) = (self.strings_now(), self.eye());
        let painter = ui.painter().with_clip_rect(pane.rect);
        strings.iter().for_each(|string| hidden_part(&painter, &eye, pane.rect, string, theme::of(ui)));
        strings.iter().for_each(|string| number(&painter, &eye, pane, string, theme::of(ui)));
    }

    /// The strings where they are now, while they are shown and known.
    pub(super) fn strings_now(&self) -> Vec<Seen> {
        if !self.session.hands.strings_are_shown() {
            return Vec::new();
        }
        let Some(device) = self.session.hands.strung() else { return Vec::new() };
        let sample = &device.state().sample;
        let known = matches!(sample.health, Health::Running | Health::Stopped);
        match (&device.strings, sample.tension_n.filter(|_| known)) {
            (Some(rig), Some(tension)) => at_pose(rig, &sample.pose, &tension),
            _ => Vec::new(),
        }
    }
}

fn at_pose(rig: &StringRig, pose: &Pose, tension: &[f64; STRINGS]) -> Vec<Seen> {
    let string = |i: usize| Seen {
        from: pose.to_world(rig.attachment[i]).as_vec3(),
        to: rig.motor[i].as_vec3(),
        tension: tension[i],
        number: i + 1,
    };
    (0..STRINGS).map(string).collect()
}

/// Dashes where the worktop hides a string, and its motor.
fn hidden_part(painter: &Painter, eye: &Camera, rect: Rect, string: &Seen, palette: &Palette) {
    let Some(motor) = project(eye, rect, string.to) else { return };
    let away = (string.to - eye.eye()).length().max(0.1);
    let wide = 2.0 * radius(string.tension) * STROKE / 1.4 / away * rect.height() / 1000.0;
    if let (true, Some(enters)) = (string.to.z < COUNTER_Z, project(eye, rect, string.visible_end())) {
        let way = [enters, motor];
        painter.extend(Shape::dashed_line(&way, Stroke::new(wide + 1.6, palette.solid), DASH[0], DASH[1]));
        painter.extend(Shape::dashed_line(&way, Stroke::new(wide, colour(string.tension)), DASH[0], DASH[1]));
    }
    painter.rect_filled(Rect::from_center_size(motor, vec2(12.0, 12.0)), 2.0, palette.solid);
    painter.rect_filled(Rect::from_center_size(motor, vec2(8.0, 8.0)), 1.0, palette.text);
}
