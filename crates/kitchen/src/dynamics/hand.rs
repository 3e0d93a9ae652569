//! The second hand: turner or tongs that move food by forces.
//!
//! A tool moves along legs with bounded speed. A gripped body follows it by a spring–damper with bounded force and
//! torque. No pose is ever set: a body that is too heavy, stuck or held down stays in place.

use glam::DVec3;
use saute_food::GRAVITY;
use serde::{Deserialize, Serialize};

use super::pose::{Pose, rotation_between, turn};
use super::press_path::{is_covered, on_top};
use super::scoop::Under;
use super::spring::Spring;
use super::world::{RIGID_S, World};

/// Tool of a hand.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq, Serialize)]
pub enum Tool {
    /// A blade that slides under food, lifts, turns and presses it.
    #[default]
    Turner,
    /// Tongs that grip food at any place.
    Tongs,
}

/// Largest force [N] and torque [N·m] of the grip (chosen: held without effort with a turner).
pub const GRIP_FORCE: f64 = 12.0;
const GRIP_TORQUE: f64 = 1.5;
/// Distance [m] and angle [rad] beyond which a grip slips, and the time until it is lost [s] (chosen).
const SLIP: f64 = 0.03;
const SLIP_ANGLE: f64 = 0.9;
const SLIP_S: f64 = 0.15;
/// Largest distance between tool and food for a grip [m] (chosen: forgiving).
pub const REACH: f64 = 0.05;
/// Force on the blade above which the hand waits [N] (chosen: equal to the grip's force).
const YIELD_FORCE: f64 = 12.0;
/// Longest wait of a blocked tool before its task fails [s] (chosen).
const PATIENCE_S: f64 = 0.5;

/// Frame of reference of a leg.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, Serialize)]
pub enum Frame {
    /// Moves with the pan.
    Pan,
    /// Fixed in the kitchen.
    Kitchen,
}

/// Action of a tool at the end of a leg.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub enum Act {
    /// No action.
    Pass,
    /// Grips a body.
    Grip(u32),
    /// Releases the grip.
    Release,
    /// Presses a body down at its place.
    Press {
        /// Which body.
        key: u32,
        /// Force [N].
        newtons: f64,
        /// Duration [s].
        for_s: f64,
    },
}

/// A leg of a tool's path.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct Leg {
    /// Frame of reference.
    pub frame: Frame,
    /// Pose at its end.
    pub to: Pose,
    /// Rotation on the way as a rotation vector in the frame [rad].
    pub turn: DVec3,
    /// Duration [s].
    pub for_s: f64,
    /// Action at its end.
    pub act: Act,
}

/// Outcome of a task.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ended {
    /// Completed.
    Done,
    /// Failed: the tool was blocked, or the food slipped off.
    Blocked,
}

/// A grip on a body.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
struct Grip {
    key: u32,
    /// Pose of the body in the tool's frame.
    hold: Pose,
    spring: Spring,
    slipping_s: f64,
}

/// The hand with its tool.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Hand {
    /// Its tool.
    pub tool: Tool,
    /// Commanded pose of the tool's tip.
    pub pose: Pose,
    legs: Vec<Leg>,
    leg: usize,
    from: Pose,
    elapsed: f64,
    waited: f64,
    grip: Option<Grip>,
    spared: Option<u32>,
    /// Food above a free turner.
    pub(super) under: Option<Under>,
    /// Spring–damper that pulls a free turner.
    spring: Option<Spring>,
    /// True while it works; else its tool is put away.
    active: bool,
}

impl Hand {
    /// Starts a path of legs; `spared` is the body under which the blade slides.
    pub fn begin(&mut self, tool: Tool, legs: Vec<Leg>, spared: Option<u32>, world: &World) {
        let Some(first) = legs.first() else { return };
        let start = place(first, world);
        *self = Self {
            tool,
            pose: Pose { position: start.position + DVec3::Z * HOVER, ..start },
            from: Pose { position: first.to.position + DVec3::Z * HOVER, ..first.to },
            legs,
            spared,
            active: true,
            ..Self::default()
        };
    }

    /// Returns true if it is on one of its legs.
    pub(crate) fn is_sound(&self) -> bool {
        self.legs.is_empty() || self.leg < self.legs.len()
    }

    /// Returns true while it works.
    pub fn is_active(&self) -> bool {
        self.active
    }

    /// Key of the gripped body.
    pub fn gripped(&self) -> Option<u32> {
        self.grip.map(|g| g.key)
    }

