//! Devices that hands hold: the pan's pose in, forces out.
//!
//! A kitchen publishes a [`ContactModel`] sixty times a second; a [`ControlLoop`] on a thread of its own reads the last one,
//! asks a [`HapticDevice`] a thousand times a second where the pan is, and tells it what the hand shall feel.

pub mod control;
pub mod device;
pub mod kitchen;
pub mod library;
pub mod open;
pub mod remote;
pub mod strings;
mod template;
pub mod wrench;

pub use control::{
    control_loop, coupled_payload, degrade, feel, guard_planes, impulse_train, jitter, passivity, renderer, rumble,
    safety_limits, scheduling, vibration,
};
pub use kitchen::{contact_model, handover, kitchen_watch, lay_down, pan_in_hand, turner_in_hand};
pub use library as shelf;
pub use remote::{haply, network_thread, osc, pairing, phone, tilt};
pub use strings::{
    geometry, jig_calibration, kept_calibration, pose_from_lengths, simulator, spidar, tension, wire, workspace,
};

pub use contact_model::ContactModel;
pub use control_loop::ControlLoop;
pub use degrade::Rendering;
pub use device::{Capabilities, HapticCommand, HapticDevice, HapticSample, Health};
pub use feel::Feel;
pub use geometry::Geometry;
pub use handover::Handover;
pub use jig_calibration::Calibration;
pub use kept_calibration::KeptCalibration;
pub use kitchen_watch::KitchenWatch;
pub use open::{Access, Named, OpenError, Opened, open};
pub use pan_in_hand::PanInHand;
pub use pose_from_lengths::PoseEstimator;
pub use renderer::Renderer;
pub use rumble::Rumble;
pub use saute_kitchen::dynamics::Pose;
pub use simulator::Simulator;
pub use spidar::Spidar;
pub use strings::{STRINGS, StringRig};
pub use template::WeightOnSpring;
pub use tension::{TensionRule, TensionSolver};
pub use turner_in_hand::TurnerInHand;
pub use wrench::{Twist, Wrench};
