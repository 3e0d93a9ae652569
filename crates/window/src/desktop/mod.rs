//! The window on a system's desktop: devices, files, photos, and the system's window itself.

pub(crate) mod act;
pub mod bench_frame;
mod clock;
pub(crate) mod dialog_errors;
pub(crate) mod files;
pub(crate) mod fonts;
pub(crate) mod gamepad_device;
pub mod hand;
pub mod host;
pub mod log_file;
pub mod mirror_still;
pub mod offscreen;
pub(crate) mod panels;
pub mod photo;
mod photo_bar;
pub mod session_file;
pub mod stored_zoom;
pub(crate) mod system;
pub mod window;
