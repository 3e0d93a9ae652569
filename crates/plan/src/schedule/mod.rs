//! The schedule of a cook: preheating, powers, flips, pulling and resting, searched for a goal.
//!
//! A [`Planner`] is a state machine: [`Planner::next_jobs`] hands out independent jobs, [`Planner::take`] takes their results, until
//! [`Planner::plan`] has the answer. Whoever runs the jobs, and how many at once, does not change it. A [`Job`] cooks a whole
//! candidate with [`saute_recipe::Cook`].

mod draft;
mod fork;
mod heating;
mod job;
mod moves;
mod order;
mod plan;
mod planner;
mod seeds;
mod sensitivity;
mod times;

pub use draft::Draft;
pub use job::{Cue, Job, JobError, JobResult, Pull};
pub use order::Order;
pub use plan::Plan;
pub use planner::Planner;
pub use sensitivity::{Change, Sensitivity};
pub use times::{Schedule, Setting};
