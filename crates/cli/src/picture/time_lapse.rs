//! The frames of a time lapse.

use saute_picture::cut::section::Picture;
use saute_picture::still::series::Series;

use crate::error::CliError;
use crate::output::progress::Progress;
use crate::wording::duration;

/// Frames at most (chosen: 100 s of animation; 1280 × 720 of them fill 4 GB before they are encoded).
const FRAMES_MAX: usize = 1000;

/// Draws a frame for every so many seconds up to a time [s]; a recipe that ends earlier is an error only if the time
/// was asked for.
pub fn time_lapse(series: &mut Series, every_s: f64, until_s: f64, asked: bool) -> Result<Vec<Picture>, CliError> {
    let count = (until_s / every_s + 1e-9).floor() as usize + 1;
    if asked && count > FRAMES_MAX {
        return Err(too_many(count, until_s));
    }
    let progress = Progress::over(if asked { count as u64 } else { 0 });
    let mut frames = Vec::new();
    for k in 0..count {
        let at_s = k as f64 * every_s;
        progress.next(format!("drawing {}", duration(at_s)));
        match series.at(at_s)? {
            Some(frame) => frames.push(frame),
            None if asked => return Err(series.past_the_end(at_s).into()),
            None => break,
        }
        if frames.len() > FRAMES_MAX {
            return Err(too_many(frames.len(), at_s));
        }
    }
    Ok(frames)
}

fn too_many(count: usize, until_s: f64) -> CliError {
    let least = (until_s / (FRAMES_MAX - 1) as f64).ceil();
    CliError::place(
        "--time-lapse".to_owned(),
        format!("asks for {count} frames or more, at most {FRAMES_MAX} are made"),
        &format!("write --time-lapse {least} or more, or a smaller --at"),
    )
}
