//! The frames of a time lapse.

use saute_kitchen::TICK_S;
use saute_picture::still::animation::{Format, animation_of};
use saute_picture::still::series::Series;

use crate::error::CliError;
use crate::output::progress::Progress;
use crate::wording::duration;

/// Frames at most (chosen: 100 s of animation).
const FRAMES_MAX: usize = 1000;
/// Pixels of all frames at most [px] (chosen: those of 300 frames of 1280 × 720, which fill up to 300 MB when they are encoded).
const PIXELS_MAX: usize = 300 * 1280 * 720;

/// Options of a time lapse.
pub struct Lapse {
    /// Format of the file.
    pub format: Format,
    /// Time from frame to frame [s].
    pub every_s: f64,
    /// Time of the last frame [s]; the end of the recipe unless given.
    pub until_s: Option<f64>,
    /// Width and height [px].
    pub size: [u32; 2],
}

/// Draws a frame for every so many seconds up to a time and encodes it at once; a recipe that ends before the time that was given
/// is an error.
pub fn time_lapse(series: &mut Series, lapse: &Lapse) -> Result<Vec<u8>, CliError> {
    let until_s = lapse.until_s.map_or_else(|| series.end_s(), Ok)?;
    // The last frame may be half a tick after the end.
    let count = ((until_s + 0.5 * TICK_S) / lapse.every_s + 1e-9).floor() as usize + 1;
    let [width, height] = lapse.size.map(|side| side as usize);
    let most = FRAMES_MAX.min(PIXELS_MAX / (width * height));
    if count > most {
        return Err(too_many(count, most, until_s));
    }
    let progress = Progress::over(count as u64);
    let frames = (0..count).map(|k| {
        let at_s = k as f64 * lapse.every_s;
        progress.next(format!("drawing {}", duration(at_s)));
        series.at(at_s)?.ok_or_else(|| series.past_the_end(at_s).into())
    });
    animation_of(lapse.format, [width, height], count, frames)
}

fn too_many(count: usize, most: usize, until_s: f64) -> CliError {
    let least = (until_s / (most.max(2) - 1) as f64).ceil();
    CliError::place(
        "--time-lapse".to_owned(),
        format!("asks for {count} frames, at most {most} of this size are made"),
        format!("write --time-lapse {least} or more, a smaller --at or a smaller --size"),
    )
}
