//! The rigid-body world: pan, table, board, foods, and its time step.

use std::collections::BTreeMap;

use glam::DVec3;
use rapier3d::dynamics::{CoefficientCombineRule, IslandManager, RigidBody, RigidBodyBuilder, RigidBodySet};
use rapier3d::geometry::{
    BroadPhaseBvh, Collider, ColliderBuilder, ColliderHandle, ColliderSet, Group, InteractionGroups,
    InteractionTestMode, NarrowPhase,
};
use rapier3d::math::Vector;
use saute_food::{GRAVITY, Solid};
use serde::{Deserialize, Serialize};

use super::blade::insert_blade;
use super::damping::damping;
use super::engine::Engine;
use super::pan_motion::{PanMotion, PanTarget};
use super::pan_shape::PanShape;
use super::pose::Pose;
use super::rigid_state::{FoodBody, RigidState};
use super::{scale, solid_shape};

/// Rigid steps per second [1/s] (chosen: at 240 Hz 35 shaken shrimps penetrate each other by less than 0.5 mm).
pub const RIGID_HZ: u32 = 240;
/// Length of one rigid step [s].
pub const RIGID_S: f64 = 1.0 / RIGID_HZ as f64;
/// Relative change of mass that updates the rigid body [-] (chosen: below what motion shows).
const NEW_MASS: f64 = 0.01;

/// Speed below which a body may sleep [sizes of a typical body/s] (chosen: 1 cm/s; wet food sticks when it creeps).
const RESTING: f32 = 0.5;

const FOOD_INSIDE: Group = Group::GROUP_1;
const FOOD_OUTSIDE: Group = Group::GROUP_2;
const PAN_FLOOR: Group = Group::GROUP_3;
const KITCHEN: Group = Group::GROUP_4;
pub(super) const BLADE: Group = Group::GROUP_5;
/// Foods inside and outside the pan.
pub(super) const FOODS: Group = Group::GROUP_1.union(Group::GROUP_2);

/// Counterpart of a contact.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, PartialOrd, Ord, Serialize)]
pub enum Against {
    /// The pan's floor.
    Floor,
    /// The pan's wall.
    Wall,
    /// The hob's glass or the table.
    Ground,
    /// The board.
    Board,
    /// The turner's blade.
    Blade,
    /// Another piece, by its key.
    Piece(u32),
}

impl Against {
    fn code(self) -> u128 {
        match self {
            Self::Floor => 1,
            Self::Wall => 2,
            Self::Ground => 3,
            Self::Board => 4,
            Self::Blade => 5,
            Self::Piece(key) => 16 + u128::from(key),
        }
    }

    fn decode(code: u128) -> Self {
        match code {
            1 => Self::Floor,
            2 => Self::Wall,
            3 => Self::Ground,
            4 => Self::Board,
            5 => Self::Blade,
            piece => Self::Piece(piece.saturating_sub(16) as u32),
        }
    }
}

/// One contact of a piece.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct Contact {
    /// Counterpart.
    pub against: Against,
    /// Normal force [N].
    pub force: f64,
}

/// Centre of the board on which food rests [m] (chosen: next to the hob, within view).
pub const BOARD_AT: DVec3 = DVec3::new(0.335, 0.03, 0.008);
/// Half extents of the board [m] (chosen: an ordinary board).
pub const BOARD_HALF: DVec3 = DVec3::new(0.13, 0.18, 0.008);
/// Half the side length of the hob's glass [m] (chosen: one zone with its frame).
pub const GLASS_HALF: f64 = 0.2;

/// All rigid bodies.
pub struct World {
    pub(super) engine: Engine,
    pub(super) shape: PanShape,
    pub(super) rigid: RigidState,
    /// Motion of the pan.
    pub motion: PanMotion,
    pub(super) may_sleep: bool,
    pub(super) settled: bool,
}

