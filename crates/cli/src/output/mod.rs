//! What the command prints and the files that it writes.

pub mod json;
pub mod out_dir;
pub mod out_file;
pub mod progress;
pub mod section_files;
pub mod stderr;
pub mod stdout;
pub mod text_summary;
