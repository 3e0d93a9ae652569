//! A still of a recipe at one instant, drawn by the window's own renderer.

use saute_kitchen::kitchen::SetupError;
use saute_kitchen::runner::RunError;
use saute_kitchen::{Cook, Library, Recipe, TICK_S};

use crate::headless::{Gpu, GpuError, still};
use crate::section_picture::Picture;
use crate::stage::StageOptions;

/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
pub enum ShotError {
    /// The recipe ends before.
    #[error("--at {at_s} is past the end: the recipe ends at {end_s:.1} s; choose a time up to that")]
    PastTheEnd {
        /// What was asked for [s].
        at_s: f64,
        /// When the recipe ends [s].
        end_s: f64,
    },
    /// A step went wrong.
    #[error(transparent)]
    Run(#[from] RunError),
    /// The kitchen cannot be set up.
    #[error(transparent)]
    Setup(#[from] SetupError),
    /// Nothing can be drawn.
    #[error(transparent)]
    Gpu(#[from] GpuError),
}

/// Cooks a recipe up to a time [s]; steps that are due then have been carried out.
pub fn cook_until(recipe: Recipe, library: &Library, at_s: f64) -> Result<Cook, ShotError> {
    let mut cook = Cook::new(recipe, library)?;
    while cook.kitchen.time_s() < at_s - 0.5 * TICK_S {
        cook.advance()?;
        if cook.stopped().is_some() {
            let end_s = cook.kitchen.time_s();
            if end_s < at_s - 0.5 * TICK_S {
                return Err(ShotError::PastTheEnd { at_s, end_s });
            }
        }
    }
    let Cook { runner, kitchen, .. } = &mut cook;
    runner.poll(kitchen)?;
    Ok(cook)
}

/// Cooks up to a time and draws.
pub fn shot(recipe: Recipe, library: &Library, at_s: f64, options: &StageOptions, size: [u32; 2]) -> Result<Picture, ShotError> {
    let cook = cook_until(recipe, library, at_s)?;
    Ok(still(&Gpu::open()?, &cook.kitchen, options, size))
}
