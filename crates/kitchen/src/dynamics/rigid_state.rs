//! The state of the rigid bodies, which is stored as it is.

use std::collections::BTreeMap;

use rapier3d::dynamics::{IslandManager, RigidBodyHandle, RigidBodySet};
use rapier3d::geometry::{BroadPhaseBvh, ColliderHandle, ColliderSet, NarrowPhase};
use saute_food::Solid;
use serde::{Deserialize, Serialize};

use super::press::Press;

/// The rigid body of a piece.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub(super) struct FoodBody {
    pub(super) body: RigidBodyHandle,
    pub(super) colliders: Vec<ColliderHandle>,
    pub(super) solid: Solid,
    pub(super) mass: f64,
    pub(super) friction: f64,
    pub(super) inside: bool,
}

/// Bodies, contacts, sleep and the tables of both collision phases. It is stored as it is: the solver goes on exactly only with its
/// own tables, that is the tree of the broad phase, contacts with their impulses, islands and their order.
#[derive(Clone, Deserialize, Serialize)]
pub(crate) struct RigidState {
    pub(super) islands: IslandManager,
    pub(super) broad_phase: BroadPhaseBvh,
    pub(super) narrow_phase: NarrowPhase,
    pub(super) bodies: RigidBodySet,
    pub(super) colliders: ColliderSet,
    pub(super) pan: RigidBodyHandle,
    pub(super) blade: RigidBodyHandle,
    pub(super) spared: Option<u32>,
    pub(super) foods: BTreeMap<u32, FoodBody>,
    pub(super) press: Option<Press>,
}

impl RigidState {
    /// Returns true if every body and every shape that is named is there.
    pub(super) fn is_whole(&self) -> bool {
        let has = |food: &FoodBody| {
            self.bodies.get(food.body).is_some() && food.colliders.iter().all(|c| self.colliders.get(*c).is_some())
        };
        [self.pan, self.blade].iter().all(|body| self.bodies.get(*body).is_some()) && self.foods.values().all(has)
    }
}
