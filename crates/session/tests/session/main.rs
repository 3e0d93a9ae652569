//! The cook that the window shows: turned, played elsewhere, and fast enough.

mod captions;
mod hearing;
mod playback;
mod scrubbing;
mod timeline;
mod turned_time;
