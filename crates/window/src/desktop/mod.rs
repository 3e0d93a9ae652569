//! The window on a system's desktop: devices, files, photos, and the system's window itself.

pub mod bench_frame;
pub(crate) mod dialog_errors;
pub(crate) mod files;
pub(crate) mod fonts;
pub mod hand;
pub mod host;
pub mod offscreen;
pub(crate) mod panels;
pub mod photo;
mod photo_bar;
pub(crate) mod system;
pub mod window;
