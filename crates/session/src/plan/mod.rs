//! Plans: searched for off the frame, and followed live.

pub mod job;
pub mod live;
pub mod planning;
pub mod why_not;