impl Clone for World {
    fn clone(&self) -> Self {
        Self { engine: Engine::new(), rigid: self.rigid.clone(), ..*self }
    }
}

impl core::fmt::Debug for World {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("World").field("motion", &self.motion).field("foods", &self.rigid.foods).finish_non_exhaustive()
    }
}

impl World {
    /// A world with a pan on its ring, a table and a board, without food.
    pub fn new(shape: PanShape) -> Self {
        let mut bodies = RigidBodySet::new();
        let mut colliders = ColliderSet::new();
        let motion = PanMotion::standing(Pose::at(0.0, 0.0, shape.thickness));
        let pan =
            bodies.insert(RigidBodyBuilder::kinematic_position_based().pose(scale::solver_pose(&motion.pose)).build());
        let floor = met_by(shape.floor_collider(), PAN_FLOOR, FOOD_INSIDE, Against::Floor);
        colliders.insert_with_parent(floor, pan, &mut bodies);
        for wedge in shape.wall_colliders() {
            let wedge = met_by(wedge, KITCHEN, FOOD_INSIDE | FOOD_OUTSIDE, Against::Wall);
            colliders.insert_with_parent(wedge, pan, &mut bodies);
        }
        let table = ColliderBuilder::new(rapier3d::geometry::SharedShape::halfspace(Vector::Z));
        colliders.insert(met_by(table, KITCHEN, FOOD_OUTSIDE, Against::Ground));
        let half = scale::vector(BOARD_HALF);
        let board = ColliderBuilder::cuboid(half.x, half.y, half.z).translation(scale::vector(BOARD_AT));
        colliders.insert(met_by(board, KITCHEN, FOOD_OUTSIDE, Against::Board));
        let blade = insert_blade(&mut bodies, &mut colliders);
        let rigid = RigidState {
            islands: IslandManager::new(),
            broad_phase: BroadPhaseBvh::new(),
            narrow_phase: NarrowPhase::new(),
            bodies,
            colliders,
            pan,
            blade,
            spared: None,
            foods: BTreeMap::new(),
            press: None,
        };
        Self { engine: Engine::new(), shape, rigid, motion, may_sleep: true, settled: false }
    }

    /// The pan's surface.
    pub fn pan_shape(&self) -> &PanShape {
        &self.shape
    }

    /// Enables or disables sleeping of bodies at rest, and wakes all; it is enabled by default.
    pub fn set_sleeping(&mut self, may_sleep: bool) {
        self.may_sleep = may_sleep;
        for food in self.rigid.foods.values() {
            set_sleep(&mut self.rigid.bodies[food.body], may_sleep);
        }
        self.stir();
    }

    /// Adds a body at rest.
    pub fn add(&mut self, key: u32, solid: Solid, mass: f64, pose: &Pose) {
        let inside = self.shape.holds(self.motion.pose.to_body(pose.position));
        let mut body = RigidBodyBuilder::dynamic().pose(scale::solver_pose(pose)).ccd_enabled(true).build();
        set_sleep(&mut body, self.may_sleep);
        let body = self.rigid.bodies.insert(body);
        let mut food = FoodBody { body, colliders: Vec::new(), solid, mass: 0.0, friction: DEFAULT_FRICTION, inside };
        for (place, shape) in solid_shape::shapes(&food.solid) {
            let collider = ColliderBuilder::new(shape)
                .position(place)
                .friction(food.friction as f32)
                .friction_combine_rule(CoefficientCombineRule::Min)
                .restitution(RESTITUTION)
                .user_data(Against::Piece(key).code());
            food.colliders.push(self.rigid.colliders.insert_with_parent(collider, body, &mut self.rigid.bodies));
        }
        self.rigid.foods.insert(key, food);
        self.set_groups(key, inside);
        self.set_mass(key, mass);
        self.stir();
    }

