//! Values in order, for their quantiles and their median.

/// Which of n values is the quantile of a share. The definitions differ by less than the distance of two neighbours. Each result
/// keeps the one by which it is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantile {
    /// Linear between the two values next to the place share · (n − 1).
    Linear,
    /// The value at the place share · (n − 1), rounded.
    Nearest,
    /// The value at the place share · (n − 1), rounded down.
    Below,
    /// The smallest value that at least the share of the values does not exceed: the place share · n, rounded up, less 1.
    Reached,
    /// The first value after the share of the values: the place share · n, rounded down.
    After,
}

/// Values in ascending order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sorted(Vec<f64>);

impl Sorted {
    /// Sorts values.
    pub fn new(mut values: Vec<f64>) -> Self {
        values.sort_by(f64::total_cmp);
        Self(values)
    }

    /// Returns the values, ascending.
    pub fn values(&self) -> &[f64] {
        &self.0
    }

    /// Returns the quantile of a share from 0 to 1; none of no values.
    pub fn quantile(&self, share: f64, of: Quantile) -> Option<f64> {
        let (n, last) = (self.0.len() as f64, self.0.len().checked_sub(1)?);
        let at = share * last as f64;
        let place = match of {
            Quantile::Linear => return Some(self.between(at)),
            Quantile::Nearest => libm::round(at),
            Quantile::Below => libm::floor(at),
            Quantile::Reached => libm::ceil(share * n) - 1.0,
            Quantile::After => libm::floor(share * n),
        };
        // A place below 0 becomes 0.
        Some(self.0[(place as usize).min(last)])
    }

    /// Returns the median: of an even number of values the mean of the two in the middle; none of no values.
    pub fn median(&self) -> Option<f64> {
        let count = self.0.len();
        let (upper, lower) = (self.0.get(count / 2)?, self.0.get((count - 1) / 2)?);
        Some(0.5 * (upper + lower))
    }

    /// Returns the value at a place between two values, linear between them.
    fn between(&self, at: f64) -> f64 {
        let (low, high) = (self.0[libm::floor(at) as usize], self.0[libm::ceil(at) as usize]);
        low + (at - libm::floor(at)) * (high - low)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_median_has_half_of_the_values_on_either_side() {
        let median = |values: &[f64]| Sorted::new(values.to_vec()).median();
        assert_eq!(median(&[3.0, 1.0, 2.0]), Some(2.0));
        assert_eq!(median(&[4.0, 1.0, 2.0, 3.0]), Some(2.5));
        assert_eq!(median(&[]), None);
    }

    #[test]
    fn each_definition_names_its_place() {
        let sorted = Sorted::new((1..=10).rev().map(f64::from).collect());
        let of = |share: f64| {
            [Quantile::Linear, Quantile::Nearest, Quantile::Below, Quantile::Reached, Quantile::After]
                .map(|definition| sorted.quantile(share, definition))
        };
        assert_eq!(of(0.25), [3.25, 3.0, 3.0, 3.0, 3.0].map(Some));
        assert_eq!(of(0.75), [7.75, 8.0, 7.0, 8.0, 8.0].map(Some));
        assert_eq!(of(0.5), [5.5, 6.0, 5.0, 5.0, 6.0].map(Some));
        assert_eq!(of(0.0), [1.0; 5].map(Some));
        assert_eq!(of(1.0), [10.0; 5].map(Some));
        assert_eq!(Sorted::default().quantile(0.5, Quantile::After), None);
    }
}
