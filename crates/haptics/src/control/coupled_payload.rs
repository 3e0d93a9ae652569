//! The pan's contents as a body that hangs on the pan by a spring and a damper.

use glam::{DQuat, DVec3};
use saute_kitchen::dynamics::Pose;
use saute_kitchen::dynamics::pose::{about, rotation_between};

use crate::kitchen::contact_model::Payload;
use crate::device::Capabilities;
use crate::control::feel::PayloadFeel;
use crate::kitchen::kitchen_watch::GRAVITY;
use crate::wrench::{Twist, Wrench};

/// Lightest contents that are felt [kg] (chosen: a gram).
const LIGHTEST: f64 = 1e-3;
/// Smallest moment of inertia that is felt [kg·m²] (chosen: a coin of carrot; less would need shorter steps).
const LEAST_INERTIA: f64 = 1e-6;
/// Stretch of the spring beyond which the body is set down anew [m] (chosen: a jump of the pan, not a swing).
const TORN: f64 = 0.1;

/// Radius of gyration of what the hand really holds [m] (chosen: between a grip and a pan).
const GYRATION: f64 = 0.05;

/// A virtual body, coupled to the pan.
///
/// m dv/dt = −F + m g, F = K (x − x_pan) + B (v − v_pan); the hand feels F at the contents' centre, and likewise the
/// torque of turning. K = m (2πf)² and B = 2ζ√(K m), no stiffer and no more damped than the device allows: at rest F is the weight, exactly; in motion the
/// inertia, without acceleration ever being measured. Passive for steps shorter than 1/(πf).
#[derive(Clone, Copy, Debug)]
pub struct CoupledPayload {
    frequency: f64,
    damping: f64,
    stiffness: [f64; 2],
    most_damping: [f64; 2],
    body: Option<Body>,
    mass: f64,
    /// Kinetic and spring energy [J].
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

/// What the contents do to the hand.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PayloadWrench {
    /// The whole [N, N·m].
    pub felt: Wrench,
    /// Their weight alone [N, N·m].
    pub weight: Wrench,
}

impl CoupledPayload {
    /// Nothing yet.
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

    /// One step of `dt` [s] with the pan there.
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
        // Contents that changed hang as deep as the new ones would; the spring's length is no energy of theirs.
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

    /// The contents lie still in the pan when they are felt next.
    pub fn forget(&mut self) {
        (self.body, self.held) = (None, 0.0);
    }

    /// What the hand has put into the contents and gets back when they come to rest: ½ K d² + ½ m v², d from where they
    /// hang, and likewise of turning [J].
    pub fn held(&self) -> f64 {
        self.held
    }

    /// The torque with which the contents resist turning [N·m].
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
