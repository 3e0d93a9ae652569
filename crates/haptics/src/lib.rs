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
//! use saute_haptics::kitchen::contact_model::{ContactModel, Payload};
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

// The former name of `library`, until window and command line use the new one.

pub use control::control_loop::ControlLoop;
pub use control::degrade::Rendering;
pub use control::feel::Feel;
pub use control::renderer::Renderer;
pub use control::rumble::Rumble;
pub use device::{Capabilities, HapticCommand, HapticDevice, HapticSample, Health};
pub use kitchen::contact_model::ContactModel;
pub use kitchen::handover::Handover;
pub use kitchen::kitchen_watch::KitchenWatch;
pub use kitchen::pan_in_hand::PanInHand;
pub use kitchen::turner_in_hand::TurnerInHand;
pub use open::{Access, Named, OpenError, Opened, open};
pub use saute_kitchen::dynamics::Pose;
pub use strings::geometry::Geometry;
pub use strings::jig_calibration::Calibration;
pub use strings::kept_calibration::KeptCalibration;
pub use strings::pose_from_lengths::PoseEstimator;
pub use strings::simulator::Simulator;
pub use strings::spidar::Spidar;
pub use strings::tension::{TensionRule, TensionSolver};
pub use strings::{STRINGS, StringRig};
pub use template::WeightOnSpring;
pub use wrench::{Twist, Wrench};
