//! What the command prints and the files that it writes.

pub mod coloured_surfaces;
pub mod field_files;
pub mod interruption;
pub mod json;
pub mod out_dir;
pub mod out_file;
mod printable;
pub mod progress;
pub mod section_files;
pub mod session_out;
pub mod stderr;
pub mod stdout;
pub mod text_summary;
pub mod wav_out;
