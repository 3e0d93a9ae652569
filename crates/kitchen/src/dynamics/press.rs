//! A press: a body moves together with the heavy, yielding hand above it until the hand has lifted off.
//!
//! A force of 10 N on a carrot coin of 4 g alone would be 250 times its weight: within one step the coin would pass
//! through the floor, and the force that the floor answers would throw it out. A pressing hand does not do so, for it
//! moves only as fast as the arm behind it. So the pressed body takes on the hand's inertia and damping, pieces that it
//! touches take on the inertia that they must withstand, and the force rises and falls gradually.

use std::collections::BTreeSet;

use glam::DVec3;
use rapier3d::dynamics::MassProperties;
use rapier3d::math::Vector;
use serde::{Deserialize, Serialize};

use super::scale;
use super::world::{Against, RIGID_S, World};

/// Time over which the force rises and falls [s] (chosen: a hand puts its weight on a tool and takes it off).
const ONSET_S: f64 = 0.1;
/// Acceleration of the hand by its own force [m/s²] (chosen: 1 kg of hand and forearm at 10 N, more of the body behind
/// a stronger push).
const YIELD: f64 = 10.0;
/// Speed at which the hand follows food that gives way under the full force [m/s] (chosen: gentle).
const FOLLOW: f64 = 0.1;
/// Radius of gyration of the hand with the turner [m] (chosen: half the length of the blade).
const GYRATION: f64 = 0.045;

/// The press at work.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub(super) struct Press {
    key: u32,
    /// Full force [N].
    newtons: f64,
    /// Present share of the time of its onset [-].
    onset: f64,
    /// True if the hand has requested it in this step.
    asked: bool,
    /// Pieces that move with the hand: the pressed one and those that it touches, directly or through others.
    burdened: BTreeSet<u32>,
}

impl World {
    /// Presses a body onto the pan's floor during the next step; returns true at the full force [N].
    ///
    /// Without another call the force falls again over some steps.
    pub(super) fn press(&mut self, key: u32, newtons: f64) -> bool {
        if self.rigid.press.as_ref().is_some_and(|p| p.key != key || p.newtons != newtons) {
            self.end_press();
        }
        let begun = || Press { key, newtons, onset: 0.0, asked: true, burdened: BTreeSet::new() };
        let press = self.rigid.press.get_or_insert_with(begun);
        press.asked = true;
        press.onset >= 1.0
    }

    /// Force of the press on a body [N]; 0 without one.
    pub(crate) fn pressing(&self, key: u32) -> f64 {
        self.rigid.press.as_ref().filter(|press| press.key == key).map_or(0.0, |press| press.newtons * press.onset)
    }

    /// Returns true until the hand has lifted off.
    pub(super) fn is_pressing(&self) -> bool {
        self.rigid.press.is_some()
    }

    /// Applies force and damping of the press before a step; ends the press when its force has fallen.
    pub(super) fn bear_down(&mut self) {
        let Some(press) = &mut self.rigid.press else { return };
        let by = if core::mem::take(&mut press.asked) { RIGID_S } else { -RIGID_S } / ONSET_S;
        press.onset = (press.onset + by).clamp(0.0, 1.0);
        let (key, newtons, onset) = (press.key, press.newtons, press.onset);
        if onset <= 0.0 || newtons <= 0.0 || !self.rigid.foods.contains_key(&key) {
            if onset <= 0.0 {
                self.end_press();
            }
            return;
        }
        self.burden_touched(key, newtons / YIELD);
        let Some([moving, turning]) = self.slip(key) else { return };
        let damping = newtons / FOLLOW;
        let down = self.motion.pose.rotation * DVec3::NEG_Z;
        let force = down * (newtons * onset) - damping * moving;
        self.push(key, force, -damping * GYRATION * GYRATION * turning);
    }

    /// Velocity [m/s] and angular velocity [rad/s] of a body relative to the pan.
    fn slip(&self, key: u32) -> Option<[DVec3; 2]> {
        let ((velocity, turning), at) = (self.velocity(key)?, self.pose(key)?.position);
        let pan = &self.motion;
        let carried = pan.velocity + pan.turning.cross(at - pan.pose.position);
        Some([velocity - carried, turning - pan.turning])
    }

    /// Gives the hand's mass [kg] to a body and to those that it touches; a body once burdened stays so.
    fn burden_touched(&mut self, key: u32, mass: f64) {
        let mut open = vec![key];
        let mut seen = BTreeSet::from([key]);
        while let Some(key) = open.pop() {
            if self.rigid.press.as_mut().is_some_and(|p| p.burdened.insert(key)) {
                self.set_burden(key, Some(mass));
            }
            for contact in self.contacts(key) {
                if let Against::Piece(other) = contact.against
                    && seen.insert(other)
                {
                    open.push(other);
                }
            }
        }
    }

    /// Adds inertia of the hand [kg] to a body, or takes it off; its weight does not change.
    fn set_burden(&mut self, key: u32, mass: Option<f64>) {
        let own = self.mass(key);
        let Some(body) = self.food_body_mut(key) else { return };
        let centre = body.mass_properties().local_mprops.local_com;
        let mass = mass.unwrap_or(0.0);
        let inertia = mass * GYRATION * GYRATION * scale::PER_KILOGRAM * scale::PER_METRE * scale::PER_METRE;
        let added = MassProperties::new(centre, (mass * scale::PER_KILOGRAM) as f32, Vector::splat(inertia as f32));
        body.set_additional_mass_properties(added, true);
        body.set_gravity_scale((own / (own + mass)) as f32, true);
    }

    fn end_press(&mut self) {
        let Some(press) = self.rigid.press.take() else { return };
        press.burdened.into_iter().for_each(|key| self.set_burden(key, None));
    }
}
