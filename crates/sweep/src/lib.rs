//! Sweeps: one recipe cooked many times with values that vary by a design.
//!
//! A [`SpecFile`] states what varies; a [`Sweep`] joins it with its recipe and data and has numbered rows. [`Sweep::run_row`] is a
//! pure function of the row's number, so it does not matter who runs which rows, where and in what order. Rows form parts
//! ([`Sweep::part_rows`]); [`Sweep::part_file`] turns the results of a part into a Parquet file. [`Sweep::to_bytes`] takes a
//! sweep to another machine. A [`Manifest`] states which sweep a folder contains. This crate opens no file and starts no thread: a shell does.

pub mod design;
mod documents;
mod identity;
pub mod manifest;
mod parcel;
mod place;
pub mod row;
pub mod sensitivity;
pub mod spec;
pub mod sweep;

pub use manifest::Manifest;
pub use row::{RowResult, Status};
pub use spec::spec_file::SpecFile;
pub use sweep::{Base, Sweep};
