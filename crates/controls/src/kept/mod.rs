//! What is kept on the disk while a cook or a study goes on.

pub mod log_file;
pub mod session_file;
pub mod time_of_day;
