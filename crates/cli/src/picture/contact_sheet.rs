//! Pictures of several times of a cook in one.

use saute_picture::cut::section::Picture;
use saute_picture::still::series::Series;

use crate::error::CliError;
use crate::output::progress::Progress;
use crate::picture::rows::{Rows, extent};
use crate::wording::duration;

/// Pictures in a row (chosen: the sheet fits a page).
const COLUMNS: usize = 4;
/// Most pixels of a sheet [px] (chosen: 130 MB, and as much again while it is encoded).
const MOST_PIXELS: usize = 32_000_000;

/// Draws the times [s] in their order, row by row, each in a size [px].
pub fn contact_sheet(series: &mut Series, times: &[f64], size: [u32; 2]) -> Result<Picture, CliError> {
    let each = size.map(|side| side as usize);
    let mut order: Vec<usize> = (0..times.len()).collect();
    order.sort_by(|a, b| times[*a].total_cmp(&times[*b]));
    let progress = Progress::over(times.len() as u64);
    let mut rows = Rows::new(times.len(), COLUMNS, each);
    for k in order {
        progress.next(format!("drawing {}", duration(times[k])));
        rows.place(k, &series.at(times[k])?.ok_or_else(|| series.past_the_end(times[k]))?);
    }
    Ok(rows.into_picture())
}

/// Refuses a sheet of so many pictures of a size [px] that would take too much memory.
pub fn check_sheet(count: usize, size: [u32; 2]) -> Result<(), CliError> {
    let [width, height] = extent(count, COLUMNS, size.map(|side| side as usize));
    let pixels = width.saturating_mul(height);
    if pixels <= MOST_PIXELS {
        return Ok(());
    }
    let fit = MOST_PIXELS * count / pixels;
    let message = format!("asks for a sheet of {width} × {height} pixels, of which at most {MOST_PIXELS} are drawn");
    Err(CliError::place("--contact-sheet", message, format!("name at most {fit} times, or write a smaller --size")))
}
