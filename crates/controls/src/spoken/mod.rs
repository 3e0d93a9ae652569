//! Descriptions of a cook and of a view: sentences that need the session or a picture.

pub mod announcer;
pub mod notice;
pub mod told;
pub mod view_words;
