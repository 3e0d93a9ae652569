//! What a kitchen tells the control loop: enough to feel the pan for some milliseconds without asking again.

use glam::{DMat3, DVec3};
use saute_kitchen::dynamics::Pose;

use crate::wrench::Wrench;

/// Collisions that a model remembers (chosen: more than fall into a pan within two frames).
pub const IMPULSES: usize = 8;
/// Walls of a model at most.
pub const PLANES: usize = 4;

/// A mass that moves with the pan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Payload {
    /// Mass [kg].
    pub mass: f64,
    /// Its centre in the pan's frame [m].
    pub centre: DVec3,
    /// Moments of inertia about the centre, in the pan's frame [kg·m²].
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
    /// Counts up; 0 for none.
    pub number: u64,
    /// What the pan gets, in the kitchen's directions [N·s].
    pub impulse: DVec3,
    /// Where, in the pan's frame [m].
    pub at: DVec3,
    /// Kinetic energy that the foods lost [J].
    pub energy: f64,
}

/// A wall that a point of the pan cannot pass, in the kitchen.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Plane {
    /// Unit normal, towards where the point may be; zero for no wall.
    pub normal: DVec3,
    /// normal · point is at least this [m].
    pub at_least: f64,
    /// The point's distance from the pan's axis, within the plane of its floor [m].
    pub edge_radius: f64,
    /// The point's depth below the floor's upper face [m].
    pub below: f64,
}

/// Something that rubs on the pan.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rubbing {
    /// How fast [m/s].
    pub speed: f64,
    /// How hard [N].
    pub force: f64,
}

/// The last state of the kitchen as hands feel it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContactModel {
    /// Counts up with every one that is published; 0 before the first.
    pub number: u64,
    /// Pose of the kitchen's pan.
    pub pan: Pose,
    /// Foods that lie still in the pan, and its liquids.
    pub payload: Payload,
    /// The pan itself, for devices without a real one.
    pub own: Payload,
    /// Friction and push of what moves about in the pan, its weight left out: wrench on the pan about its origin [N, N·m].
    pub loose: Wrench,
    /// Weight of what moves about in the pan [N, N·m].
    pub loose_weight: Wrench,
    /// The latest collisions.
    pub impulses: [Impulse; IMPULSES],
    /// Walls.
    pub planes: [Plane; PLANES],
    /// Vapour that foods and puddles in the pan give off [kg/s].
    pub vapour: f64,
    /// Foods that slide.
    pub sliding: Rubbing,
    /// The turner's edge.
    pub scraping: Rubbing,
}

impl Payload {
    /// Both together.
    pub fn with(&self, other: &Self) -> Self {
        let mass = self.mass + other.mass;
        if mass <= 0.0 {
            return Self::default();
        }
        let centre = (self.centre * self.mass + other.centre * other.mass) / mass;
        let about = |p: &Self| p.inertia + parallel_axes(p.mass, p.centre - centre);
        Self { mass, centre, inertia: about(self) + about(other) }
    }

    /// Whether mass, centre and inertia are finite.
    pub fn is_finite(&self) -> bool {
        self.mass.is_finite() && self.centre.is_finite() && self.inertia.is_finite()
    }

    /// A mass in a point [kg, m].
    pub fn point(mass: f64, centre: DVec3) -> Self {
        Self { mass, centre, inertia: DMat3::ZERO }
    }
}

/// Moments of inertia of a mass [kg] away from an axis: m (r² 1 − r rᵀ) [kg·m²].
fn parallel_axes(mass: f64, r: DVec3) -> DMat3 {
    let outer = DMat3::from_cols(r * r.x, r * r.y, r * r.z);
    (DMat3::from_diagonal(DVec3::splat(r.length_squared())) - outer) * mass
}
