//! Rigid bodies: the pan that follows a hand, foods that slide, pile up and fly, tools.

mod blade;
pub mod extent;
pub mod gesture;
pub mod hand;
pub mod pan_motion;
pub mod pan_shape;
pub mod pose;
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
