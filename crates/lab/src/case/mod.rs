//! Lab cases: the file format, its checks, and the checked case in SI units.

mod body_file;
mod boundary_file;
mod case_file;
mod check;
mod check_body;
mod check_boundary;
mod check_expect;
mod check_material;
mod check_schedule;
mod expect_file;
mod lab_case;
mod one_or_more;
mod ranges;
mod shipped;

pub use body_file::Shape;
pub use boundary_file::{Contact, Face};
pub use case_file::{CaseFile, Physics};
pub use expect_file::Quantity;
pub use lab_case::{BodyCase, Case, CookingCase, Medium, PanCase, Phase, ProbeCase, Radiation, Until};
pub use shipped::{validation_cases, validation_list};
