//! Devices that hands hold: the pan's pose in, forces out.
//!
//! A kitchen publishes a [`ContactModel`] sixty times a second; a [`ControlLoop`] on a thread of its own reads the last one,
//! asks a [`HapticDevice`] a thousand times a second where the pan is, and tells it what the hand shall feel.

pub mod contact_model;
pub mod control_loop;
pub mod coupled_payload;
pub mod degrade;
pub mod device;
pub mod feel;
pub mod geometry;
pub mod guard_planes;
pub mod handover;
pub mod impulse_train;
pub mod jig_calibration;
pub mod jitter;
pub mod kept_calibration;
pub mod kitchen_watch;
pub mod lay_down;
mod linear;
pub mod open;
pub mod pan_in_hand;
pub mod passivity;
pub mod pose_from_lengths;
pub mod renderer;
pub mod rumble;
pub mod safety_limits;
pub mod scheduling;
pub mod shelf;
pub mod simulator;
pub mod spidar;
pub mod strings;
mod template;
pub mod tension;
pub mod turner_in_hand;
pub mod vibration;
pub mod wire;
pub mod workspace;
pub mod wrench;

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
