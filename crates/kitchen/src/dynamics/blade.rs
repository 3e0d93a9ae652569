//! The turner's blade as a rigid body. In a task it is a kinematic body; moved by a person it is a dynamic body on a
//! spring–damper of bounded force, so obstacles stop it.

use glam::DVec3;
use rapier3d::dynamics::{MassProperties, RigidBodyBuilder, RigidBodyHandle, RigidBodySet, RigidBodyType};
use rapier3d::geometry::{ColliderBuilder, ColliderSet};
use rapier3d::math::Vector;

use super::pose::Pose;
use super::scale;
use super::spring::Spring;
use super::world::{Against, BLADE, FOODS, World, met_by, newtons};

/// Half extents of the turner's blade [m] (chosen: a fish slice).
pub const BLADE_HALF: DVec3 = DVec3::new(0.045, 0.04, 0.001);
/// Mass [kg] of a free turner and its moment of inertia with the hand [kg·m²] (chosen: a light tool that a wrist keeps
/// from turning).
const MASS: f64 = 0.12;
const INERTIA: f64 = 2.0e-3;
/// Largest force [N] and torque [N·m] on a free turner (chosen: equal to those of the grip).
const LEAD_FORCE: f64 = 12.0;
const LEAD_TORQUE: f64 = 1.5;

/// Inserts the blade as a disabled body.
pub(super) fn insert_blade(bodies: &mut RigidBodySet, colliders: &mut ColliderSet) -> RigidBodyHandle {
    let inertia = (INERTIA * scale::PER_KILOGRAM * scale::PER_METRE * scale::PER_METRE) as f32;
    let mass = MassProperties::new(Vector::ZERO, (MASS * scale::PER_KILOGRAM) as f32, Vector::splat(inertia));
    let body = RigidBodyBuilder::kinematic_position_based().additional_mass_properties(mass).gravity_scale(0.0);
    let blade = bodies.insert(body.can_sleep(false).enabled(false).build());
    let half = scale::vector(BLADE_HALF);
    let shape = ColliderBuilder::cuboid(half.x, half.y, half.z).density(0.0);
    colliders.insert_with_parent(met_by(shape, BLADE, FOODS, Against::Blade), blade, bodies);
    blade
}

impl World {
    /// Moves the blade as a kinematic body, or disables it; it does not collide with the body `spared`.
    pub fn set_blade(&mut self, pose: Option<&Pose>, spared: Option<u32>) {
        match pose {
            Some(pose) if self.show_blade(pose, RigidBodyType::KinematicPositionBased) => {
                if let Some(body) = self.rigid.bodies.get_mut(self.rigid.blade) {
                    body.set_next_kinematic_position(scale::solver_pose(pose));
                }
            }
            Some(_) => {}
            None => self.hide_blade(),
        }
        self.spare(spared);
    }

    /// Pulls the blade towards a pose during the next step; it does not collide with the body `spared`.
    pub fn lead_blade(&mut self, wanted: &Pose, spring: &mut Spring, spared: Option<u32>) {
        self.spare(spared);
        if !self.show_blade(wanted, RigidBodyType::Dynamic) {
            *spring = Spring::at(*wanted);
            return;
        }
        let Some(body) = self.rigid.bodies.get_mut(self.rigid.blade) else { return };
        let speeds = [scale::metres(body.linvel()), scale::metres(body.angvel()) * scale::PER_METRE];
        let [pull, spin] = spring.pull(wanted, &scale::pose(body.position()), speeds);
        body.reset_forces(true);
        body.reset_torques(true);
        body.add_force(scale::force((MASS * pull).clamp_length_max(LEAD_FORCE)), true);
        body.add_torque(scale::torque((INERTIA * spin).clamp_length_max(LEAD_TORQUE)), true);
    }

    /// Pose of the blade; `None` while no hand holds the turner.
    pub fn blade_pose(&self) -> Option<Pose> {
        self.rigid.bodies.get(self.rigid.blade).filter(|b| b.is_enabled()).map(|b| scale::pose(b.position()))
    }

    /// Sum of the contact forces of foods on the blade [N].
    pub fn blade_force(&self) -> f64 {
        let blade = self.rigid.bodies.get(self.rigid.blade).filter(|b| b.is_enabled());
        let colliders = blade.into_iter().flat_map(|b| b.colliders().iter());
        let pairs = colliders.flat_map(|c| self.rigid.narrow_phase.contact_pairs_with(*c));
        pairs.map(|p| newtons(p.total_impulse_magnitude())).sum()
    }

    /// Enables the blade as a body of the given type; returns true if it already was.
    fn show_blade(&mut self, pose: &Pose, driven: RigidBodyType) -> bool {
        self.settled = false;
        let Some(body) = self.rigid.bodies.get_mut(self.rigid.blade) else { return false };
        if body.is_enabled() && body.body_type() == driven {
            return true;
        }
        body.set_enabled(true);
        body.set_body_type(driven, true);
        body.set_position(scale::solver_pose(pose), true);
        body.set_linvel(Vector::ZERO, true);
        body.set_angvel(Vector::ZERO, true);
        false
    }

    fn hide_blade(&mut self) {
        if let Some(body) = self.rigid.bodies.get_mut(self.rigid.blade).filter(|b| b.is_enabled()) {
            body.set_enabled(false);
        }
    }

    fn spare(&mut self, spared: Option<u32>) {
        if spared != self.rigid.spared {
            let before = core::mem::replace(&mut self.rigid.spared, spared);
            for key in [before, spared].into_iter().flatten() {
                let inside = self.rigid.foods.get(&key).is_some_and(|f| f.inside);
                self.set_groups(key, inside);
            }
        }
    }
}
