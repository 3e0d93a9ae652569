//! Tasks of the second hand and the paths of its tools.

use core::f64::consts::PI;

use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::extent::{radius, reach};
use super::hand::{Act, Frame, Leg, Tool};
use super::pose::{Pose, turn};
use super::press_path::press;
use super::world::{BOARD_AT, World};

/// A task with one body.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub enum Task {
    /// Turns it over about its long axis at its place.
    Flip {
        /// Key of the body.
        key: u32,
    },
    /// Carries it to a place in the pan.
    Move {
        /// Key of the body.
        key: u32,
        /// Target of its centre relative to the pan's centre [m].
        to: [f64; 2],
    },
    /// Carries it out of the pan.
    TakeOut {
        /// Key of the body.
        key: u32,
        /// Target of its centre on the board, in the kitchen [m].
        to: [f64; 2],
    },
    /// Puts it into the pan from any place.
    PutBack {
        /// Key of the body.
        key: u32,
        /// Target of its centre relative to the pan's centre [m].
        to: [f64; 2],
    },
    /// Presses it onto the pan.
    Press {
        /// Key of the body.
        key: u32,
        /// Force [N].
        newtons: f64,
        /// Duration [s].
        for_s: f64,
    },
}

/// Height above the table at which food is carried [m] (chosen: over the pan's rim).
const CARRY: f64 = 0.12;
/// Largest radius of a piece that is turned with tongs [m] (chosen: a blade would catch its neighbours).
const SMALL: f64 = 0.045;
/// Height at which a tool releases food [m] (chosen: a millimetre).
const DROP: f64 = 0.001;

impl Task {
    /// Key of its body.
    pub fn key(&self) -> u32 {
        match *self {
            Self::Flip { key }
            | Self::Move { key, .. }
            | Self::TakeOut { key, .. }
            | Self::PutBack { key, .. }
            | Self::Press { key, .. } => key,
        }
    }

    /// Its tool: the turner for pieces as large as its blade, tongs for small pieces.
    pub fn tool(&self, world: &World) -> Tool {
        let large = world.solid(self.key()).is_some_and(|s| radius(s) > SMALL);
        match self {
            Self::Flip { .. } if large => Tool::Turner,
            Self::Press { .. } => Tool::Turner,
            _ => Tool::Tongs,
        }
    }

    /// Path of the tool; empty if the body does not exist.
    pub fn legs(&self, world: &World) -> Vec<Leg> {
        let key = self.key();
        let Some(at) = world.pose(key) else { return Vec::new() };
        match *self {
            Self::Flip { .. } => flip(world, key, &at),
            Self::Move { to, .. } | Self::PutBack { to, .. } => {
                let low = world.motion.pose.to_world(DVec3::new(to[0], to[1], 0.0));
                carry(world, key, &at, low, matches!(self, Self::Move { .. }))
            }
            Self::TakeOut { to, .. } => carry(world, key, &at, DVec3::new(to[0], to[1], 2.0 * BOARD_AT.z), false),
            Self::Press { newtons, for_s, .. } => press(world, key, newtons, for_s),
        }
    }
}

pub(super) fn leg(frame: Frame, to: Pose, for_s: f64, act: Act) -> Leg {
    Leg { frame, to, turn: DVec3::ZERO, for_s, act }
}

/// Reach of a body along a direction of the kitchen [m].
pub(super) fn reach_of(world: &World, key: u32, at: &Pose, along: DVec3) -> f64 {
    world.solid(key).map_or(0.0, |s| reach(s, at.rotation.conjugate() * along))
}

/// Under it along its long axis, up, over, down, away; all in the pan's frame.
fn flip(world: &World, key: u32, at: &Pose) -> Vec<Leg> {
    let pan = world.motion.pose;
    let body = at.seen_from(&pan);
    let long = body.rotation * DVec3::X;
    let flat = DVec3::new(long.x, long.y, 0.0);
    let mut along = if flat.length() > 0.2 { flat.normalize() } else { DVec3::X };
    // The tool approaches from the side with more room.
    if (body.position - along).truncate().length() > (body.position + along).truncate().length() {
        along = -along;
    }
    let across = DVec3::new(-along.y, along.x, 0.0);
    let side = |d: DVec3| reach_of(world, key, at, pan.rotation * d);
    let (below, length) = (side(-DVec3::Z), side(-along));
    let width = side(across).max(side(-across)).max(side(DVec3::Z));
    let facing = turn(DVec3::Z, libm::atan2(along.y, along.x));
    let blade = |p: DVec3| Pose { position: p, rotation: facing };
    let under = DVec3::new(body.position.x, body.position.y, body.position.z - below);
    let outside = under - along * (length + 0.05);
    let lift = DVec3::Z * (width + 0.012 - below).max(0.02);
    let over =
        Leg { turn: along * PI, ..leg(Frame::Pan, blade(under + lift + DVec3::Z * (2.0 * below)), 0.22, Act::Pass) };
    // After the turn about its path the blade lies on top, as high above the centre as it was below.
    let flipped = Pose { position: DVec3::ZERO, rotation: (turn(along, PI) * facing).normalize() };
    let on_top = |p: DVec3| Pose { position: p, ..flipped };
    let above = side(DVec3::Z);
    let landed = DVec3::new(under.x, under.y, under.z + above + below + DROP);
    vec![
        leg(Frame::Pan, blade(outside), 0.10, Act::Pass),
        leg(Frame::Pan, blade(under), 0.12, Act::Grip(key)),
        leg(Frame::Pan, blade(under + lift), 0.14, Act::Pass),
        over,
        leg(Frame::Pan, on_top(landed), 0.15, Act::Release),
        leg(Frame::Pan, on_top(landed + DVec3::Z * 0.05), 0.10, Act::Pass),
    ]
}

/// Up, across and down; `low` is the point of the target surface. Within the pan the lift only clears other pieces.
fn carry(world: &World, key: u32, at: &Pose, low: DVec3, within: bool) -> Vec<Leg> {
    let (above, below) = (reach_of(world, key, at, DVec3::Z), reach_of(world, key, at, -DVec3::Z));
    let tip = DVec3::Z * (0.5 * above);
    let up = if within { at.position.z + 0.03 } else { at.position.z.max(CARRY) };
    let pick = Pose { position: at.position + tip, ..Pose::default() };
    let lifted = Pose { position: DVec3::new(at.position.x, at.position.y, up) + tip, ..Pose::default() };
    let over = Pose { position: DVec3::new(low.x, low.y, up) + tip, ..Pose::default() };
    let laid = Pose { position: low + DVec3::Z * (below + DROP) + tip, ..Pose::default() };
    let away = (over.position - lifted.position).length();
    let kitchen = |to, for_s, act| leg(Frame::Kitchen, to, for_s, act);
    vec![
        kitchen(pick, 0.20, Act::Grip(key)),
        kitchen(lifted, if within { 0.15 } else { 0.25 }, Act::Pass),
        kitchen(over, (away / 0.8).max(0.1), Act::Pass),
        kitchen(laid, if within { 0.15 } else { 0.25 }, Act::Release),
        kitchen(Pose { position: laid.position + DVec3::Z * 0.05, ..laid }, 0.1, Act::Pass),
    ]
}
