//! What a freely led turner does with food: it slides under what it meets low and level, takes it up as it rises, and
//! leaves it where it is laid or turned over. Held upright it pushes, lowered from above it presses: then food is in its way.

use glam::DVec3;

use super::blade::BLADE_HALF;
use super::hand::{Hand, TOOL_CLEARANCE, Tool};
use super::pose::Pose;
use super::world::{Against, BOARD_AT, BOARD_HALF, World};

/// Food that the blade is under.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Under {
    key: u32,
    /// Lowest height of the blade above pan, board or glass since it came there [m].
    least: f64,
}

impl Under {
    /// Which body it is.
    pub(super) fn key(&self) -> u32 {
        self.key
    }
}

/// Height up to which a blade slides under food [m], and how level it must be [-] (chosen: forgiving, 30°).
const LOW: f64 = 0.006;
const LEVEL: f64 = 0.87;
/// How near food is when the blade begins to slide under it [m] (chosen: more than a hand's fastest step).
const NEAR: f64 = 0.012;
/// How near to the blade food lies on it [m], and how far the blade rises before it takes it up [m] (chosen: a millimetre
/// or three).
const ON: f64 = 0.003;
const RISE: f64 = 0.003;
/// How far the blade is from where it took food up when it has laid it down, and how far food is held up by something
/// else then [m] (chosen: above what the spring gives).
const LAID: f64 = 0.001;
const HELD_UP: f64 = 0.002;
/// Uprightness up to which a blade counts as lying flat [-], and how far it tilts to clear a wall at once [rad] (chosen).
const FLAT: f64 = 0.7;
const STEEPEST: f64 = 0.5;
/// Uprightness of the blade below which food falls off it [-] (chosen: turned by 125°).
const TURNED: f64 = -0.57;
/// Uprightness above which it takes food up [-] (chosen: as long as it could lie on it).
const UPRIGHT: f64 = 0.3;

impl Hand {
    /// Whether it is a turner that a person leads.
    pub(super) fn leads_turner(&self) -> bool {
        self.is_active() && self.tool == Tool::Turner && self.is_free()
    }

    /// One rigid step of a turner that is led to a pose: slides under food, takes it up, leaves it.
    pub(crate) fn scoop(&mut self, to: &Pose, world: &World) {
        let Some(blade) = world.blade_pose() else { return };
        // A front edge that dips while the blade tilts over the wall lies no lower than one that lies on the floor.
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
                // A blade that only climbs the wall takes nothing up.
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

    /// Takes up food that lies on the blade, as it lay before the blade rose by so much; else it is in the way again.
    fn take_up(&mut self, key: u32, risen: f64, blade: &Pose, world: &World) {
        if lies_within(world, key, blade, ON - risen) && above(world, key, blade) {
            self.hold(key, &Pose { position: self.pose.position + DVec3::Z * risen, ..self.pose }, world);
        } else {
            self.under = None;
        }
    }

    /// The blade of a led turner does not go through pan, board and glass with any corner; a blade that lies flat tilts up
    /// along the wall.
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

/// The body beside or above the blade that it slides under: the nearest one.
fn beside(world: &World, blade: &Pose) -> Option<u32> {
    let near = world.keys().filter(|key| lies_within(world, *key, blade, NEAR) && above(world, *key, blade));
    near.min_by(|a, b| away(world, *a, blade).total_cmp(&away(world, *b, blade)))
}

/// Whether the middle of a body is above the blade's front edge.
fn above(world: &World, key: u32, blade: &Pose) -> bool {
    let front = blade.to_world(DVec3::X * BLADE_HALF.x);
    world.pose(key).is_some_and(|body| body.position.z > front.z)
}

fn lies_within(world: &World, key: u32, blade: &Pose, distance: f64) -> bool {
    away(world, key, blade) < distance
}

/// Distance of a body from the blade, measured at nine points of it [m].
fn away(world: &World, key: u32, blade: &Pose) -> f64 {
    let at = [-1.0, 0.0, 1.0];
    let points = at.into_iter().flat_map(|x| at.map(|y| DVec3::new(x * BLADE_HALF.x, y * BLADE_HALF.y, 0.0)));
    points.map(|p| world.distance(key, blade.to_world(p))).fold(f64::INFINITY, f64::min)
}

/// How far the blade's front (1) or rear (−1) edge must rise to be above pan, board and glass [m].
fn lift(world: &World, blade: &Pose, x: f64) -> f64 {
    let height = |y: f64| above_surface(world, blade.to_world(DVec3::new(x * BLADE_HALF.x, y * BLADE_HALF.y, 0.0)));
    (TOOL_CLEARANCE - height(-1.0).min(height(1.0))).max(0.0)
}

/// Height of the middle of the blade's front edge above pan, board or glass [m].
fn front_height(world: &World, blade: &Pose) -> f64 {
    above_surface(world, blade.to_world(DVec3::X * BLADE_HALF.x))
}

/// Height of a point above pan, board or glass; negative within them [m].
fn above_surface(world: &World, point: DVec3) -> f64 {
    let (pan, shape) = (world.motion.pose, world.pan_shape());
    let seen = pan.to_body(point);
    if shape.holds(seen) {
        return seen.z - shape.surface_height(libm::hypot(seen.x, seen.y));
    }
    let off = (point - BOARD_AT).abs();
    let on_board = off.x < BOARD_HALF.x && off.y < BOARD_HALF.y;
    point.z - if on_board { BOARD_AT.z + BOARD_HALF.z } else { 0.0 }
}
