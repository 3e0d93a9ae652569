//! Results as the bytes of files that scientists' tools read: tables as Parquet.
//!
//! This crate opens no file: whoever calls it writes the bytes.

pub mod parquet_file;
pub mod series_table;
pub mod summary_table;
pub mod table;

pub use table::{Heading, Kind, Table, Value};
