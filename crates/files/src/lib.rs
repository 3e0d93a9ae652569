//! Files of the saute frying-pan simulator: read within limits, and written so that a program that is killed leaves the old file or the
//! new one, never half of one.
//!
//! | piece | for |
//! |---|---|
//! | [`regular_file`] | reading what a person names: no pipe, no device, no endless file |
//! | [`whole_file`] | one file that is there as a whole or not at all |
//! | [`locked_file`] | a place to which one program alone writes |
//! | [`staged_files`] | many files that change places together |
//! | [`journal`] | records that are appended as they come |
//! | [`checksums`] | files that nobody has changed since |

pub mod checksums;
pub mod journal;
pub mod locked_file;
pub mod regular_file;
pub mod staged_files;
pub mod whole_file;

pub use journal::Journal;
pub use locked_file::LockedFile;
pub use staged_files::{Sorts, StagedFiles};
pub use whole_file::write_whole;
