//! Rigid bodies: the pan that follows a hand, foods that slide, pile up and fly, tools.
//!
//! The rigid-body engine is rapier (32 bit, deterministic). It computes in centimetres and grams, so that its
//! absolute tolerances suit food of a few centimetres. The pan moves kinematically with bounded speed and
//! acceleration. Its floor is a half space that only bodies above the pan meet, so no food falls through at any
//! speed; its wall is 32 wedges. The collision shape of a food follows its present shape and mass: a cylinder, a
//! cuboid, eight strips of a steak, four rods of a shrimp, or convex parts of a user's surface.
//!
//! The pose of a piece changes by integration only. Turner and tongs hold food by a spring with bounded force and
//! torque, and fail where something is in the way. A turner moved by a person is a dynamic blade on a bounded spring:
//! low and level it slides under the nearest food and lifts it; rolled over it drops the food; all other food it
//! presses or pushes. A press as a task gives the food the inertia of the hand, and its force rises and falls gradually.
//! Bodies at rest sleep; with all bodies asleep no rigid step is computed.

mod blade;
mod damping;
mod engine;
pub mod extent;
pub mod gesture;
pub mod hand;
pub mod pan_motion;
pub mod pan_shape;
pub mod pose;
mod press;
mod press_path;
mod rigid_state;
pub(crate) mod saved_world;
mod scale;
mod scoop;
pub mod solid_shape;
mod spring;
pub mod task;
pub mod world;

pub use blade::BLADE_HALF;
pub use gesture::Gesture;
pub use hand::{Ended, Hand, Tool};
pub use pan_motion::{PanMotion, PanTarget};
pub use pan_shape::PanShape;
pub use pose::Pose;
pub use task::Task;
pub use world::{Against, Contact, RIGID_HZ, RIGID_S, World};
