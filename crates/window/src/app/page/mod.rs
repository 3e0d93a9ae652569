//! What the window does where it is a page: what the page hands in and keeps, its phone, and the panels as HTML.

mod hands;
mod host;
mod inbox;
mod mirrored;
