//! The cook that the window shows: turned, played elsewhere, and fast enough.

mod captions;
mod errands;
mod hearing;
mod scrubbing;
mod timeline;
mod turned_time;
