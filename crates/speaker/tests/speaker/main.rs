//! Promises of the speaker. None needs a sound card, and none listens to a clock.

mod device;
mod lost;
mod told;
