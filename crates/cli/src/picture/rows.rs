//! Pictures of one size in rows.

use saute_picture::cut::section::Picture;

/// Gap between two pictures [px] (chosen).
pub const GAP: usize = 8;
/// Colour of the gap (chosen: that of a dark page).
const GROUND: [u8; 4] = [24, 24, 24, 255];

/// A sheet of pictures of one size in rows, with a gap between; each is copied where it belongs, and need not be kept.
pub struct Rows {
    columns: usize,
    /// Width and height of a picture [px].
    each: [usize; 2],
    sheet: Picture,
}

impl Rows {
    /// Returns an empty sheet for a number of pictures of a size [px], in rows of so many.
    pub fn new(count: usize, columns: usize, each: [usize; 2]) -> Self {
        let columns = count.clamp(1, columns);
        let [width, height] = extent(count, columns, each);
        Self { columns, each, sheet: Picture { width, height, rgba: GROUND.repeat(width * height) } }
    }

    /// Copies the picture of a number, counted row by row, to its place.
    pub fn place(&mut self, k: usize, picture: &Picture) {
        let ([wide, high], columns) = (self.each, self.columns);
        let (left, top) = (k % columns * (wide + GAP), k / columns * (high + GAP));
        for (y, row) in picture.rgba.chunks_exact(4 * wide).enumerate() {
            let at = 4 * ((top + y) * self.sheet.width + left);
            self.sheet.rgba[at..at + row.len()].copy_from_slice(row);
        }
    }

    /// Returns the sheet.
    pub fn into_picture(self) -> Picture {
        self.sheet
    }
}

/// Width and height of a sheet [px].
pub fn extent(count: usize, columns: usize, [wide, high]: [usize; 2]) -> [usize; 2] {
    let columns = count.clamp(1, columns);
    [columns * (wide + GAP) - GAP, (count.div_ceil(columns) * (high + GAP)).saturating_sub(GAP)]
}

/// Sets pictures in rows of so many, with a gap between.
pub fn in_rows(pictures: &[Picture], columns: usize) -> Picture {
    let each = pictures.first().map_or([0, 0], |p| [p.width, p.height]);
    let mut rows = Rows::new(pictures.len(), columns, each);
    pictures.iter().enumerate().for_each(|(k, picture)| rows.place(k, picture));
    rows.into_picture()
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
