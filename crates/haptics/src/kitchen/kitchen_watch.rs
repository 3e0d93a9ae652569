//! Builds a contact model from the kitchen after every frame.

use std::collections::BTreeMap;

use glam::{DMat3, DVec3};
use saute_kitchen::dynamics::{Against, Pose, Tool};
pub use saute_kitchen::food::GRAVITY;
use saute_kitchen::{Kitchen, Piece, Place};

use crate::kitchen::contact_model::{ContactModel, IMPULSES, Impulse, PLANES, Payload, Plane, Rubbing};
use crate::wrench::{Twist, Wrench};

/// Speed relative to the pan below which food counts as at rest [m/s] (chosen: wet food sticks where it creeps).
const STILL: f64 = 0.03;
/// Impulse that counts as a collision, over the weight's impulse in a frame [-] (chosen: tossed food lands with ten).
const COLLISION: f64 = 3.0;
/// Distance from the floor at which a turner's edge scrapes [m] (chosen: its thickness and its clearance).
const SCRAPING: f64 = 0.004;
/// Normal force of a scraping turner [N] (chosen: its own weight and a light hand).
const TURNER_FORCE: f64 = 1.5;

/// Memory between two frames: velocities of the foods, and the latest collisions.
#[derive(Clone, Debug, Default)]
pub struct KitchenWatch {
    velocity: BTreeMap<u32, DVec3>,
    tip: Option<DVec3>,
    published: u64,
    collisions: u64,
    impulses: [Impulse; IMPULSES],
}

/// Sums over the foods.
#[derive(Default)]
struct Sum {
    payload: Payload,
    loose: Wrench,
    loose_weight: Wrench,
    sliding: Rubbing,
    vapour: f64,
}

/// One food relative to the pan.
struct RelativeFood {
    mass: f64,
    /// Position from the pan's origin, in the kitchen's axes [m].
    arm: DVec3,
    /// Velocity relative to the pan [m/s].
    past_pan: DVec3,
    /// Mean force on the pan since the last frame [N].
    force: DVec3,
}

impl RelativeFood {
    /// Its weight [N].
    fn weight(&self) -> DVec3 {
        DVec3::new(0.0, 0.0, -self.mass * GRAVITY)
    }
}

impl KitchenWatch {
    /// Returns the contact model of the present frame; `dt` is the time since the last one [s].
    pub fn look(&mut self, kitchen: &Kitchen, dt: f64) -> ContactModel {
        let motion = kitchen.world().motion;
        let twist = Twist { linear: motion.velocity, angular: motion.turning };
        let mut sum = Sum::default();
        for piece in kitchen.pieces() {
            self.add_food(kitchen, piece, &twist, dt, &mut sum);
        }
        self.velocity.retain(|key, _| kitchen.pieces().iter().any(|p| p.key == *key));
        self.published += 1;
        ContactModel {
            number: self.published,
            pan: motion.pose,
            payload: sum.payload.with(&liquids(kitchen)),
            own: pan_itself(kitchen),
            loose: sum.loose,
            loose_weight: sum.loose_weight,
            impulses: self.impulses,
            planes: walls(kitchen),
            vapour: sum.vapour + kitchen.other_vapour().0,
            sliding: sum.sliding,
            scraping: self.scraping(kitchen, &twist, dt),
        }
    }

    /// Clears the velocities, for a change to another kitchen.
    pub fn forget(&mut self) {
        self.velocity.clear();
        self.tip = None;
    }

    fn add_food(&mut self, kitchen: &Kitchen, piece: &Piece, twist: &Twist, dt: f64, sum: &mut Sum) {
        let Some((velocity, _)) = kitchen.world().velocity(piece.key) else { return };
        let before = self.velocity.insert(piece.key, velocity).unwrap_or(velocity);
        if !matches!(piece.place, Place::Pan(_)) || kitchen.hand().gripped() == Some(piece.key) {
            return;
        }
        let contacts = kitchen.world().contacts(piece.key);
        let [touches, on_blade] =
            [false, true].map(|blade| contacts.iter().any(|c| c.force > 0.0 && (c.against == Against::Blade) == blade));
        sum.vapour += piece.vapour_flow;
        if on_blade && !touches {
            return;
        }
        let (mass, pan) = (piece.mass(), kitchen.world().motion.pose);
        let arm = piece.pose.position - pan.position;
        let force = (before - velocity) * (mass / dt.max(1e-6)) - DVec3::Z * (mass * GRAVITY);
        let food = RelativeFood { mass, arm, past_pan: velocity - twist.at(arm), force };
        // A blow may be over when the frame ends: food that bounced off touches nothing by then.
        let struck = self.strikes(&food, &pan, dt);
        if !touches {
            return;
        }
        if food.past_pan.length() < STILL {
            sum.payload = sum.payload.with(&at_rest(kitchen, piece, &pan, mass));
        } else {
            add_moving(&food, struck, &pan, sum);
        }
    }

