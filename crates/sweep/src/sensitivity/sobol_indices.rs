//! Sobol' indices: the share of a number's variance that a value causes alone (first order), and with all others (total).
//!
//! First order by the estimator of Saltelli, total by that of Jansen, both in `[@saltelli-2010]`. Intervals hold the middle 90 % of the
//! estimates from base rows that are drawn with replacement.

use saute_kitchen::heat::sorted::{Quantile, Sorted};

use crate::design::random;
use crate::design::saltelli::{A, B};
use crate::sensitivity::{mean, whole_blocks};

/// Draws of base rows for the intervals [-] (chosen: ends of the interval are known to a tenth of its width).
const DRAWS: u64 = 400;
/// Share of the draws below and above an interval [-].
const TAIL: f64 = 0.05;

/// An estimate with its 90 % interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// Estimate.
    pub value: f64,
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
}

/// The indices of one value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Indices {
    /// Share of the variance that it causes alone [-].
    pub first: Estimate,
    /// Share that it causes alone and with others [-].
    pub total: Estimate,
}

/// What a number depends on.
#[derive(Clone, Debug, PartialEq)]
pub struct SobolIndices {
    /// Indices of each value, in their order.
    pub of: Vec<Indices>,
    /// Base rows that were used [-].
    pub used: usize,
    /// Base rows that were left out, as a row of them has no number [-].
    pub left_out: usize,
}

/// Returns the indices of so many values from a number of every row; none if it hardly varies or too few rows have it.
pub fn sobol_indices(numbers: &[Option<f64>], values: usize, seed: u64) -> Option<SobolIndices> {
    let blocks = whole_blocks(numbers, values + 2);
    if blocks.len() < 2 {
        return None;
    }
    let centred = centred(blocks);
    let all: Vec<usize> = (0..centred.len()).collect();
    let [first, total] = estimates(&centred, values, &all)?;
    let drawn: Vec<[Vec<f64>; 2]> =
        (0..DRAWS).filter_map(|draw| estimates(&centred, values, &draw_of(draw, centred.len(), seed))).collect();
    let of = (0..values)
        .map(|d| Indices {
            first: estimate(first[d], drawn.iter().map(|one| one[0][d]).collect()),
            total: estimate(total[d], drawn.iter().map(|one| one[1][d]).collect()),
        })
        .collect();
    let left_out = numbers.len() / (values + 2) - centred.len();
    Some(SobolIndices { of, used: centred.len(), left_out })
}

/// The mean is taken away: the first estimator is far off where it is large compared with the scatter.
fn centred(mut blocks: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let middle = mean(blocks.iter().map(|rows| (rows[A] + rows[B]) / 2.0));
    blocks.iter_mut().flatten().for_each(|number| *number -= middle);
    blocks
}

fn draw_of(draw: u64, count: usize, seed: u64) -> Vec<usize> {
    (0..count as u64).map(|i| random::below(count as u64, seed, &[7, draw, i]) as usize).collect()
}

/// Returns first-order and total indices from some of the blocks; none if the number does not vary in them.
fn estimates(blocks: &[Vec<f64>], values: usize, chosen: &[usize]) -> Option<[Vec<f64>; 2]> {
    let rows = || chosen.iter().map(|i| &blocks[*i]);
    let middle = mean(rows().map(|row| (row[A] + row[B]) / 2.0));
    let variance = mean(rows().map(|row| ((row[A] - middle).powi(2) + (row[B] - middle).powi(2)) / 2.0));
    let largest = rows().flatten().fold(0.0_f64, |most, v| most.max(v.abs()));
    // Rounding is no variance.
    if variance <= (1e-12 * largest).powi(2) {
        return None;
    }
    let first = (0..values).map(|d| mean(rows().map(|row| row[B] * (row[d + 2] - row[A]))) / variance);
    let total = (0..values).map(|d| mean(rows().map(|row| (row[A] - row[d + 2]).powi(2))) / (2.0 * variance));
    Some([first.collect(), total.collect()])
}

fn estimate(value: f64, drawn: Vec<f64>) -> Estimate {
    let drawn = Sorted::new(drawn);
    let at = |share: f64| drawn.quantile(share, Quantile::After).unwrap_or(value);
    Estimate { value, low: at(TAIL), high: at(1.0 - TAIL) }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::design::{Design, DesignKind};

    /// The Ishigami function, whose indices are known in closed form.
    fn ishigami(point: &[f64]) -> f64 {
        let [x, y, z] = [0, 1, 2].map(|d| core::f64::consts::PI * (2.0 * point[d] - 1.0));
        x.sin() + 7.0 * y.sin().powi(2) + 0.1 * z.powi(4) * x.sin()
    }

    #[test]
    fn indices_of_the_ishigami_function_are_those_of_its_closed_form() {
        let design = Design { kind: DesignKind::Saltelli, n: 2048, seed: 1, levels: vec![0; 3] };
        let numbers: Vec<Option<f64>> =
            (0..design.rows().unwrap()).map(|row| Some(1e4 + ishigami(&design.point(row)))).collect();
        let found = sobol_indices(&numbers, 3, 1).unwrap();
        for (index, [first, total]) in found.of.iter().zip([[0.3139, 0.5576], [0.4424, 0.4424], [0.0, 0.2437]]) {
            assert!((index.first.value - first).abs() < 0.03 && (index.total.value - total).abs() < 0.03, "{found:?}");
            assert!(index.total.low <= index.total.value && index.total.value <= index.total.high);
        }
    }

    #[test]
    fn a_base_row_with_a_failure_is_left_out_and_a_constant_has_no_indices() {
        let mut numbers: Vec<Option<f64>> = (0..40).map(|i| Some(f64::from(i * i % 17))).collect();
        numbers[5] = None;
        let found = sobol_indices(&numbers, 2, 1).unwrap();
        assert_eq!((found.used, found.left_out), (9, 1));
        assert_eq!(sobol_indices(&[Some(3.0); 40], 2, 1), None);
        assert_eq!(sobol_indices(&[None; 40], 2, 1), None);
    }
}
