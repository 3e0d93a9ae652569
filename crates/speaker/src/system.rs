//! The sound card of this system.

use crate::device::{Device, Trouble};

/// Opens the sound card that the system uses.
///
/// # Errors
///
/// If there is none.
pub fn system() -> Result<Box<dyn Device>, Trouble> {
    #[cfg(target_os = "linux")]
    return Ok(Box::new(crate::alsa::Alsa::open(crate::alsa::DEFAULT)?));
    #[cfg(not(target_os = "linux"))]
    Err(Trouble::NoLibrary)
}
