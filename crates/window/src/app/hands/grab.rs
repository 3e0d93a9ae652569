//! The mouse in the scene: it turns the eye, grabs pieces and the pan, and leads them by force.

use crate::app::SauteApp;
use crate::ui::picking::{GRAB, TOUCH};
use crate::ui::scene_view::{meet_height, ndc};
use egui::{Pos2, Rect, Ui};
use glam::{DVec2, DVec3, Quat, Vec3};
use saute_controls::input::grab::{Hold, ORBIT_PER_POINT};
use saute_kitchen::dynamics::{Pose as BodyPose, Tool};
use saute_kitchen::{Command, Piece, Place};
use saute_picture::stage::Pose;
use saute_scene::mesh::props::BOARD_CENTRE;

/// Height at which a carried piece hangs [m] (chosen: above the rim), and within the pan (chosen: over what lies
/// there).
const CARRY_HEIGHT: f32 = 0.085;

const LOW_HEIGHT: f32 = 0.045;
/// How near the pan's middle a piece that is dropped goes to it [m] (chosen: as a hand aims).
const AIMED_AT_MIDDLE: f64 = 0.02;

/// A level pan let go this near to its ring is set onto it [m] (chosen: forgiving).
const HOME: f64 = 0.04;

/// Metres a point of drag lifts the pan (chosen: a hand's breadth across a third of the window).
const LIFT_PER_POINT: f64 = 4e-4;

/// Radians a point of drag tilts the turner (chosen: half a turn across a third of the window), metres a point of the
/// wheel raises it (chosen: a notch is half a centimetre).
const TILT_PER_POINT: f64 = 0.0075;

const RAISE_PER_SCROLL: f64 = 1e-4;

/// How near to the turner's blade a pointer takes it [points] (chosen: forgiving).
const TOOL_GRAB: f32 = 44.0;

impl SauteApp {
    /// Two fingers turn the eye and bring it nearer, wherever they lie; returns false if there are none.
    fn take_two_fingers(&mut self, ui: &Ui) -> bool {
        let Some(fingers) = ui.input(|i| i.multi_touch()) else { return false };
        // What the first finger took hold of before the second one came is let go.
        if self.sights.scene.hold != Hold::Nothing {
            self.let_go();
        }
        let by = fingers.translation_delta;
        self.orbit(-ORBIT_PER_POINT * by.x, ORBIT_PER_POINT * by.y);
        self.zoom(1.0 / fingers.zoom_delta);
        true
    }

    /// Takes the mouse in the scene.
    pub(crate) fn take_mouse(&mut self, ui: &Ui, response: &egui::Response, rect: Rect) {
        if self.take_two_fingers(ui) {
            return;
        }
        if response.hovered() {
            // With Shift, which moves the pan, the wheel scrolls sideways.
            let wheel = ui.input(|i| i.smooth_scroll_delta());
            let scroll = wheel.x + wheel.y;
            let pinch = ui.input(|i| i.zoom_delta());
            if self.sights.scene.hold == Hold::Turner && scroll != 0.0 {
                self.with_turner(|turner| turner.shift(DVec3::Z * (RAISE_PER_SCROLL * f64::from(scroll))));
            } else if self.sights.scene.hold != Hold::Turner {
                self.zoom((-0.0015 * scroll).exp() / pinch);
            }
        }
        if let Some(at) = response.interact_pointer_pos() {
            if response.drag_started() {
                let origin = ui.input(|i| i.pointer.press_origin()).unwrap_or(at);
                self.sights.scene.hold = self.grabbed(origin, rect);
            }
            if response.dragged() {
                self.drag(ui, response, at, rect);
            }
            if response.clicked() {
                self.click(at, rect);
            }
        }
        if response.long_touched() {
            self.sights.scene.hold = Hold::Asks;
        }
        let lifted = self.sights.scene.hold == Hold::Asks && !ui.input(|i| i.pointer.any_down());
        if response.drag_stopped() || lifted {
            self.let_go();
        }
        self.hover(ui, response, rect);
    }

    fn hover(&mut self, ui: &Ui, response: &egui::Response, rect: Rect) {
        let touched = ui.input(|i| i.any_touches());
        let asks = self.sights.scene.hold == Hold::Asks;
        let finger = ui.input(|i| i.pointer.latest_pos()).filter(|_| asks);
        // A finger on its way to a tap or a drag requests no read-out.
        let idle = response.hover_pos().filter(|_| self.sights.scene.hold == Hold::Nothing && !touched);
        self.sights.scene.reads_at = finger.or(idle).map(|at| (at, asks));
        let within = if asks { GRAB } else { TOUCH };
        self.sights.scene.hovered = finger.or(idle).and_then(|at| self.piece_near(at, rect, within));
        if self.sights.scene.hovered.is_some() || idle.is_some_and(|at| self.pan_near(at, rect)) {
            ui.ctx().set_cursor_icon(egui::CursorIcon::Grab);
        } else if !matches!(self.sights.scene.hold, Hold::Nothing | Hold::Eye | Hold::Asks) {
            ui.ctx().set_cursor_icon(egui::CursorIcon::Grabbing);
        }
    }

