//! Pictures of one size in rows.

use saute_picture::cut::section::Picture;

/// Gap between two pictures [px] (chosen).
pub const GAP: usize = 8;
/// Colour of the gap (chosen: that of a dark page).
const GROUND: [u8; 4] = [24, 24, 24, 255];

/// Sets pictures in rows of so many, with a gap between.
pub fn in_rows(pictures: &[Picture], columns: usize) -> Picture {
    let columns = pictures.len().clamp(1, columns);
    let [wide, high] = pictures.first().map_or([0, 0], |p| [p.width, p.height]);
    let rows = pictures.len().div_ceil(columns);
    let [width, height] = [columns * (wide + GAP) - GAP, (rows * (high + GAP)).saturating_sub(GAP)];
    let mut rgba = GROUND.repeat(width * height);
    for (k, picture) in pictures.iter().enumerate() {
        let (left, top) = (k % columns * (wide + GAP), k / columns * (high + GAP));
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
    fn pictures_stand_in_rows_with_gaps() {
        let one = |value: u8| Picture { width: 2, height: 1, rgba: vec![value; 8] };
        let sheet = in_rows(&[one(1), one(2), one(3), one(4), one(5)], 4);
        assert_eq!([sheet.width, sheet.height], [4 * 2 + 3 * GAP, 2 + GAP]);
        let first_of = |k: usize| sheet.rgba[4 * (k / 4 * (1 + GAP) * sheet.width + k % 4 * (2 + GAP))];
        assert_eq!([0, 1, 2, 3, 4, 5].map(first_of), [1, 2, 3, 4, 5, 24]);
    }
}
