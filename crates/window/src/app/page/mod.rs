//! What the window does where it is a page: what the page hands in and keeps, its phone, and the panels as HTML.

mod hands;
mod host;
mod inbox;
mod mirrored;

/// What the window has of its page.
#[derive(Default)]
pub(crate) struct Page {
    /// What the page hands in.
    pub(crate) inbox: crate::browser::Inbox,
    /// What the page's script does for the window.
    pub(crate) host: Option<crate::browser::host::Host>,
    /// The version of its build.
    pub(crate) version: String,
    /// The panels a second time, as HTML.
    pub(crate) mirrored: crate::browser::Mirrored,
}