    /// What a drag from a place takes hold of: a piece on it, else the pan, else a piece near it.
    fn grabbed(&mut self, at: Pos2, rect: Rect) -> Hold {
        let piece = self.piece_near(at, rect, TOUCH);
        if self.takes_turner(piece.as_deref(), at, rect) {
            return Hold::Turner;
        }
        if piece.is_none() && self.pan_near(at, rect) && self.session.kitchen.cloth().is_none() {
            return self.grab_pan(at, rect);
        }
        let Some(id) = piece.or_else(|| self.piece_near(at, rect, GRAB)) else { return Hold::Eye };
        let waits = self.session.kitchen.piece(&id).is_some_and(|p| p.place == Place::Waiting);
        self.session.select(Some(id.clone()));
        if waits { Hold::Waiting(id) } else { Hold::Piece(id) }
    }

    /// With the turner chosen a drag from what is in the pan, or from the blade, leads it.
    fn takes_turner(&self, piece: Option<&str>, at: Pos2, rect: Rect) -> bool {
        if self.inputs.tool_hand.tool != Tool::Turner {
            return false;
        }
        let kitchen = &self.session.kitchen;
        let blade = kitchen.hand().tool_pose(kitchen.world()).position.as_vec3();
        let on_blade = self.on_screen(blade, rect).is_some_and(|seen| seen.distance(at) < TOOL_GRAB);
        if self.inputs.tool_hand.turner.is_some() && on_blade {
            return true;
        }
        if let Some(id) = piece {
            return kitchen.piece(id).is_some_and(Piece::is_out);
        }
        let pan = kitchen.world().motion.pose.position.as_vec3();
        let floor = kitchen.world().pan_shape().floor as f32;
        self.pointed(at, rect, pan.z).is_some_and(|hit| (hit - pan).truncate().length() < floor)
    }

    fn grab_pan(&self, at: Pos2, rect: Rect) -> Hold {
        let pan = Pose::of_body(&self.session.kitchen.held_pan()).position;
        let plane = pan.z + self.session.kitchen.world().pan_shape().height as f32;
        self.pointed(at, rect, plane).map_or(Hold::Eye, |hit| Hold::Pan { offset: (pan - hit).with_z(0.0), plane })
    }

    /// The point of a level plane that a place in the window shows [m].
    fn pointed(&self, at: Pos2, rect: Rect, height: f32) -> Option<Vec3> {
        let (origin, direction) = self.eye().ray(ndc(at, rect), rect.width() / rect.height());
        meet_height(origin, direction, height)
    }

    fn drag(&mut self, ui: &Ui, response: &egui::Response, at: Pos2, rect: Rect) {
        match self.sights.scene.hold.clone() {
            Hold::Nothing | Hold::Asks => {}
            Hold::Eye => {
                let delta = response.drag_delta();
                self.orbit(-ORBIT_PER_POINT * delta.x, ORBIT_PER_POINT * delta.y);
            }
            Hold::Waiting(id) => self.carry(id, at, rect),
            Hold::Piece(id) => self.lead(id, at, rect),
            Hold::Turner => self.drag_turner(ui, response, at, rect),
            Hold::Pan { .. } if ui.input(|i| i.modifiers.shift) => {
                let mut pose = self.session.kitchen.held_pan();
                pose.position.z -= LIFT_PER_POINT * f64::from(response.drag_delta().y);
                self.hold_pan(pose);
            }
            Hold::Pan { offset, plane } => {
                let Some(hit) = self.pointed(at, rect, plane) else { return };
                let mut pose = self.session.kitchen.held_pan();
                let to = (hit + offset).as_dvec3();
                (pose.position.x, pose.position.y) = (to.x, to.y);
                self.hold_pan(pose);
            }
        }
    }

    /// Holds the pan at a pose.
    pub(crate) fn hold_pan(&mut self, pose: BodyPose) {
        if pose != self.session.kitchen.held_pan() {
            self.command(&Command::HoldPan { pose });
        }
    }

    /// A waiting piece is no body yet: it hangs at the pointer, and low over the pan, so that it falls to where the pointer shows.
    fn carry(&mut self, id: String, at: Pos2, rect: Rect) {
        let beside = || self.pointed(at, rect, CARRY_HEIGHT);
        let Some(hit) = self.low_in_pan(at, rect).or_else(beside) else { return };
        let position = Vec3::new(hit.x.clamp(-0.5, 0.6), hit.y.clamp(-0.4, 0.4), hit.z);
        let rotation = Quat::from_rotation_z(-std::f32::consts::FRAC_PI_2);
        self.sights.scene.carried.insert(id, Pose { position, rotation });
    }