    /// Notes a collision of food with the pan, soft food that stays where it lands included; returns true if there was one.
    fn strikes(&mut self, food: &RelativeFood, pan: &Pose, dt: f64) -> bool {
        let impulse = (food.force - food.weight()) * dt;
        let struck = impulse.length() > COLLISION * food.mass * GRAVITY * dt;
        if struck {
            self.add_collision(food, pan, impulse);
        }
        struck
    }

    fn add_collision(&mut self, food: &RelativeFood, pan: &Pose, impulse: DVec3) {
        self.collisions += 1;
        let slot = (self.collisions - 1) as usize % IMPULSES;
        // The impulse stops the food: J = m v, so its kinetic energy was J²/(2m).
        let energy = impulse.length_squared() / (2.0 * food.mass);
        let at = pan.rotation.conjugate() * food.arm;
        self.impulses[slot] = Impulse { number: self.collisions, impulse, at, energy };
    }

    fn scraping(&mut self, kitchen: &Kitchen, twist: &Twist, dt: f64) -> Rubbing {
        let (hand, world) = (kitchen.hand(), kitchen.world());
        let tip = (hand.is_active() && hand.tool == Tool::Turner).then_some(hand.pose.position);
        let before = std::mem::replace(&mut self.tip, tip);
        let (Some(tip), Some(before)) = (tip, before) else { return Rubbing::default() };
        let pan = world.motion.pose;
        let over = world.pan_shape().over(pan.to_body(tip));
        if !over.is_some_and(|o| o.gap < SCRAPING) || dt <= 0.0 {
            return Rubbing::default();
        }
        let speed = ((tip - before) / dt - twist.at(tip - pan.position)).length();
        Rubbing { speed, force: TURNER_FORCE + world.blade_force() }
    }
}

/// Adds food that slides or has just struck the pan.
fn add_moving(food: &RelativeFood, struck: bool, pan: &Pose, sum: &mut Sum) {
    if !struck {
        sum.loose += Wrench::at(food.force - food.weight(), food.arm);
    }
    sum.loose_weight += Wrench::at(food.weight(), food.arm);
    let up = pan.rotation * DVec3::Z;
    let normal = -food.force.dot(up);
    let speed = (food.past_pan - up * food.past_pan.dot(up)).length();
    sum.sliding.speed = sum.sliding.speed.max(speed);
    sum.sliding.force += normal.clamp(0.0, 4.0 * food.mass * GRAVITY);
}

/// Returns food at rest as a mass that moves with the pan.
fn at_rest(kitchen: &Kitchen, piece: &Piece, pan: &Pose, mass: f64) -> Payload {
    let seen = piece.pose.seen_from(pan);
    let back = pan.rotation.conjugate();
    let column = |axis: DVec3| back * kitchen.world().inertia_times(piece.key, pan.rotation * axis);
    Payload {
        mass,
        centre: seen.position,
        inertia: DMat3::from_cols(column(DVec3::X), column(DVec3::Y), column(DVec3::Z)),
    }
}

/// Returns oil and water as point masses where they are.
fn liquids(kitchen: &Kitchen) -> Payload {
    let (bed, state) = (&kitchen.pan_model().liquids.bed, &kitchen.pan_state().liquids);
    let at = |i: usize| state.oil.mass[i] + state.water.mass[i];
    let whole: f64 = (0..bed.places.len()).map(at).sum();
    if whole <= 0.0 {
        return Payload::default();
    }
    let point = |i: usize| Payload::point(at(i), DVec3::from_array(bed.places[i]));
    (0..bed.places.len()).filter(|i| at(*i) > 0.0).fold(Payload::default(), |sum, i| sum.with(&point(i)))
}

/// Returns the pan as a disc and a cone of sheet metal, without its handle.
fn pan_itself(kitchen: &Kitchen) -> Payload {
    use std::f64::consts::PI;
    let pan = &kitchen.pan_model().description;
    let shape = kitchen.world().pan_shape();
    let slant = libm::hypot(shape.rim - shape.floor, shape.height);
    let floor = pan.metal.density_kg_m3 * PI * shape.floor * shape.floor * shape.thickness;
    let wall = pan.metal.density_kg_m3 * PI * (shape.floor + shape.rim) * slant * pan.wall.thickness_mm * 1e-3;
    let round = |mass: f64, square: f64, flat: f64| DMat3::from_diagonal(DVec3::new(flat, flat, 1.0) * (mass * square));
    let middle = 0.5 * (shape.floor + shape.rim);
    let disc =
        Payload { mass: floor, centre: DVec3::ZERO, inertia: round(floor, 0.5 * shape.floor * shape.floor, 0.5) };
    let cone =
        Payload { mass: wall, centre: DVec3::Z * (0.5 * shape.height), inertia: round(wall, middle * middle, 0.5) };
    disc.with(&cone)
}

/// Returns the hob's glass as a wall under the pan's edge.
fn walls(kitchen: &Kitchen) -> [Plane; PLANES] {
    let shape = kitchen.world().pan_shape();
    let mut planes = [Plane::default(); PLANES];
    planes[0] = Plane { normal: DVec3::Z, at_least: 0.0, edge_radius: shape.floor, below: shape.thickness };
    planes
}
