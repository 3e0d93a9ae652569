//! Plans: searched for off the frame, and followed live.

pub mod craft;
pub mod live;
pub mod planning;
pub mod why_not;
