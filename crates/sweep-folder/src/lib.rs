//! A sweep on this machine: its folder, and the threads that cook its rows.
//!
//! A [`SweepFolder`] hands out rows and takes results, whoever cooks them, and writes all files. [`cooking::cook_all`] cooks them on
//! threads. Each result is in a `journal` as soon as it is there; when a part is complete its journal becomes a Parquet file. So
//! a program that is killed loses only the rows that it was cooking.

pub mod cooking;
mod error;
mod folder;
mod tally;

pub use error::FolderError;
pub use folder::{MANIFEST_MIB, PART_MIB, ROWS, SweepFolder};
pub use tally::Tally;
