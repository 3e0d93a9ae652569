//! The scene in the window: drawing, orbiting, picking and dragging.

use std::collections::BTreeMap;
use std::sync::Arc;

use egui::{Color32, Pos2, Rect, Sense, Stroke, Ui, pos2, vec2};
use glam::{Mat4, Vec3};
use saute_kitchen::{Command, Piece, RestOn};

use crate::app::SauteApp;
use crate::layout::Layout;
use crate::scene::callback::SceneCallback;
use crate::stage::{Pose, StageOptions, half_length, pan_position};
use crate::theme;

/// What the mouse is doing in the scene.
#[derive(Clone, Debug, Default, PartialEq)]
enum Hold {
    #[default]
    Nothing,
    Eye,
    Steak,
}

/// State of the scene's part of the window.
#[derive(Clone, Debug, Default)]
pub struct SceneView {
    /// Size drawn last [pixels].
    pub drawn_size: [u32; 2],
    /// Pieces held by the mouse.
    pub(crate) carried: BTreeMap<String, Pose>,
    hold: Hold,
}

/// Radians a point of drag (chosen: half a turn across a window).
const ORBIT_PER_POINT: f32 = 0.005;
/// Height of the cut's knob above the steak [m] (chosen: clear of the crust, near enough to belong to it).
const KNOB_HEIGHT: f32 = 0.028;
/// Height at which a carried steak hangs [m] (chosen: above the rim).
const CARRY_HEIGHT: f32 = 0.085;

impl SauteApp {
    /// Draws the scene over the whole window and takes the mouse there.
    pub(crate) fn show_scene(&mut self, ui: &mut Ui, layout: &Layout) {
        let rect = layout.whole;
        self.camera.shift = layout.lens_shift();
        let response = ui.interact(rect, ui.scope_id().with("scene"), Sense::click_and_drag());
        response.widget_info(|| {
            egui::WidgetInfo::labeled(egui::accesskit::Role::Canvas, true, "Pan and food; drag to look around")
        });
        self.take_mouse(ui, &response, rect);
        let options = StageOptions {
            camera: self.camera.clone(),
            view: self.settings.view,
            map: self.settings.map,
            scale: self.scale(),
            slice: self.slice,
            flat: false,
        };
        let input = self.stage.scene(&self.session.kitchen, &options, &self.places());
        self.scene.drawn_size = self.scene_pixels(rect, ui.ctx().pixels_per_point());
        if self.drawable() {
            let callback = SceneCallback { input: Arc::new(input), size: self.scene.drawn_size };
            ui.painter().add(egui_wgpu::Callback::new_paint_callback(rect, callback));
        } else {
            ui.painter().rect_filled(rect, 0.0, Color32::from_gray(40));
        }
        self.show_slice_handle(ui, rect);
    }

    fn take_mouse(&mut self, ui: &Ui, response: &egui::Response, rect: Rect) {
        let aspect = rect.width() / rect.height();
        let pointer = response.interact_pointer_pos();
        if response.hovered() {
            let scroll = ui.input(|i| i.smooth_scroll_delta().y);
            let pinch = ui.input(|i| i.zoom_delta());
            self.camera.zoom((-0.0015 * scroll).exp() / pinch);
        }
        if let Some(at) = pointer {
            if response.drag_started() {
                let origin = ui.input(|i| i.pointer.press_origin()).unwrap_or(at);
                self.scene.hold = if self.steak_under(origin, rect, aspect) { Hold::Steak } else { Hold::Eye };
            }
            match self.scene.hold {
                Hold::Eye if response.dragged() => {
                    let delta = response.drag_delta();
                    self.camera.orbit(-ORBIT_PER_POINT * delta.x, ORBIT_PER_POINT * delta.y);
                }
                Hold::Steak if response.dragged() => self.carry(at, rect, aspect),
                _ => {}
            }
            if response.clicked() && self.steak_under(at, rect, aspect) {
                self.click_steak();
            }
        }
        if response.drag_stopped() {
            self.let_go();
        }
        let idle = response.hover_pos().filter(|_| self.scene.hold == Hold::Nothing);
        if idle.is_some_and(|at| self.steak_under(at, rect, aspect)) {
            ui.ctx().set_cursor_icon(egui::CursorIcon::Grab);
        }
    }

    /// A click puts a steak that lies outside into the pan, and flips one that is in it.
    fn click_steak(&mut self) {
        let Some(in_pan) = self.session.steak().map(Piece::in_pan) else { return };
        let food = self.steak_id();
        self.command(&if in_pan { Command::Flip { food } } else { Command::Put { food, at: [0.0, 0.0], heap: false } });
    }

    fn steak_pose(&self) -> Option<(Pose, &Piece)> {
        let piece = self.session.steak()?;
        let pose = self.places().piece(&self.session.kitchen, piece);
        Some((pose, piece))
    }

    fn steak_under(&self, at: Pos2, rect: Rect, aspect: f32) -> bool {
        let Some((pose, piece)) = self.steak_pose() else { return false };
        let (origin, direction) = self.eye().ray(ndc(at, rect), aspect);
        let half = 0.5 * piece.model.thickness(&piece.state) as f32;
        let outline = &piece.model.outline;
        [-1.0, 0.0, 1.0].iter().any(|level| {
            let Some(hit) = meet_height(origin, direction, pose.position.z + level * half) else { return false };
            let local = pose.matrix().inverse().transform_point3(hit);
            outline.contains([f64::from(local.x), f64::from(local.y)])
        })
    }

