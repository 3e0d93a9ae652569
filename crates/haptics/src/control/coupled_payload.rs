//! Virtual coupling: the pan's contents as a rigid body that a spring and a damper couple to the pan.

use glam::{DQuat, DVec3};
use saute_kitchen::dynamics::Pose;
use saute_kitchen::dynamics::pose::{about, rotation_between};

use crate::control::feel::PayloadFeel;
use crate::device::Capabilities;
use crate::kitchen::contact_model::Payload;
use crate::kitchen::kitchen_watch::GRAVITY;
use crate::wrench::{Twist, Wrench};

/// Lightest rendered contents [kg] (chosen: a gram is below what a hand notices).
const LIGHTEST: f64 = 1e-3;
/// Smallest rendered moment of inertia [kg·m²] (chosen: a slice of carrot; smaller ones need shorter steps).
const LEAST_INERTIA: f64 = 1e-6;
/// Stretch of the spring that resets the body [m] (chosen: only a jump of the pan reaches it, not a swing).
const TORN: f64 = 0.1;

/// Radius of gyration of the real object in the hand [m] (chosen: between a grip and a pan).
const GYRATION: f64 = 0.05;

/// A virtual body, coupled to the pan (Colgate, Stanley & Brown 1995) [N, N·m].
///
/// m dv/dt = −F + m g with F = K (x − x_pan) + B (v − v_pan). The hand feels F at the contents' centre, and the analogous
/// torque. K = m (2πf)² and B = 2ζ√(K m), both limited to what the device renders stably. At rest F equals the weight exactly;
/// in motion it contains the inertia, and no acceleration has to be measured. Passive for steps shorter than 1/(πf).
#[derive(Clone, Copy, Debug)]
pub struct CoupledPayload {
    frequency: f64,
    damping: f64,
    stiffness: [f64; 2],
    most_damping: [f64; 2],
    body: Option<Body>,
    mass: f64,
    /// Kinetic and spring energy of the body [J].
    held: f64,
}

#[derive(Clone, Copy, Debug)]
struct Body {
    position: DVec3,
    velocity: DVec3,
    rotation: DQuat,
    turning: DVec3,
}

impl Body {
    fn is_finite(&self) -> bool {
        let vectors = [self.position, self.velocity, self.turning];
        vectors.iter().all(|v| v.is_finite()) && self.rotation.is_finite()
    }
}

/// Wrench of the contents on the hand.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PayloadWrench {
    /// The whole wrench, weight included [N, N·m].
    pub felt: Wrench,
    /// The weight alone [N, N·m].
    pub weight: Wrench,
}

impl CoupledPayload {
    /// Creates a coupling without contents.
    pub fn new(feel: &PayloadFeel, device: &Capabilities) -> Self {
        let damping = device.most_damping();
        Self {
            frequency: feel.frequency_hz * std::f64::consts::TAU,
            damping: feel.damping,
            stiffness: [device.limits.stiffness_n_m, device.limits.stiffness_nm_rad],
            most_damping: [damping, damping * GYRATION * GYRATION],
            body: None,
            mass: 0.0,
            held: 0.0,
        }
    }

    /// Advances the body by `dt` [s] and returns its wrench on the pan [N, N·m].
    pub fn step(&mut self, payload: &Payload, pose: &Pose, twist: &Twist, dt: f64) -> PayloadWrench {
        if payload.mass < LIGHTEST || !payload.is_finite() {
            self.forget();
            return PayloadWrench::default();
        }
        let arm = pose.rotation * payload.centre;
        let (place, speed) = (pose.position + arm, twist.at(arm));
        let gravity = DVec3::new(0.0, 0.0, -GRAVITY);
        let stiffness = (payload.mass * self.frequency * self.frequency).min(self.stiffness[0]);
        let damping = (2.0 * self.damping * libm::sqrt(stiffness * payload.mass)).min(self.most_damping[0]);
        let hanging = gravity * (payload.mass / stiffness);
        let fresh =
            Body { position: place + hanging, velocity: speed, rotation: pose.rotation, turning: twist.angular };
        let mut body = self.body.unwrap_or(fresh);
        // Changed contents start in equilibrium: the stretch of the old spring is not energy of the new ones.
        if (payload.mass - self.mass).abs() > LIGHTEST || (body.position - place - hanging).length() > TORN {
            body.position = place + hanging;
        }
        self.mass = payload.mass;
        let force = (body.position - place) * stiffness + (body.velocity - speed) * damping;
        let stretch = body.position - place - hanging;
        self.held = 0.5 * (stiffness * stretch.length_squared() + payload.mass * body.velocity.length_squared());
        let torque = self.turn(&mut body, payload, pose, twist, dt);
        body.velocity += (gravity - force / payload.mass) * dt;
        body.position += body.velocity * dt;
        let felt = Wrench::at(force, arm) + Wrench { force: DVec3::ZERO, torque };
        if !(felt.is_finite() && body.is_finite() && self.held.is_finite()) {
            self.forget();
            return PayloadWrench::default();
        }
        self.body = Some(body);
        PayloadWrench { felt, weight: Wrench::at(gravity * payload.mass, arm) }
    }

    /// Resets the body: the contents are at rest in the pan at the next step.
    pub fn forget(&mut self) {
        (self.body, self.held) = (None, 0.0);
    }

    /// Returns the energy that the hand has put into the contents and gets back when they come to rest [J].
    ///
    /// It is ½ K d² + ½ m v² with d measured from equilibrium, plus the same for rotation.
    pub fn held(&self) -> f64 {
        self.held
    }

    /// Returns the torque of the rotational coupling [N·m].
    fn turn(&mut self, body: &mut Body, payload: &Payload, pose: &Pose, twist: &Twist, dt: f64) -> DVec3 {
        let inertia = (payload.inertia.x_axis.x + payload.inertia.y_axis.y + payload.inertia.z_axis.z) / 3.0;
        if inertia < LEAST_INERTIA {
            (body.rotation, body.turning) = (pose.rotation, twist.angular);
            return DVec3::ZERO;
        }
        let stiffness = (inertia * self.frequency * self.frequency).min(self.stiffness[1]);
        let damping = (2.0 * self.damping * libm::sqrt(stiffness * inertia)).min(self.most_damping[1]);
        let turned = rotation_between(pose.rotation, body.rotation);
        let torque = turned * stiffness + (body.turning - twist.angular) * damping;
        self.held += 0.5 * (stiffness * turned.length_squared() + inertia * body.turning.length_squared());
        body.turning -= torque * (dt / inertia);
        body.rotation = (about(body.turning * dt) * body.rotation).normalize();
        torque
    }
}
