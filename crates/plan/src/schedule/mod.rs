//! The schedule of a cook: preheating, powers, flips, pulling and resting, searched for a goal.
//!
//! A [`Planner`] is a state machine: [`Planner::next_jobs`] hands out independent jobs, [`Planner::take`] takes their results, until
//! [`Planner::plan`] has the answer. Whoever runs the jobs, and how many at once, does not change it. A [`Job`] cooks a whole
//! candidate with [`saute_recipe::Cook`].

pub mod asked;
pub(crate) mod candidate;
mod draft;
pub mod follow;
mod heating;
pub mod kept;
mod moves;
mod order;
mod plan;
mod planner;
pub mod search;
mod seeds;
pub mod senses;
mod sensitivity;
mod steps;
mod times;
pub mod voice;

pub use candidate::Cooking;
pub use candidate::job::{Cue, Job, JobError, JobResult, Mesh, Pull};
pub use draft::Draft;
pub use order::{Order, PLAIN_FLIPS};
pub use plan::Plan;
pub use planner::{Planner, Stage};
pub use sensitivity::{Change, Sensitivity};
pub use steps::{Deed, Step};
pub use times::{Schedule, Setting};
