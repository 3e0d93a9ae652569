//! The specification of a sweep: its file, and what it varies.

pub(crate) mod joined;
pub mod spec_file;
pub mod varied;
