//! Haptic devices for the frying-pan simulator: the pan's pose in, forces out.
//!
//! The kitchen publishes a [`ContactModel`] sixty times a second. A [`ControlLoop`] on its own real-time thread reads the latest
//! model, exchanges with a [`HapticDevice`] at 1 kHz, and renders the wrench on the hand with time-domain passivity.
//!
//! - [`control`]: force rendering by virtual coupling, passivity observer and controller, safety limits, the loop's thread
//! - [`strings`]: the SPIDAR, an eight-string device: tension distribution, pose estimation, calibration, wire protocol
//! - [`remote`]: networked devices: phones, the Haply Inverse3, OSC senders
//! - [`kitchen`]: the contact model, and the pan and turner in hand
//!
//! A simulated device carries 0.3 kg of food:
//!
//! ```
//! use saute_haptics::contact_model::{ContactModel, Payload};
//! use saute_haptics::{HapticCommand, HapticDevice, Renderer, WeightOnSpring, library};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let mut device = WeightOnSpring::default();
//! let mut renderer = Renderer::new(device.capabilities(), &library::feel()?);
//! let mut command = HapticCommand::default();
//! for step in 1..=2000 {
//!     let sample = device.exchange(&command, 1e-3);
//!     let payload = Payload::point(0.3, glam::DVec3::ZERO);
//!     let model = ContactModel { number: step, payload, ..ContactModel::default() };
//!     command = renderer.step(&sample, &model, 1e-3);
//! }
//! let weight_n = 0.3 * 9.80665;
//! assert!((command.wrench.force.z + weight_n).abs() < 0.05, "{} N", command.wrench.force.z);
//! # Ok(())
//! # }
//! ```

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
// The former name of `library`, until window and command line use the new one.
#[doc(hidden)]
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
