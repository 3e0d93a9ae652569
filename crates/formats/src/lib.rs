//! Results as the bytes of files that scientists' tools read: tables as Parquet, fields as VTU with their times as PVD, coloured
//! surfaces as binary glTF.
//!
//! This crate opens no file: whoever calls it writes the bytes.

pub mod fields;
pub mod gltf;
pub mod parquet_file;
pub mod series_table;
pub mod summary_table;
pub mod table;
pub mod vtk;

pub use table::{ColumnKind, Heading, Table, Value};
