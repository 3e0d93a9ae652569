//! Piecewise linear tables.

/// A function of one variable on an even grid: linear between the entries, constant beyond both ends.
///
/// ```
/// use saute_food::table::Table;
///
/// let table = Table::new(0.0, 10.0, 1.0, |x| x * x);
/// assert_eq!(table.at(2.5), 6.5); // linear between 4 and 9
/// assert_eq!(table.at(99.0), 100.0); // constant beyond the end
/// ```
#[derive(Clone, Debug)]
pub struct Table {
    start: f64,
    per_unit: f64,
    /// Cells between two entries: the first entry and the rise to the next one.
    cells: Vec<[f64; 2]>,
    lowest: f64,
    /// Position of the last entry, and index of the last cell.
    last: f64,
    last_cell: u32,
}

impl Table {
    /// Tabulates `f` at `start`, `start + step`, … up to `end`, in the unit of `f`.
    pub fn new(start: f64, end: f64, step: f64, f: impl Fn(f64) -> f64) -> Self {
        let count = libm::ceil((end - start) / step) as usize + 1;
        let values: Vec<f64> = (0..count).map(|i| f(start + i as f64 * step)).collect();
        Self {
            start,
            per_unit: 1.0 / step,
            cells: values.windows(2).map(|pair| [pair[0], pair[1] - pair[0]]).collect(),
            lowest: values.iter().copied().fold(f64::INFINITY, f64::min),
            last: count.saturating_sub(1) as f64,
            last_cell: count.saturating_sub(2) as u32,
        }
    }

    /// Returns the value at `x`, in the unit of the tabulated function.
    #[inline]
    pub fn at(&self, x: f64) -> f64 {
        let (cell, share) = self.place(x);
        self.within(cell, share)
    }

    /// Returns the smallest entry.
    pub(crate) fn lowest(&self) -> f64 {
        self.lowest
    }

    /// Returns the start of the last cell that is zero like all before it; the function is zero up to there.
    pub(crate) fn zero_until(&self) -> f64 {
        let zeros = self.cells.iter().take_while(|cell| **cell == [0.0; 2]).count();
        if zeros == 0 { f64::NEG_INFINITY } else { self.start + (zeros - 1) as f64 / self.per_unit }
    }

    /// Returns the cell of `x` and the relative position in it; the same for all tables with one grid [-].
    #[inline]
    pub(crate) fn place(&self, x: f64) -> (usize, f64) {
        let position = (x - self.start) * self.per_unit;
        // As `clamp`, without its check of the bounds.
        let position = if position < 0.0 { 0.0 } else { position };
        let position = if position > self.last { self.last } else { position };
        let cell = (position as u32).min(self.last_cell);
        (cell as usize, position - f64::from(cell))
    }

    /// Returns the value at a relative position in a cell.
    #[inline]
    pub(crate) fn within(&self, cell: usize, share: f64) -> f64 {
        let [entry, rise] = self.cells[cell];
        entry + share * rise
    }
}

/// Returns the piecewise linear value at `x` through the points (`xs`, `ys`), constant beyond both ends.
///
/// `xs` ascend and hold at least two values.
pub fn interpolate(xs: &[f64], ys: &[f64], x: f64) -> f64 {
    let upper = xs.partition_point(|&v| v < x).clamp(1, xs.len() - 1);
    let share = ((x - xs[upper - 1]) / (xs[upper] - xs[upper - 1])).clamp(0.0, 1.0);
    ys[upper - 1] + share * (ys[upper] - ys[upper - 1])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_exact_and_the_ends_are_held() {
        let table = Table::new(1.0, 3.0, 0.5, |x| 2.0 * x);
        assert!((table.at(1.7) - 3.4).abs() < 1e-12);
        assert_eq!((table.at(0.0), table.at(9.0)), (2.0, 6.0));
    }

    #[test]
    fn a_table_is_zero_up_to_its_last_cell_of_zeros() {
        let table = Table::new(0.0, 5.0, 0.5, |x| (x - 3.0).max(0.0));
        assert_eq!((table.zero_until(), table.at(2.5), table.at(3.25)), (2.5, 0.0, 0.25));
        assert_eq!(Table::new(0.0, 5.0, 0.5, |x| x + 1.0).zero_until(), f64::NEG_INFINITY);
    }
}
