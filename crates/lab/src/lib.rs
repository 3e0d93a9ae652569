//! The lab: the solver on plain bodies with any boundary, for checks by others.
//!
//! Bodies are products of one-dimensional meshes (straight, cylindrical or spherical axes), stacked in layers where
//! there are several. With constant properties a second-order Runge–Kutta–Legendre scheme `[@meyer-2014]` integrates
//! them, with steps that grow with the time since the last sudden change. Properties that change, boiling and
//! `rule = "segments"` are computed edge by edge.

mod body;
mod case;
mod case_file;
mod check;
mod check_schedule;
mod check_stack;
pub mod cook_case;
mod cooking;
mod cooking_body;
mod edge_system;
mod material;
mod one_or_more;
mod recording;
mod report;
mod run;
mod shipped;
mod solver;
mod verdict;

pub use case::{BodyCase, Case, CookingCase, PanCase, Phase, ProbeCase, Until};
pub use case_file::{CaseFile, Physics, Quantity, Shape};
pub use cook_case::CookCase;
pub use material::{Boiling, Material, Solid};
pub use report::LabReport;
pub use run::run;
pub use shipped::validation_cases;
pub use verdict::{Expectation, Subject, Verdict, verdicts};
