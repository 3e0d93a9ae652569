//! The kitchen at home: what was entered and measured, fitted off the frame, and kept.

pub mod entered;
pub mod fitting;
pub mod job;
pub mod kept;
pub mod open_log;
pub mod why_not;
