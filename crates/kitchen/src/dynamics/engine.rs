//! The solver of rigid bodies without their state.

use rapier3d::dynamics::{CCDSolver, ImpulseJointSet, IntegrationParameters, MultibodyJointSet, SoftBodySet};
use rapier3d::pipeline::PhysicsPipeline;

use super::world::RIGID_S;

/// Size of a typical body, which scales the solver's tolerances [solver units] (chosen: 2 cm).
const TYPICAL: f32 = 2.0;
/// Natural frequency [Hz] and damping ratio [-] of contacts (chosen: 0.1 mm of penetration at rest, no
/// oscillation at this step).
const CONTACT_HZ: f32 = 230.0;
const CONTACT_DAMPING: f32 = 4.0;
/// Solver iterations [-] (chosen: a pile of 35 shrimps comes to rest, and penetrates by 0.3 mm when shaken).
const ITERATIONS: usize = 2;
/// Stabilisation iterations per solver iteration [-] (chosen: with fewer, coins leaning on each other rattle).
const RELAXATIONS: usize = 2;
/// Prediction distance of contacts [TYPICAL] (chosen: a millimetre).
const PREDICTION: f32 = 0.05;
/// Drift up to which a contact is reused [TYPICAL] (chosen: 0.2 mm).
const RECYCLING: f32 = 0.01;

/// What of the solver has no state: parameters, scratch memory, and sets that stay empty, as there are no joints and no soft bodies.
pub(super) struct Engine {
    pub(super) pipeline: PhysicsPipeline,
    pub(super) parameters: IntegrationParameters,
    pub(super) joints: ImpulseJointSet,
    pub(super) multibody_joints: MultibodyJointSet,
    pub(super) soft_bodies: SoftBodySet,
    pub(super) ccd: CCDSolver,
}

impl Engine {
    /// The engine, with its own scratch memory.
    pub(super) fn new() -> Self {
        Self {
            pipeline: PhysicsPipeline::new(),
            parameters: parameters(),
            joints: ImpulseJointSet::new(),
            multibody_joints: MultibodyJointSet::new(),
            soft_bodies: SoftBodySet::new(),
            ccd: CCDSolver::new(),
        }
    }
}

fn parameters() -> IntegrationParameters {
    let mut parameters = IntegrationParameters {
        dt: RIGID_S as f32,
        length_unit: TYPICAL,
        num_solver_iterations: ITERATIONS,
        num_internal_stabilization_iterations: RELAXATIONS,
        normalized_prediction_distance: PREDICTION,
        normalized_contact_recycle_distance: RECYCLING,
        ..IntegrationParameters::default()
    };
    for softness in [&mut parameters.contact_softness, &mut parameters.static_contact_softness] {
        softness.natural_frequency = CONTACT_HZ;
        softness.damping_ratio = CONTACT_DAMPING;
    }
    parameters
}
