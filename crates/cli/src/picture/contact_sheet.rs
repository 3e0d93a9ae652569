//! Pictures of several times of a cook in one.

use saute_picture::cut::section::Picture;
use saute_picture::still::series::Series;

use crate::error::CliError;
use crate::output::progress::Progress;
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
    Ok(in_rows(&pictures.into_iter().flatten().collect::<Vec<_>>()))
}

/// Pictures of one size in rows.
fn in_rows(pictures: &[Picture]) -> Picture {
    let columns = pictures.len().clamp(1, COLUMNS);
    let [wide, high] = pictures.first().map_or([0, 0], |p| [p.width, p.height]);
    let [width, height] = [columns * wide, pictures.len().div_ceil(columns) * high];
    let mut rgba = [24, 24, 24, 255].repeat(width * height);
    for (k, picture) in pictures.iter().enumerate() {
        let (left, top) = (k % columns * wide, k / columns * high);
        for (y, row) in picture.rgba.chunks_exact(4 * wide).enumerate() {
            let at = 4 * ((top + y) * width + left);
            rgba[at..at + row.len()].copy_from_slice(row);
        }
    }
    Picture { width, height, rgba }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_stand_in_rows_of_four() {
        let one = |value: u8| Picture { width: 2, height: 1, rgba: vec![value; 8] };
        let sheet = in_rows(&[one(1), one(2), one(3), one(4), one(5)]);
        assert_eq!([sheet.width, sheet.height], [8, 2]);
        let first_of = |k: usize| sheet.rgba[4 * (k / 4 * 8 + k % 4 * 2)];
        assert_eq!([0, 1, 2, 3, 4, 5].map(first_of), [1, 2, 3, 4, 5, 24]);
    }
}