    fn carry(&mut self, at: Pos2, rect: Rect, aspect: f32) {
        let Some((pose, piece)) = self.steak_pose() else { return };
        let (id, rotation) = (piece.id.clone(), pose.rotation);
        let (origin, direction) = self.eye().ray(ndc(at, rect), aspect);
        if let Some(hit) = meet_height(origin, direction, CARRY_HEIGHT) {
            let position = Vec3::new(hit.x.clamp(-0.5, 0.6), hit.y.clamp(-0.4, 0.4), CARRY_HEIGHT);
            self.scene.carried.insert(id, Pose { position, rotation });
        }
    }

    /// Over the pan a carried steak goes in, as near to the hand as it fits; elsewhere it goes onto the board.
    fn let_go(&mut self) {
        self.scene.hold = Hold::Nothing;
        for (food, pose) in std::mem::take(&mut self.scene.carried) {
            self.motions.release(&food, pose);
            let Some(piece) = self.session.kitchen.piece(&food) else { continue };
            let pan = &self.session.kitchen.pan_model().description;
            let rim = pan.wall.rim_radius_mm as f32 * 1e-3;
            let offset = pose.position - pan_position(&self.session.kitchen);
            let over_pan = offset.truncate().length() < rim;
            match (over_pan, piece.in_pan()) {
                (true, false) => {
                    let room = (pan.floor.radius_mm * 1e-3 - piece.model.outline.reach()).max(0.0) as f32;
                    let place = offset.truncate().clamp_length_max(0.98 * room);
                    self.command(&Command::Put { food, at: [f64::from(place.x), f64::from(place.y)], heap: false });
                }
                (false, true) => self.command(&Command::Rest { food, on: RestOn::Board }),
                _ => {}
            }
        }
    }

    /// Where the middle of the steak appears in a window.
    pub fn steak_on_screen(&self, window: Rect) -> Option<Pos2> {
        let (pose, _) = self.steak_pose()?;
        let ndc = self.eye().project(pose.position, window.width() / window.height())?;
        Some(on_screen(ndc, window))
    }

    /// Where the foot and the knob of the cut's handle appear in a window.
    pub fn cut_handle_on_screen(&self, window: Rect) -> Option<[Pos2; 2]> {
        let (slice, (pose, piece)) = (self.slice?, self.steak_pose()?);
        let lengthwise = piece.model.size[0] >= piece.model.size[1];
        let height = 0.5 * piece.model.thickness(&piece.state) as f32;
        let place = along(&pose.matrix(), lengthwise, slice as f32 * half_length(piece) as f32) + Vec3::Z * height;
        let aspect = window.width() / window.height();
        let foot = self.eye().project(place, aspect)?;
        let knob = self.eye().project(place + Vec3::Z * KNOB_HEIGHT, aspect)?;
        Some([on_screen(foot, window), on_screen(knob, window)])
    }

    /// The cut's handle: a knob above the cut that is dragged along the steak.
    fn show_slice_handle(&mut self, ui: &mut Ui, rect: Rect) {
        let (Some(slice), Some([foot, knob])) = (self.slice, self.cut_handle_on_screen(rect)) else { return };
        let response = ui.interact(
            Rect::from_center_size(knob, vec2(44.0, 44.0)),
            ui.scope_id().with("cut"),
            Sense::click_and_drag(),
        );
        response.widget_info(|| egui::WidgetInfo::slider(true, slice, "Place of the cut"));
        if let (true, Some(at)) = (response.dragged(), response.interact_pointer_pos()) {
            self.drag_cut(at, rect);
        }
        let fill = if response.hovered() || response.dragged() { theme::ACCENT } else { theme::TEXT };
        ui.painter().line_segment([foot, knob], Stroke::new(2.0, fill));
        ui.painter().circle(knob, 11.0, fill, Stroke::new(2.0, theme::GROUND));
        for side in [-1.0, 1.0] {
            let tip = knob + vec2(side * 6.0, 0.0);
            let back = |dy: f32| knob + vec2(side * 2.0, dy);
            ui.painter().line_segment([tip, back(-3.5)], Stroke::new(1.5, theme::ON_ACCENT));
            ui.painter().line_segment([tip, back(3.5)], Stroke::new(1.5, theme::ON_ACCENT));
        }
    }
}

impl SauteApp {
    fn drag_cut(&mut self, at: Pos2, rect: Rect) {
        let Some((pose, piece)) = self.steak_pose() else { return };
        let (origin, direction) = self.eye().ray(ndc(at, rect), rect.width() / rect.height());
        let height = pose.position.z + 0.5 * piece.model.thickness(&piece.state) as f32 + KNOB_HEIGHT;
        let Some(hit) = meet_height(origin, direction, height) else { return };
        let local = pose.matrix().inverse().transform_point3(hit);
        let lengthwise = piece.model.size[0] >= piece.model.size[1];
        let s = if lengthwise { local.x } else { local.y } / half_length(piece) as f32;
        self.slice = Some(f64::from(s.clamp(-0.95, 0.95)));
    }
}

fn along(world: &Mat4, lengthwise: bool, distance: f32) -> Vec3 {
    world.transform_point3(if lengthwise { Vec3::X * distance } else { Vec3::Y * distance })
}

fn ndc(at: Pos2, rect: Rect) -> [f32; 2] {
    [2.0 * (at.x - rect.left()) / rect.width() - 1.0, 1.0 - 2.0 * (at.y - rect.top()) / rect.height()]
}

fn on_screen(ndc: [f32; 2], rect: Rect) -> Pos2 {
    pos2(rect.left() + 0.5 * (ndc[0] + 1.0) * rect.width(), rect.top() + 0.5 * (1.0 - ndc[1]) * rect.height())
}

fn meet_height(origin: Vec3, direction: Vec3, z: f32) -> Option<Vec3> {
    let t = (z - origin.z) / direction.z;
    (t.is_finite() && t > 0.0).then(|| origin + direction * t)
}
