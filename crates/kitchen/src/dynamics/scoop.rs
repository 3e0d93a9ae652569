//! A turner moved by a person: low and level it slides under food, lifts it as it rises, and releases it when laid down
//! or turned over. In any other attitude it collides with food: upright it pushes, from above it presses.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::blade::BLADE_HALF;
use super::hand::{Hand, TOOL_CLEARANCE, Tool};
use super::pose::Pose;
use super::world::{Against, BOARD_AT, BOARD_HALF, World};

/// Food above the blade.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub(super) struct Under {
    key: u32,
    /// Lowest height of the blade above pan, board or glass since it slid there [m].
    least: f64,
}

impl Under {
    /// Key of the body.
    pub(super) fn key(&self) -> u32 {
        self.key
    }
}

/// Largest height [m] and smallest uprightness [-] at which a blade slides under food (chosen: forgiving, 30°).
const LOW: f64 = 0.006;
const LEVEL: f64 = 0.87;
/// Distance at which the blade starts to slide under food [m] (chosen: above the largest step of a hand).
const NEAR: f64 = 0.012;
/// Largest distance of food that lies on the blade [m], and rise of the blade that lifts it [m] (chosen: 3 mm).
const ON: f64 = 0.003;
const RISE: f64 = 0.003;
/// Height of the blade over its lowest one at which food counts as laid down, and slack of the grip at which another body
/// supports the food [m] (chosen: above the spring's deflection).
const LAID: f64 = 0.001;
const HELD_UP: f64 = 0.002;
/// Uprightness above which a blade is flat [-], and its largest tilt in one step to clear a wall [rad] (chosen).
const FLAT: f64 = 0.7;
const STEEPEST: f64 = 0.5;
/// Uprightness below which food falls off the blade [-] (chosen: turned by 125°).
const TURNED: f64 = -0.57;
/// Uprightness above which the blade lifts food [-] (chosen: while food could lie on it).
const UPRIGHT: f64 = 0.3;

impl Hand {
    /// Returns true if it is a turner moved by a person.
    pub(super) fn leads_turner(&self) -> bool {
        self.is_active() && self.tool == Tool::Turner && self.is_free()
    }

    /// One rigid step of a free turner: slides under food, lifts it, releases it.
    pub(crate) fn scoop(&mut self, to: &Pose, world: &World) {
        let Some(blade) = world.blade_pose() else { return };
        // While the blade tilts over the wall its front edge dips; it counts as lying on the floor.
        let (up, height) = (self.pose.rotation * DVec3::Z, front_height(world, &self.pose).max(TOOL_CLEARANCE));
        match (self.gripped(), self.under) {
            (Some(key), _) => {
                let high = self.hanging_below(world).is_some_and(|low| low < -HELD_UP);
                let held_up = high && world.contacts(key).iter().any(|c| c.against != Against::Blade && c.force > 0.0);
                let back = self.under.is_none_or(|u| height < u.least + LAID);
                if up.z < TURNED || (up.z > LEVEL && (held_up || back)) {
                    self.release();
                    self.under = Some(Under { key, least: height });
                }
            }
            (None, Some(under)) if !lies_within(world, under.key, &blade, NEAR) => self.under = None,
            (None, Some(under)) => {
                let least = under.least.min(height);
                self.under = Some(Under { least, ..under });
                // A blade that only climbs the wall lifts no food.
                let rises = height.min(front_height(world, to)) > least + RISE;
                if rises && up.z > UPRIGHT {
                    self.take_up(under.key, least - height, &blade, world);
                }
            }
            (None, None) if up.z > LEVEL && height < LOW => {
                self.under = beside(world, &blade).map(|key| Under { key, least: height });
            }
            (None, None) => {}
        }
    }

    /// Grips food on the blade at the pose before the blade rose by `risen` [m]; other food collides with the blade again.
    fn take_up(&mut self, key: u32, risen: f64, blade: &Pose, world: &World) {
        if lies_within(world, key, blade, ON - risen) && above(world, key, blade) {
            self.hold(key, &Pose { position: self.pose.position + DVec3::Z * risen, ..self.pose }, world);
        } else {
            self.under = None;
        }
    }

    /// Keeps all corners of a free blade above pan, board and glass; a flat blade tilts up along the wall.
    pub(super) fn keep_blade_above(&mut self, world: &World) {
        let flat = (self.pose.rotation * DVec3::Z).z > FLAT;
        let [front, rear] = [1.0, -1.0].map(|x| lift(world, &self.pose, x));
        if flat && (rear > 0.0 || front > 0.0) {
            let across = self.pose.rotation * DVec3::Y;
            let angle = libm::atan2(rear - front, 2.0 * BLADE_HALF.x).clamp(-STEEPEST, STEEPEST);
            self.pose.position += DVec3::Z * (0.5 * (front + rear));
            self.pose = self.pose.turned(across, angle);
        }
        self.pose.position += DVec3::Z * lift(world, &self.pose, 1.0).max(lift(world, &self.pose, -1.0));
    }
}

/// The nearest body next to or above the blade, under which it slides.
fn beside(world: &World, blade: &Pose) -> Option<u32> {
    let near = world.keys().filter(|key| lies_within(world, *key, blade, NEAR) && above(world, *key, blade));
    near.min_by(|a, b| away(world, *a, blade).total_cmp(&away(world, *b, blade)))
}

/// Returns true if the centre of a body is above the blade's front edge.
fn above(world: &World, key: u32, blade: &Pose) -> bool {
    let front = blade.to_world(DVec3::X * BLADE_HALF.x);
    world.pose(key).is_some_and(|body| body.position.z > front.z)
}

fn lies_within(world: &World, key: u32, blade: &Pose, distance: f64) -> bool {
    away(world, key, blade) < distance
}

/// Distance of a body from nine points of the blade [m].
fn away(world: &World, key: u32, blade: &Pose) -> f64 {
    let at = [-1.0, 0.0, 1.0];
    let points = at.into_iter().flat_map(|x| at.map(|y| DVec3::new(x * BLADE_HALF.x, y * BLADE_HALF.y, 0.0)));
    points.map(|p| world.distance(key, blade.to_world(p))).fold(f64::INFINITY, f64::min)
}

/// Rise of the blade's front (1) or rear (−1) edge needed to clear pan, board and glass [m].
fn lift(world: &World, blade: &Pose, x: f64) -> f64 {
    let height = |y: f64| above_surface(world, blade.to_world(DVec3::new(x * BLADE_HALF.x, y * BLADE_HALF.y, 0.0)));
    (TOOL_CLEARANCE - height(-1.0).min(height(1.0))).max(0.0)
}

/// Height of the centre of the blade's front edge above pan, board or glass [m].
fn front_height(world: &World, blade: &Pose) -> f64 {
    above_surface(world, blade.to_world(DVec3::X * BLADE_HALF.x))
}

/// Height of a point above pan, board or glass; negative within them [m].
pub(super) fn above_surface(world: &World, point: DVec3) -> f64 {
    let (pan, shape) = (world.motion.pose, world.pan_shape());
    let seen = pan.to_body(point);
    if shape.holds(seen) {
        return seen.z - shape.surface_height(libm::hypot(seen.x, seen.y));
    }
    let off = (point - BOARD_AT).abs();
    let on_board = off.x < BOARD_HALF.x && off.y < BOARD_HALF.y;
    point.z - if on_board { BOARD_AT.z + BOARD_HALF.z } else { 0.0 }
}
