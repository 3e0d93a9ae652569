//! File formats of the saute frying-pan simulator: the types that a file is read into state its format once, and checks, messages and
//! reference pages follow from them.
//!
//! A type that derives [`schemars::JsonSchema`] states for each key its meaning, range, default and an example. [`FormatSchema`] compares a
//! file with it: every [`Finding`] has a line and a remedy. What relates keys to one another is a function of the format
//! ([`Format::relations`]). [`InputText`] gives the errors of files whose keys are read with their places.
//!
//! ```
//! #[derive(serde::Deserialize, schemars::JsonSchema)]
//! #[serde(deny_unknown_fields)]
//! struct Spoon {
//!     /// Length [mm].
//!     #[schemars(range(min = 50, max = 400), example = 180.0)]
//!     length_mm: f64,
//! }
//! let found = saute_schema::FormatSchema::of::<Spoon>().findings("lenght_mm = 180.0");
//! assert_eq!(found[0].remedy, "write length_mm");
//! ```

pub mod data_file;
pub mod echo;
pub mod finding;
pub mod format;
mod format_page;
pub mod input_error;
pub mod library_error;
mod nearest;
pub mod number_text;
pub mod schema_text;
mod schema_walk;

pub use data_file::DataFile;
pub use finding::Finding;
pub use format::{Format, FormatSchema};
pub use input_error::{InputError, InputText};
pub use library_error::LibraryError;
pub use nearest::nearest;
