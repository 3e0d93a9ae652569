//! The tool in the cook's hand: tongs that grip what is dragged, or a turner that stays where it was put.

use crate::app::SauteApp;
use glam::{DQuat, DVec2, DVec3};
use saute_controls::input::tool_hand::{HIGHEST, REACH, TurnerPose};
use saute_kitchen::dynamics::{BLADE_HALF, Pose, Tool};
use saute_kitchen::{Command, Piece};
use std::f64::consts::FRAC_PI_2;

/// Height at least at which food on the blade is rolled [m] (chosen: a steak clears the pan).
const ROLL_HEIGHT: f64 = 0.07;

/// How far inside of the floor's edge the front of the turner comes in [m] (chosen: food in the middle is not met yet).
const COMES_IN: f64 = 0.025;

/// How fast the right stick moves a tool [m/s] and turns it [rad/s] (chosen: a calm arm).
const STICK_SPEED: f64 = 0.25;

const STICK_TURN: f64 = 3.0;

impl SauteApp {
    /// The other tool; the one in the hand is laid down.
    pub(crate) fn choose_tool(&mut self) {
        self.put_tool_away();
        let (tool, words) = match self.inputs.tool_hand.tool {
            Tool::Tongs => (Tool::Turner, "notice.turner"),
            Tool::Turner => (Tool::Tongs, "notice.tongs"),
        };
        self.inputs.tool_hand.tool = tool;
        self.say(words);
    }

    /// Lays down what the tool holds and puts the tool away.
    pub(crate) fn put_tool_away(&mut self) {
        if self.inputs.tool_hand.turner.take().is_some() | self.inputs.tool_hand.tongs.take().is_some() {
            self.command(&Command::LetGo);
        }
    }

    /// Forgets a tool that the kitchen has put away by itself: for a task, or with a new kitchen.
    pub(crate) fn look_at_tool(&mut self) {
        let led = self.session.kitchen.led_tool();
        if led != Some(Tool::Turner) {
            self.inputs.tool_hand.turner = None;
        }
        if led != Some(Tool::Tongs) {
            self.inputs.tool_hand.tongs = None;
        }
    }

    /// The turner in the hand; one that lay aside comes in over the pan's edge at the cook's side.
    fn turner_in_hand(&mut self) -> TurnerPose {
        if let Some(turner) = self.inputs.tool_hand.turner {
            return turner;
        }
        let facing = f64::from(self.sights.camera.yaw) + FRAC_PI_2;
        let world = self.session.kitchen.world();
        let away = DVec2::from_angle(facing) * (world.pan_shape().floor - COMES_IN + BLADE_HALF.x);
        let at = world.motion.pose.position.truncate() - away;
        let turner = TurnerPose { at, height: 0.0, facing, roll: 0.0, pitch: 0.0 };
        self.lead_turner(turner);
        turner
    }

    fn lead_turner(&mut self, turner: TurnerPose) {
        let floor = self.session.kitchen.world().motion.pose.position.z;
        self.command(&Command::Lead { tool: Tool::Turner, to: turner.pose(floor), grip: None });
        self.inputs.tool_hand.turner = self.session.kitchen.led_tool().map(|_| turner);
    }

    /// Changes where the turner is to be; food on its blade is rolled high enough above the pan.
    pub(crate) fn with_turner(&mut self, change: impl FnOnce(&mut TurnerPose)) {
        if self.stands_still() || self.inputs.tool_hand.tool != Tool::Turner {
            return;
        }
        let before = self.turner_in_hand();
        let mut turner = before;
        change(&mut turner);
        if turner.roll != before.roll && self.session.kitchen.hand().gripped().is_some() {
            turner.height = turner.height.max(ROLL_HEIGHT);
        }
        if turner != before {
            self.lead_turner(turner);
        }
    }

    /// Returns true if time is stopped, and then shows a notice.
    pub(crate) fn stands_still(&self) -> bool {
        if self.session.paused {
            self.say("notice.paused");
        }
        self.session.paused
    }

    /// Leads the tongs: first to where the piece is, then with it.
    pub(crate) fn lead_tongs(&mut self, id: &str, position: DVec3) {
        let Some(piece) = self.session.kitchen.piece(id) else { return };
        let held = self.session.kitchen.hand().gripped() == Some(piece.key);
        let to = Pose { position: if held { position } else { grip_point(piece) }, ..Pose::default() };
        self.command(&Command::Lead { tool: Tool::Tongs, to, grip: Some(id.to_owned()) });
    }

    /// Moves and turns the tool as a stick commands, seen from the eye, over `wall` seconds (−1…1 each).
    pub(crate) fn move_tool(&mut self, way: DVec3, [roll, pitch]: [f64; 2], wall: f64) {
        if way == DVec3::ZERO && roll == 0.0 && pitch == 0.0 {
            return;
        }
        let by = DQuat::from_rotation_z(f64::from(self.sights.camera.yaw)) * (way * STICK_SPEED * wall);
        match self.inputs.tool_hand.tool {
            Tool::Turner => self.with_turner(|turner| {
                turner.shift(by);
                turner.tilt(roll * STICK_TURN * wall, pitch * STICK_TURN * wall);
            }),
            Tool::Tongs => self.move_tongs(by),
        }
    }

    fn move_tongs(&mut self, by: DVec3) {
        if self.stands_still() {
            return;
        }
        let begun = || {
            let id = self.handled_id();
            Some((id.clone(), grip_point(self.session.kitchen.piece(&id)?)))
        };
        let Some((id, at)) = self.inputs.tool_hand.tongs.clone().or_else(begun) else { return };
        let at = (at + by).clamp(DVec3::new(-REACH, -REACH, 0.0), DVec3::new(REACH, REACH, HIGHEST));
        self.lead_tongs(&id, at);
        self.inputs.tool_hand.tongs = self.session.kitchen.led_tool().map(|_| (id, at));
    }
}

/// Where tongs take hold of a piece: a little above its middle.
fn grip_point(piece: &Piece) -> DVec3 {
    piece.pose.position + DVec3::Z * (0.3 * piece.model.size()[2])
}
