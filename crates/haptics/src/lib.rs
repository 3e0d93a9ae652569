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
//! A browser reaches no device: there the crate has what is felt (contact model, rumble) and how a phone holds the pan.
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
#[cfg(not(target_arch = "wasm32"))]
pub mod device;
pub mod kitchen;
pub mod library;
#[cfg(not(target_arch = "wasm32"))]
pub mod open;
pub mod remote;
#[cfg(not(target_arch = "wasm32"))]
pub mod strings;
#[cfg(not(target_arch = "wasm32"))]
mod template;
pub mod wrench;

pub use control::double_pulse::DoublePulse;
pub use control::feel::Feel;
pub use control::rumble::{Rumble, RumbleRule};
pub use kitchen::contact_model::ContactModel;
pub use kitchen::handover::Handover;
pub use kitchen::kitchen_watch::KitchenWatch;
pub use kitchen::pan_in_hand::PanInHand;
pub use kitchen::turner_in_hand::TurnerInHand;
pub use saute_kitchen::dynamics::Pose;
pub use wrench::{Twist, Wrench};

#[cfg(not(target_arch = "wasm32"))]
pub use with_devices::*;

/// What needs a device.
#[cfg(not(target_arch = "wasm32"))]
mod with_devices {
    pub use crate::control::control_loop::ControlLoop;
    pub use crate::control::degrade::Rendering;
    pub use crate::control::renderer::Renderer;
    pub use crate::device::{Capabilities, HapticCommand, HapticDevice, HapticSample, Health};
    pub use crate::open::{Access, Named, OpenError, Opened, open};
    pub use crate::strings::geometry::Geometry;
    pub use crate::strings::jig_calibration::Calibration;
    pub use crate::strings::kept_calibration::KeptCalibration;
    pub use crate::strings::pose_from_lengths::PoseEstimator;
    pub use crate::strings::simulator::Simulator;
    pub use crate::strings::spidar::Spidar;
    pub use crate::strings::tension::{TensionRule, TensionSolver};
    pub use crate::strings::{STRINGS, StringRig};
    pub use crate::template::WeightOnSpring;
}
