//! Path of a pressing turner: where its blade comes down on a body, and which way it points.

use core::f64::consts::TAU;

use glam::{DQuat, DVec3};

use super::blade::BLADE_HALF;
use super::extent::radius;
use super::hand::{Act, Frame, Leg};
use super::pose::{Pose, turn};
use super::scoop::above_surface;
use super::task::{leg, reach_of};
use super::world::World;

/// Directions from which a blade can come [-] (chosen: every 45°).
const DIRECTIONS: u32 = 8;
/// Rise of the blade when it lifts off [m] (chosen).
const AWAY: f64 = 0.05;

/// Down onto the top of a body and up again, in the pan's frame; empty if the body does not exist.
pub(super) fn press(world: &World, key: u32, newtons: f64, for_s: f64) -> Vec<Leg> {
    let Some(down) = clear_place(world, key) else { return Vec::new() };
    let away = Pose { position: down.position + DVec3::Z * AWAY, ..down };
    vec![leg(Frame::Pan, down, 0.2, Act::Press { key, newtons, for_s }), leg(Frame::Pan, away, 0.12, Act::Pass)]
}

/// Pose of the blade on top of a body, in the pan's frame; on a small one its front, and the rest is clear of it.
pub(super) fn on_top(world: &World, key: u32, facing: DQuat) -> Option<Pose> {
    let back = BLADE_HALF.x - world.solid(key).map_or(BLADE_HALF.x, radius).min(BLADE_HALF.x);
    Some(Pose { position: top(world, key)? - facing * DVec3::X * back, rotation: facing })
}

/// Returns true if another body lies where the blade would press one.
pub(super) fn is_covered(world: &World, key: u32) -> bool {
    let Some(top) = top(world, key) else { return false };
    let place = world.motion.pose.to_world(top);
    world.keys().any(|other| other != key && world.distance(other, place) < BLADE_HALF.z)
}

/// The place on top of a body where the fewest parts of the blade meet other bodies or the wall.
fn clear_place(world: &World, key: u32) -> Option<Pose> {
    let facings = (0..DIRECTIONS).map(|i| turn(DVec3::Z, TAU * f64::from(i) / f64::from(DIRECTIONS)));
    let places = facings.filter_map(|facing| on_top(world, key, facing));
    places.min_by_key(|place| met(world, key, place))
}

/// Number of places on the blade that would be within other bodies or the pan [-].
fn met(world: &World, key: u32, place: &Pose) -> usize {
    let blade = world.motion.pose.then(place);
    let at = [-1.0, 0.0, 1.0];
    let points = at.into_iter().flat_map(|x| at.map(|y| DVec3::new(x * BLADE_HALF.x, y * BLADE_HALF.y, 0.0)));
    let within = |p: DVec3| {
        let near = |other: u32| other != key && world.distance(other, p) < BLADE_HALF.z;
        above_surface(world, p) < 0.0 || world.keys().any(near)
    };
    points.filter(|p| within(blade.to_world(*p))).count()
}

/// Centre of the blade's thickness over the middle of a body, in the pan's frame [m].
fn top(world: &World, key: u32) -> Option<DVec3> {
    let (pan, at) = (world.motion.pose, world.pose(key)?);
    let above = reach_of(world, key, &at, pan.rotation * DVec3::Z) + BLADE_HALF.z;
    Some(pan.to_body(at.position) + DVec3::Z * above)
}
