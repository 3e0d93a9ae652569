//! The design for Sobol' indices `[@saltelli-2010]`: from two independent points A and B of each base row, A, B, and A with one
//! coordinate of B for each value.

use crate::design::sobol;

/// Place of the row A in its block.
pub const A: usize = 0;
/// Place of the row B in its block.
pub const B: usize = 1;

/// Returns the point of a row.
pub fn point(row: u64, dimensions: usize, seed: u64) -> Vec<f64> {
    let block = dimensions as u64 + 2;
    let (base, place) = (row / block, (row % block) as usize);
    let from_b = |d: usize| place == B || place == d + 2;
    let coordinate = |d: usize| sobol::shifted(base, if from_b(d) { dimensions + d } else { d }, seed);
    (0..dimensions).map(coordinate).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_for_a_value_differs_from_a_in_that_value_only_and_has_b_s_there() {
        let block: Vec<Vec<f64>> = (15..20).map(|row| point(row, 3, 4)).collect();
        for d in 0..3 {
            let expected: Vec<f64> = (0..3).map(|other| block[if other == d { B } else { A }][other]).collect();
            assert_eq!(block[2 + d], expected);
        }
        assert_ne!(block[A], block[B]);
    }
}
