//! The rigid-body world as data: bodies, contacts, sleep and the tables of both collision phases.
//!
//! The solver goes on exactly only with its own tables: the tree of the broad phase, contacts with their impulses, islands
//! and their order. The shape of the pan and the parameters follow from the pan and the program.

use std::borrow::Cow;
use std::collections::BTreeMap;

use rapier3d::dynamics::{
    CCDSolver, ImpulseJointSet, IslandManager, MultibodyJointSet, RigidBodyHandle, RigidBodySet, SoftBodySet,
};
use rapier3d::geometry::{BroadPhaseBvh, ColliderSet, NarrowPhase};
use rapier3d::pipeline::PhysicsPipeline;
use serde::{Deserialize, Serialize};

use super::pan_motion::PanMotion;
use super::pan_shape::PanShape;
use super::press::Press;
use super::world::{FoodBody, World, parameters};

/// What of a [`World`] does not follow from the pan.
#[derive(Deserialize, Serialize)]
pub(crate) struct SavedWorld<'a> {
    islands: Cow<'a, IslandManager>,
    broad_phase: Cow<'a, BroadPhaseBvh>,
    narrow_phase: Cow<'a, NarrowPhase>,
    bodies: Cow<'a, RigidBodySet>,
    colliders: Cow<'a, ColliderSet>,
    pan: RigidBodyHandle,
    blade: RigidBodyHandle,
    spared: Option<u32>,
    foods: Cow<'a, BTreeMap<u32, FoodBody>>,
    press: Cow<'a, Option<Press>>,
    motion: PanMotion,
    may_sleep: bool,
    settled: bool,
}

impl World {
    /// Returns what does not follow from the pan.
    pub(crate) fn saved(&self) -> SavedWorld<'_> {
        SavedWorld {
            islands: Cow::Borrowed(&self.islands),
            broad_phase: Cow::Borrowed(&self.broad_phase),
            narrow_phase: Cow::Borrowed(&self.narrow_phase),
            bodies: Cow::Borrowed(&self.bodies),
            colliders: Cow::Borrowed(&self.colliders),
            pan: self.pan,
            blade: self.blade,
            spared: self.spared,
            foods: Cow::Borrowed(&self.foods),
            press: Cow::Borrowed(&self.press),
            motion: self.motion,
            may_sleep: self.may_sleep,
            settled: self.settled,
        }
    }

    /// Returns the world again, around a pan; `None` if a body or a shape is missing.
    pub(crate) fn of_saved(saved: SavedWorld, shape: PanShape) -> Option<Self> {
        let world = Self {
            pipeline: PhysicsPipeline::new(),
            parameters: parameters(),
            islands: saved.islands.into_owned(),
            broad_phase: saved.broad_phase.into_owned(),
            narrow_phase: saved.narrow_phase.into_owned(),
            bodies: saved.bodies.into_owned(),
            colliders: saved.colliders.into_owned(),
            // There are no joints and no soft bodies.
            joints: ImpulseJointSet::new(),
            multibody_joints: MultibodyJointSet::new(),
            soft_bodies: SoftBodySet::new(),
            ccd: CCDSolver::new(),
            shape,
            pan: saved.pan,
            blade: saved.blade,
            spared: saved.spared,
            foods: saved.foods.into_owned(),
            press: saved.press.into_owned(),
            motion: saved.motion,
            may_sleep: saved.may_sleep,
            settled: saved.settled,
        };
        world.is_whole().then_some(world)
    }

    /// Returns true if every body and every shape that is named is there.
    fn is_whole(&self) -> bool {
        let has = |food: &FoodBody| {
            self.bodies.get(food.body).is_some() && food.colliders.iter().all(|c| self.colliders.get(*c).is_some())
        };
        [self.pan, self.blade].iter().all(|body| self.bodies.get(*body).is_some()) && self.foods.values().all(has)
    }
}