    /// Returns true if it follows no path of legs.
    pub(super) fn is_free(&self) -> bool {
        self.legs.is_empty()
    }

    /// Actual pose of its tool; an obstacle can stop a free turner short of the commanded pose.
    pub fn tool_pose(&self, world: &World) -> Pose {
        world.blade_pose().filter(|_| self.leads_turner()).unwrap_or(self.pose)
    }

    /// Height of the grip's target above the gripped body; negative if the body is supported from below [m].
    pub fn hanging_below(&self, world: &World) -> Option<f64> {
        let grip = self.grip?;
        let body = world.pose(grip.key)?;
        Some(self.pose.then(&grip.hold).position.z - body.position.z)
    }

    /// Grips a body within reach in its present pose; returns true on success.
    pub fn grip(&mut self, key: u32, world: &World) -> bool {
        if world.distance(key, self.pose.position) > REACH {
            return false;
        }
        let tool = self.pose;
        self.hold(key, &tool, world);
        self.gripped().is_some()
    }

    /// Grips a body in its present pose relative to a pose of the tool.
    pub(super) fn hold(&mut self, key: u32, tool: &Pose, world: &World) {
        let grip = |body: Pose| Grip { key, hold: body.seen_from(tool), spring: Spring::at(body), slipping_s: 0.0 };
        self.grip = world.pose(key).map(grip);
    }

    /// Releases the grip.
    pub fn release(&mut self) {
        self.grip = None;
    }

    /// Moves the free tool towards a pose with bounded speed; the gripped body follows.
    pub fn lead(&mut self, tool: Tool, to: &Pose) {
        (self.tool, self.active) = (tool, true);
        self.legs.clear();
        let way = to.position - self.pose.position;
        self.pose.position += way.clamp_length_max(LEAD_SPEED * RIGID_S);
        let twist = rotation_between(self.pose.rotation, to.rotation).clamp_length_max(LEAD_TURN * RIGID_S);
        self.pose.rotation = (super::pose::about(twist) * self.pose.rotation).normalize();
    }

    /// Puts the tool away.
    pub fn withdraw(&mut self) {
        *self = Self::default();
    }

    /// Advances tool and grip by one rigid step; returns the outcome when the path ends.
    pub fn step(&mut self, world: &mut World) -> Option<Ended> {
        if !self.active {
            return None;
        }
        let ended = if self.legs.is_empty() { None } else { self.go(world) };
        if self.leads_turner() {
            self.keep_blade_above(world);
        } else {
            self.keep_above_pan(world);
        }
        let slipped = self.pull(world);
        if slipped && self.leads_turner() {
            // The slipped food was held by an obstacle, and so is the blade below it.
            self.pose = self.tool_pose(world);
        }
        let ended = if slipped { Some(Ended::Blocked) } else { ended };
        if ended.is_some() && !self.legs.is_empty() {
            self.withdraw();
        }
        ended
    }

    fn go(&mut self, world: &mut World) -> Option<Ended> {
        let leg = self.legs[self.leg];
        if let Act::Press { key, newtons, for_s } = leg.act
            && self.elapsed >= leg.for_s
        {
            return self.press(key, newtons, leg.for_s + for_s, world);
        }
        if world.blade_force() > YIELD_FORCE {
            self.waited += RIGID_S;
            return (self.waited > PATIENCE_S).then_some(Ended::Blocked);
        }
        self.elapsed += RIGID_S;
        let share = smooth((self.elapsed / leg.for_s).min(1.0));
        let frame = frame_pose(leg.frame, world);
        let mut at = self.from.towards(&leg.to, share);
        if leg.turn != DVec3::ZERO {
            let angle = leg.turn.length();
            at = Pose { position: at.position, rotation: self.from.rotation }.turned(leg.turn / angle, angle * share);
        }
        self.pose = frame.then(&at);
        if self.elapsed < leg.for_s || matches!(leg.act, Act::Press { .. }) {
            return None;
        }
        match leg.act {
            Act::Grip(key) if !self.grip(key, world) => return Some(Ended::Blocked),
            Act::Release => self.release(),
            _ => {}
        }
        self.next_leg(&leg, world)
    }

    /// Presses until `end` of the leg [s], then lifts off; only time at the full force counts.
    fn press(&mut self, key: u32, newtons: f64, end: f64, world: &mut World) -> Option<Ended> {
        if self.elapsed < end {
            if is_covered(world, key) {
                return Some(Ended::Blocked);
            }
            if world.press(key, newtons) {
                self.elapsed += RIGID_S;
            }
        }
        // The blade stays on the food as it sinks.
        let facing = self.legs[self.leg].to.rotation;
        if let Some(to) = on_top(world, key, facing) {
            self.legs[self.leg].to = to;
            self.pose = frame_pose(Frame::Pan, world).then(&to);
        }
        let done = self.legs[self.leg];
        if self.elapsed < end || world.is_pressing() { None } else { self.next_leg(&done, world) }
    }

