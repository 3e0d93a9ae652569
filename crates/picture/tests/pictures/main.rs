//! Pictures: what they must be true to, and what they looked like when somebody last looked at them.

mod exposure;
mod looks;
mod marbling;
mod painted;
mod perceptual;
mod rim;
mod truth;

use saute_picture::still::headless::{Gpu, GpuError};

/// The graphics adapter; without one it prints a note, and the calling test has nothing to look at.
fn adapter() -> Option<Gpu> {
    match Gpu::open() {
        Ok(gpu) => Some(gpu),
        Err(GpuError::NoAdapter(why)) => {
            eprintln!("no graphics adapter ({why}): this picture test is skipped");
            None
        }
        Err(GpuError::NoDevice(why)) => panic!("{why}"),
    }
}
