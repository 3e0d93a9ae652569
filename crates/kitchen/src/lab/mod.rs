//! The lab: the solver on plain bodies with any boundary, for checks by others.

mod body;
mod case;
mod case_file;
mod material;
mod report;
mod run;
mod verdict;

pub use case::{Boundary, Case};
pub use case_file::CaseFile;
pub use report::LabReport;
pub use run::run;
pub use verdict::{Verdict, verdicts};