    /// Removes a body.
    pub fn remove(&mut self, key: u32) {
        if let Some(food) = self.rigid.foods.remove(&key) {
            let RigidState { islands, bodies, colliders, .. } = &mut self.rigid;
            let Engine { joints, multibody_joints, soft_bodies, .. } = &mut self.engine;
            bodies.remove(food.body, islands, colliders, joints, multibody_joints, soft_bodies, true);
            self.stir();
        }
    }

    /// Sets the mass of a body [kg]; changes below one per cent are ignored.
    pub fn set_mass(&mut self, key: u32, mass: f64) {
        let Some(food) = self.rigid.foods.get_mut(&key) else { return };
        if (mass / food.mass.max(1e-9) - 1.0).abs() < NEW_MASS {
            return;
        }
        food.mass = mass;
        let volume: f32 = food.colliders.iter().map(|c| self.rigid.colliders[*c].volume()).sum();
        let density = (mass * scale::PER_KILOGRAM) as f32 / volume;
        for collider in &food.colliders {
            if let Some(collider) = self.rigid.colliders.get_mut(*collider) {
                collider.set_density(density);
            }
        }
    }

    /// Sets the friction coefficient of a body [-]; a contact uses the smaller one of its two.
    pub fn set_friction(&mut self, key: u32, friction: f64) {
        let Some(food) = self.rigid.foods.get_mut(&key) else { return };
        if (friction - food.friction).abs() < 0.01 {
            return;
        }
        food.friction = friction;
        for collider in &food.colliders {
            if let Some(collider) = self.rigid.colliders.get_mut(*collider) {
                collider.set_friction(friction as f32);
            }
        }
    }

    /// Sets the collision shape of a body; changes up to `tolerance` [m] are ignored.
    pub fn set_solid(&mut self, key: u32, solid: Solid, tolerance: f64) {
        let Some(food) = self.rigid.foods.get_mut(&key) else { return };
        if food.solid.is_near(&solid, tolerance) {
            return;
        }
        for (collider, (_, shape)) in food.colliders.iter().zip(solid_shape::shapes(&solid)) {
            if let Some(collider) = self.rigid.colliders.get_mut(*collider) {
                collider.set_shape(shape);
            }
        }
        food.solid = solid;
        self.stir();
    }

    /// Collision shape of a body.
    pub fn solid(&self, key: u32) -> Option<&Solid> {
        self.rigid.foods.get(&key).map(|f| &f.solid)
    }

