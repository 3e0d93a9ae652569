//! The lab: heat conduction and cooking of plain bodies with any boundary, for checks against exact solutions and
//! measurements.

mod case;
pub mod cook_case;
mod result;
mod solve;

pub use case::{
    BodyCase, Case, CaseFile, CookingCase, PanCase, Phase, Physics, ProbeCase, Quantity, Shape, Until, validation_cases,
};
pub use cook_case::CookCase;
pub use result::report::LabReport;
pub use result::verdict::{Expectation, Subject, Verdict, verdicts};
pub use solve::material::{Boiling, Material, Solid};
pub use solve::run;
