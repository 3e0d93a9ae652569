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
    values: Vec<f64>,
}

impl Table {
    /// Tabulates `f` at `start`, `start + step`, … up to `end`, in the unit of `f`.
    pub fn new(start: f64, end: f64, step: f64, f: impl Fn(f64) -> f64) -> Self {
        let count = libm::ceil((end - start) / step) as usize + 1;
        Self { start, per_unit: 1.0 / step, values: (0..count).map(|i| f(start + i as f64 * step)).collect() }
    }

    /// Returns the value at `x`, in the unit of the tabulated function.
    #[inline]
    pub fn at(&self, x: f64) -> f64 {
        let (cell, share) = self.place(x);
        self.within(cell, share)
    }

    /// Returns the cell of `x` and the relative position in it; the same for all tables with one grid [-].
    #[inline]
    pub(crate) fn place(&self, x: f64) -> (usize, f64) {
        let last = self.values.len() - 1;
        let position = ((x - self.start) * self.per_unit).clamp(0.0, last as f64);
        let cell = (position as u32 as usize).min(last - 1);
        (cell, position - cell as f64)
    }

    /// Returns the value at a relative position in a cell.
    #[inline]
    pub(crate) fn within(&self, cell: usize, share: f64) -> f64 {
        self.values[cell] + share * (self.values[cell + 1] - self.values[cell])
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
}
