//! The contact model: a local model of the kitchen that the control loop renders between two frames.

use glam::{DMat3, DVec3};
use saute_kitchen::dynamics::Pose;

use crate::wrench::Wrench;

/// Number of collisions in a model (chosen: more than occur within two frames).
pub const IMPULSES: usize = 8;
/// Maximum number of walls in a model (chosen: the hob uses one).
pub const PLANES: usize = 4;

/// A rigid mass that moves with the pan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Payload {
    /// Mass [kg].
    pub mass: f64,
    /// Centre of mass in the pan's frame [m].
    pub centre: DVec3,
    /// Inertia tensor about the centre of mass, in the pan's frame [kg·m²].
    pub inertia: DMat3,
}

impl Default for Payload {
    fn default() -> Self {
        Self { mass: 0.0, centre: DVec3::ZERO, inertia: DMat3::ZERO }
    }
}

/// A collision with the pan.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Impulse {
    /// Serial number; 0 for none.
    pub number: u64,
    /// Impulse on the pan, in the kitchen's axes [N·s].
    pub impulse: DVec3,
    /// Point of impact, in the pan's frame [m].
    pub at: DVec3,
    /// Kinetic energy lost by the food [J].
    pub energy: f64,
}

/// A plane that a point of the pan cannot pass, in the kitchen.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Plane {
    /// Unit normal towards the allowed side; zero for no wall [-].
    pub normal: DVec3,
    /// Lower bound of normal · point [m].
    pub at_least: f64,
    /// Distance of the point from the pan's axis, in the plane of its floor [m].
    pub edge_radius: f64,
    /// Depth of the point below the floor's upper face [m].
    pub below: f64,
}

/// A rubbing contact on the pan.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rubbing {
    /// Sliding speed [m/s].
    pub speed: f64,
    /// Normal force [N].
    pub force: f64,
}

/// The kitchen's state as the control loop renders it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContactModel {
    /// Serial number of the model; 0 before the first one.
    pub number: u64,
    /// Pose of the kitchen's pan.
    pub pan: Pose,
    /// Foods at rest in the pan, and its liquids.
    pub payload: Payload,
    /// The pan itself, for devices without a real pan.
    pub own: Payload,
    /// Contact wrench of foods that move in the pan, without their weight, about the pan's origin [N, N·m].
    pub loose: Wrench,
    /// Weight of foods that move in the pan [N, N·m].
    pub loose_weight: Wrench,
    /// The latest collisions.
    pub impulses: [Impulse; IMPULSES],
    /// Walls.
    pub planes: [Plane; PLANES],
    /// Vapour flow from foods and liquids in the pan [kg/s].
    pub vapour: f64,
    /// Sliding foods.
    pub sliding: Rubbing,
    /// The scraping edge of the turner.
    pub scraping: Rubbing,
}

impl Payload {
    /// Returns both masses as one rigid body.
    pub fn with(&self, other: &Self) -> Self {
        let mass = self.mass + other.mass;
        if mass <= 0.0 {
            return Self::default();
        }
        let centre = (self.centre * self.mass + other.centre * other.mass) / mass;
        let about = |p: &Self| p.inertia + parallel_axes(p.mass, p.centre - centre);
        Self { mass, centre, inertia: about(self) + about(other) }
    }

    /// Returns true if mass, centre and inertia are finite.
    pub fn is_finite(&self) -> bool {
        self.mass.is_finite() && self.centre.is_finite() && self.inertia.is_finite()
    }

    /// Creates a point mass [kg] at `centre` [m].
    pub fn point(mass: f64, centre: DVec3) -> Self {
        Self { mass, centre, inertia: DMat3::ZERO }
    }
}

/// Returns the inertia tensor of a point mass at r (parallel axis theorem), m (r² 1 − r rᵀ) [kg·m²].
fn parallel_axes(mass: f64, r: DVec3) -> DMat3 {
    let outer = DMat3::from_cols(r * r.x, r * r.y, r * r.z);
    (DMat3::from_diagonal(DVec3::splat(r.length_squared())) - outer) * mass
}
