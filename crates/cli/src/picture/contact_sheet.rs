//! Pictures of several times of a cook in one.

use saute_picture::cut::section::Picture;
use saute_picture::still::series::Series;

use crate::error::CliError;
use crate::output::progress::Progress;
use crate::picture::rows::in_rows;
use crate::wording::duration;

/// Pictures in a row (chosen: the sheet fits a page).
const COLUMNS: usize = 4;

/// Draws the times [s] in their order, row by row.
pub fn contact_sheet(series: &mut Series, times: &[f64]) -> Result<Picture, CliError> {
    let mut order: Vec<usize> = (0..times.len()).collect();
    order.sort_by(|a, b| times[*a].total_cmp(&times[*b]));
    let progress = Progress::over(times.len() as u64);
    let mut pictures = vec![None; times.len()];
    for k in order {
        progress.next(format!("drawing {}", duration(times[k])));
        pictures[k] = Some(series.at(times[k])?.ok_or_else(|| series.past_the_end(times[k]))?);
    }
    Ok(in_rows(&pictures.into_iter().flatten().collect::<Vec<_>>(), COLUMNS))
}