    /// A place low over the place of the pan's floor that the pointer shows; none beside the pan.
    fn low_in_pan(&self, at: Pos2, rect: Rect) -> Option<Vec3> {
        let pan = self.session.kitchen.world().motion.pose.position.as_vec3();
        let floor = self.session.kitchen.world().pan_shape().floor as f32;
        let low = self.pointed(at, rect, pan.z);
        low.filter(|p| (*p - pan).truncate().length() < floor).map(|p| p + Vec3::Z * LOW_HEIGHT)
    }

    /// Leads the tongs to above the place that the pointer shows: low within the pan, over its rim elsewhere.
    fn lead(&mut self, id: String, at: Pos2, rect: Rect) {
        if self.stands_still() {
            return;
        }
        let pan_z = self.session.kitchen.world().motion.pose.position.z as f32;
        let beside = || Some(self.pointed(at, rect, BOARD_CENTRE.z)?.with_z(pan_z.max(0.0) + CARRY_HEIGHT));
        let Some(hit) = self.low_in_pan(at, rect).or_else(beside) else { return };
        let position = hit.as_dvec3().clamp(DVec3::new(-0.55, -0.45, 0.0), DVec3::new(0.6, 0.5, 0.4));
        self.lead_tongs(&id, position);
    }

    /// Leads the turner to the place that the pointer shows at its height; the right button or Ctrl tilts it, Alt turns
    /// and raises it.
    fn drag_turner(&mut self, ui: &Ui, response: &egui::Response, at: Pos2, rect: Rect) {
        let by = response.drag_delta();
        let [dx, dy] = [by.x, by.y].map(f64::from);
        let keys = ui.input(|i| i.modifiers);
        if keys.command || response.dragged_by(egui::PointerButton::Secondary) {
            return self.with_turner(|turner| turner.tilt(TILT_PER_POINT * dx, -TILT_PER_POINT * dy));
        }
        if keys.alt {
            return self.with_turner(|turner| {
                turner.facing -= TILT_PER_POINT * dx;
                turner.shift(DVec3::Z * (-LIFT_PER_POINT * dy));
            });
        }
        let height = self.inputs.tool_hand.turner.map_or(0.0, |turner| turner.height);
        let plane = self.session.kitchen.world().motion.pose.position.z + height;
        let Some(hit) = self.pointed(at, rect, plane as f32) else { return };
        self.with_turner(|turner| {
            turner.at = hit.truncate().as_dvec2();
            turner.shift(DVec3::ZERO);
        });
    }

    /// A click puts a piece that waits into the pan, flips one that is in it, and puts back one that lies elsewhere.
    fn click(&mut self, at: Pos2, rect: Rect) {
        let Some(id) = self.piece_near(at, rect, TOUCH) else { return };
        let Some(in_pan) = self.session.kitchen.piece(&id).map(Piece::in_pan) else { return };
        self.session.select(Some(id.clone()));
        if in_pan {
            self.command(&Command::Flip { food: id });
        } else {
            self.lay_in(&[id]);
        }
    }

    /// What the mouse held is laid down where it is; a pan released next to its ring slides onto it.
    fn let_go(&mut self) {
        match std::mem::take(&mut self.sights.scene.hold) {
            Hold::Piece(_) => self.command(&Command::LetGo),
            Hold::Pan { .. } => self.release_pan(),
            Hold::Waiting(_) => self.drop_waiting(),
            Hold::Turner => self.settle_turner(),
            Hold::Nothing | Hold::Eye | Hold::Asks => {}
        }
    }

    fn settle_turner(&mut self) {
        if self.inputs.tool_hand.turner.is_some() && !self.session.paused {
            self.with_turner(saute_controls::input::tool_hand::TurnerPose::settle);
        }
    }

    /// The pan is set down where it is held, on its ring where that is near.
    pub(crate) fn release_pan(&mut self) {
        let mut pose = self.session.kitchen.held_pan();
        pose.position.z = 0.0;
        pose.rotation = BodyPose::default().rotation;
        if pose.position.truncate().length() < HOME {
            pose.position = DVec3::ZERO;
        }
        self.hold_pan(pose);
    }

    /// Over the pan a carried piece goes in, as near to the hand as it fits; elsewhere it stays on the board.
    fn drop_waiting(&mut self) {
        for (food, pose) in std::mem::take(&mut self.sights.scene.carried) {
            self.sights.motions.release(&food, pose);
            let kitchen = &self.session.kitchen;
            let (pan, shape) = (self.places().pan(kitchen), *kitchen.world().pan_shape());
            let place = pan.matrix().inverse().transform_point3(pose.position).truncate().as_dvec2();
            if place.length() > shape.rim {
                continue;
            }
            let ids = [food.clone()];
            // Whoever aims at the middle means it.
            let place = if place.length() < AIMED_AT_MIDDLE { DVec2::ZERO } else { place };
            let near = kitchen.free_places(&ids, place.to_array());
            let free = near.first().copied().or_else(|| kitchen.free_places(&ids, [0.0, 0.0]).first().copied());
            let heap = free.is_none();
            let at = free.unwrap_or(place.clamp_length_max(0.6 * shape.floor).to_array());
            self.command(&Command::Put { food, at, heap });
        }
    }
}