    /// Returns true if its path presses food.
    fn presses(&self) -> bool {
        self.legs.iter().any(|leg| matches!(leg.act, Act::Press { .. }))
    }

    fn next_leg(&mut self, done: &Leg, world: &World) -> Option<Ended> {
        self.leg += 1;
        self.elapsed = 0.0;
        let Some(next) = self.legs.get(self.leg) else { return Some(Ended::Done) };
        let here = if done.frame == next.frame { None } else { Some(frame_pose(next.frame, world)) };
        self.from = here.map_or_else(
            || {
                let turned = done.turn != DVec3::ZERO;
                let rotation = if turned {
                    turn(done.turn.normalize(), done.turn.length()) * self.from.rotation
                } else {
                    done.to.rotation
                };
                Pose { position: done.to.position, rotation: rotation.normalize() }
            },
            |frame| self.pose.seen_from(&frame),
        );
        None
    }

    /// Keeps the tool above the pan's surface.
    fn keep_above_pan(&mut self, world: &World) {
        let pan = world.motion.pose;
        let mut p = pan.to_body(self.pose.position);
        if world.pan_shape().holds(p) {
            p.z = p.z.max(world.pan_shape().surface_height(libm::hypot(p.x, p.y)) + TOOL_CLEARANCE);
            self.pose.position = pan.to_world(p);
        }
    }

    /// Applies the grip's force and torque; returns true if the body has slipped off.
    fn pull(&mut self, world: &mut World) -> bool {
        let Some(grip) = &mut self.grip else { return false };
        let (Some(body), Some((velocity, turning))) = (world.pose(grip.key), world.velocity(grip.key)) else {
            self.grip = None;
            return true;
        };
        let wanted = self.pose.then(&grip.hold);
        let (off, twist) = (wanted.position - body.position, rotation_between(body.rotation, wanted.rotation));
        let far = off.length() > SLIP || twist.length() > SLIP_ANGLE;
        grip.slipping_s = if far { grip.slipping_s + RIGID_S } else { 0.0 };
        if grip.slipping_s > SLIP_S {
            self.grip = None;
            return true;
        }
        let [pull, spin] = grip.spring.pull(&wanted, &body, [velocity, turning]);
        let force = world.mass(grip.key) * (pull + DVec3::Z * GRAVITY);
        let torque = world.inertia_times(grip.key, spin);
        world.push(grip.key, force.clamp_length_max(GRIP_FORCE), torque.clamp_length_max(GRIP_TORQUE));
        false
    }

    /// Moves or pulls the blade to the turner's pose; tongs have no blade.
    pub(crate) fn place_blade(&mut self, world: &mut World) {
        if !self.leads_turner() {
            // A blade that presses touches its food alone, on which its force acts.
            let blade = (self.active && self.tool == Tool::Turner && !self.presses()).then_some(self.pose);
            return world.set_blade(blade.as_ref(), self.spared);
        }
        // Food on the blade carries it along.
        let lying = self.grip.and_then(|grip| Some(world.pose(grip.key)?.then(&Pose::default().seen_from(&grip.hold))));
        let wanted = lying.unwrap_or(self.pose);
        let spring = self.spring.get_or_insert(Spring::at(wanted));
        world.lead_blade(&wanted, spring, self.under.map(|under| under.key()));
    }
}

/// Height above the first leg at which a tool appears [m] (chosen).
const HOVER: f64 = 0.06;
/// Clearance between tool and pan [m] (chosen: a blade's thickness).
pub(super) const TOOL_CLEARANCE: f64 = 0.0015;
/// Largest speed [m/s] and angular velocity [rad/s] of a free tool (chosen).
const LEAD_SPEED: f64 = 1.0;
const LEAD_TURN: f64 = 10.0;

fn frame_pose(frame: Frame, world: &World) -> Pose {
    match frame {
        Frame::Pan => world.motion.pose,
        Frame::Kitchen => Pose::default(),
    }
}

fn place(leg: &Leg, world: &World) -> Pose {
    frame_pose(leg.frame, world).then(&leg.to)
}

/// Smoothstep 3s² − 2s³ [-].
fn smooth(s: f64) -> f64 {
    s * s * (3.0 - 2.0 * s)
}