    /// Keys of all bodies.
    pub fn keys(&self) -> impl Iterator<Item = u32> + '_ {
        self.rigid.foods.keys().copied()
    }

    fn body(&self, key: u32) -> Option<&RigidBody> {
        self.rigid.foods.get(&key).and_then(|f| self.rigid.bodies.get(f.body))
    }

    pub(super) fn food_body_mut(&mut self, key: u32) -> Option<&mut RigidBody> {
        self.rigid.foods.get(&key).and_then(|f| self.rigid.bodies.get_mut(f.body))
    }

    /// Pose of a body.
    pub fn pose(&self, key: u32) -> Option<Pose> {
        self.body(key).map(|b| scale::pose(b.position()))
    }

    /// Velocity [m/s] and angular velocity [rad/s] of a body.
    pub fn velocity(&self, key: u32) -> Option<(DVec3, DVec3)> {
        self.body(key).map(|b| (scale::metres(b.linvel()), scale::metres(b.angvel()) * scale::PER_METRE))
    }

    /// Inertia tensor of a body [kg·m²] times an angular vector.
    pub fn inertia_times(&self, key: u32, turning: DVec3) -> DVec3 {
        let Some(body) = self.body(key) else { return DVec3::ZERO };
        let local = &body.mass_properties().local_mprops;
        let frame = body.position().rotation * local.principal_inertia_local_frame;
        let inertia = local.principal_inertia();
        let within = frame.inverse() * scale::plain(turning);
        let out = frame * (within * inertia);
        scale::metres(out) * scale::PER_METRE / (scale::PER_KILOGRAM * scale::PER_METRE * scale::PER_METRE)
    }

    /// Applies a force [N] and a torque [N·m] to a body during the next step.
    pub fn push(&mut self, key: u32, force: DVec3, torque: DVec3) {
        let Some(body) = self.food_body_mut(key) else { return };
        body.add_force(scale::force(force), true);
        body.add_torque(scale::torque(torque), true);
        self.settled = false;
    }

    /// Mass of a body [kg].
    pub fn mass(&self, key: u32) -> f64 {
        self.rigid.foods.get(&key).map_or(0.0, |f| f.mass)
    }

    /// Present contacts of a body, sorted by counterpart.
    pub fn contacts(&self, key: u32) -> Vec<Contact> {
        let mut found: BTreeMap<Against, f64> = BTreeMap::new();
        let Some(food) = self.rigid.foods.get(&key) else { return Vec::new() };
        for own in &food.colliders {
            for pair in self.rigid.narrow_phase.contact_pairs_with(*own).filter(|p| p.has_any_active_contact()) {
                let other = if pair.collider1 == *own { pair.collider2 } else { pair.collider1 };
                let Some(other) = self.rigid.colliders.get(other).filter(|o| o.user_data != Against::Piece(key).code())
                else {
                    continue;
                };
                let force = newtons(pair.total_impulse_magnitude());
                *found.entry(Against::decode(other.user_data)).or_default() += force;
            }
        }
        found.into_iter().map(|(against, force)| Contact { against, force }).collect()
    }

    /// Deepest penetration between any two bodies, the pan included [m].
    pub fn deepest_overlap(&self) -> f64 {
        let apart = |a: &Collider, b: &Collider| a.parent() != b.parent();
        let mut deepest = 0.0f32;
        for pair in self.rigid.narrow_phase.contact_pairs() {
            let (Some(a), Some(b)) =
                (self.rigid.colliders.get(pair.collider1), self.rigid.colliders.get(pair.collider2))
            else {
                continue;
            };
            if pair.has_any_active_contact() && apart(a, b) {
                let met = rapier3d::parry::query::contact(a.position(), a.shape(), b.position(), b.shape(), 0.0);
                deepest = met.ok().flatten().map_or(deepest, |c| deepest.max(-c.dist));
            }
        }
        f64::from(deepest) / scale::PER_METRE
    }

    /// Distance from a point to a body; 0 inside [m].
    pub fn distance(&self, key: u32, point: DVec3) -> f64 {
        let Some(food) = self.rigid.foods.get(&key) else { return f64::INFINITY };
        let to = |c: &ColliderHandle| {
            let collider = &self.rigid.colliders[*c];
            collider.shape().distance_to_point(collider.position(), scale::vector(point), true)
        };
        f64::from(food.colliders.iter().map(to).fold(f32::INFINITY, f32::min)) / scale::PER_METRE
    }

    /// Wakes all bodies.
    pub fn stir(&mut self) {
        self.settled = false;
        for food in self.rigid.foods.values() {
            if let Some(body) = self.rigid.bodies.get_mut(food.body) {
                body.wake_up(true);
            }
        }
    }

    /// Returns true if all bodies sleep, so that rigid steps are skipped.
    pub fn is_settled(&self) -> bool {
        self.settled
    }

    /// Advances the world by one rigid step of [`RIGID_S`]; the pan follows its target as a kinematic body.
    pub fn step(&mut self, target: &PanTarget) {
        let stood = self.motion.is_still();
        self.motion.follow(target, RIGID_S);
        if !self.motion.is_still() || !stood {
            if stood {
                self.stir();
            }
            self.settled = false;
            if let Some(pan) = self.rigid.bodies.get_mut(self.rigid.pan) {
                pan.set_next_kinematic_position(scale::solver_pose(&self.motion.pose));
            }
        }
        self.bear_down();
        if self.settled {
            return;
        }
        let gravity = scale::vector(DVec3::new(0.0, 0.0, -GRAVITY));
        let RigidState { islands, broad_phase, narrow_phase, bodies, colliders, .. } = &mut self.rigid;
        let Engine { pipeline, parameters, joints, multibody_joints, soft_bodies, ccd } = &mut self.engine;
        pipeline.step(
            gravity,
            parameters,
            islands,
            broad_phase,
            narrow_phase,
            bodies,
            colliders,
            joints,
            multibody_joints,
            soft_bodies,
            ccd,
            &(),
            &(),
        );
        self.after_step();
    }

    fn after_step(&mut self) {
        let mut asleep = true;
        let mut changed = Vec::new();
        for (key, food) in &self.rigid.foods {
            let on_table = !food.inside && self.lies_on_table(food);
            let Some(body) = self.rigid.bodies.get_mut(food.body) else { continue };
            body.reset_forces(false);
            body.reset_torques(false);
            asleep &= body.is_sleeping();
            let [linear, angular] = damping(body.linvel().length(), on_table);
            body.set_linear_damping(linear);
            body.set_angular_damping(angular);
            let inside = self.shape.holds(self.motion.pose.to_body(scale::metres(body.translation())));
            if inside != food.inside {
                changed.push((*key, inside));
            }
        }
        changed.into_iter().for_each(|(key, inside)| self.set_groups(key, inside));
        self.settled = asleep && self.may_sleep && self.motion.is_still();
    }

    fn lies_on_table(&self, food: &FoodBody) -> bool {
        let ground = Against::Ground.code();
        let is_ground = |other: ColliderHandle| self.rigid.colliders.get(other).is_some_and(|c| c.user_data == ground);
        food.colliders.iter().any(|own| {
            let mut pairs =
                self.rigid.narrow_phase.contact_pairs_with(*own).filter(|pair| pair.has_any_active_contact());
            pairs.any(|pair| is_ground(pair.collider1) || is_ground(pair.collider2))
        })
    }

    /// Sets the collision groups of a food: over the pan it collides with the floor, elsewhere with table and board.
    pub(super) fn set_groups(&mut self, key: u32, inside: bool) {
        let Some(food) = self.rigid.foods.get_mut(&key) else { return };
        food.inside = inside;
        let group = if inside { FOOD_INSIDE } else { FOOD_OUTSIDE };
        let meets = if self.rigid.spared == Some(key) { Group::ALL.difference(BLADE) } else { Group::ALL };
        for collider in &food.colliders {
            if let Some(collider) = self.rigid.colliders.get_mut(*collider) {
                collider.set_collision_groups(InteractionGroups::new(group, meets, InteractionTestMode::And));
            }
        }
    }
}

/// Friction coefficient of a body before its first update [-] (chosen).
const DEFAULT_FRICTION: f64 = 0.3;
/// Coefficient of restitution of food [-] (chosen: wet flesh hardly bounces).
const RESTITUTION: f32 = 0.05;
/// Mean force over one step of a solver impulse [N].
pub(super) fn newtons(impulse: f32) -> f64 {
    f64::from(impulse) / (RIGID_S * scale::PER_METRE * scale::PER_KILOGRAM)
}

pub(super) fn met_by(collider: ColliderBuilder, group: Group, by: Group, against: Against) -> Collider {
    collider
        .collision_groups(InteractionGroups::new(group, by, InteractionTestMode::And))
        .friction(1.0)
        .friction_combine_rule(CoefficientCombineRule::Min)
        .restitution(RESTITUTION)
        .user_data(against.code())
        .build()
}

fn set_sleep(body: &mut RigidBody, may_sleep: bool) {
    let activation = body.activation_mut();
    let default = rapier3d::dynamics::RigidBodyActivation::active();
    activation.normalized_linear_threshold = if may_sleep { RESTING } else { -1.0 };
    activation.angular_threshold = if may_sleep { default.angular_threshold } else { -1.0 };
}
