//! Lab cases: the file format, its checks, and the checked case in SI units.

pub mod case_file;
mod check;
mod check_schedule;
mod check_stack;
mod lab_case;
mod one_or_more;
mod shipped;

pub use lab_case::{BodyCase, Case, CookingCase, PanCase, Phase, ProbeCase, Until};
pub use shipped::validation_cases;
