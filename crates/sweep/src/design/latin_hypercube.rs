//! The Latin hypercube: with `n` rows, every value is in each of `n` equal strata once `[@mckay-1979]`.
//!
//! The strata of a value are a random permutation of the rows. The permutation is a Feistel network over the next power of four,
//! walked until it falls below `n`, so that it takes no memory.

use crate::design::random;

/// Rounds of the network [-] (chosen: four make every output depend on every input; two more are cheap).
const ROUNDS: u64 = 6;

/// Returns the coordinate of a row in one dimension, of 0 to 1.
pub fn coordinate(row: u64, dimension: usize, n: u64, seed: u64) -> f64 {
    let dimension = dimension as u64;
    let within = random::unit(seed, &[1, dimension, row]);
    // A stratum of a huge sample is narrower than rounding: the last point stays below 1.
    ((stratum(row, n, random::bits(seed, &[2, dimension])) as f64 + within) / n as f64).min(1.0 - f64::EPSILON)
}

/// Returns the stratum of a row: a permutation of the rows below `n`.
fn stratum(row: u64, n: u64, key: u64) -> u64 {
    let bits = u64::BITS - n.saturating_sub(1).leading_zeros();
    let half = bits.div_ceil(2).max(1);
    let mut at = row;
    loop {
        at = scrambled(at, half, key);
        if at < n {
            return at;
        }
    }
}

fn scrambled(number: u64, half: u32, key: u64) -> u64 {
    let mask = (1_u64 << half) - 1;
    let (mut left, mut right) = (number >> half, number & mask);
    for round in 0..ROUNDS {
        (left, right) = (right, left ^ (random::bits(key, &[round, right]) & mask));
    }
    (left << half) | right
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_stratum_of_every_value_has_one_row() {
        for n in [1, 2, 7, 64, 1000] {
            for dimension in 0..3 {
                let mut hit = vec![false; n];
                for row in 0..n {
                    let at = (coordinate(row as u64, dimension, n as u64, 9) * n as f64) as usize;
                    assert!(!std::mem::replace(&mut hit[at], true), "stratum {at} of {n} twice");
                }
            }
        }
    }

    #[test]
    fn values_are_not_correlated_and_a_seed_changes_them() {
        let column = |d, seed| (0..500).map(move |row| coordinate(row, d, 500, seed) - 0.5);
        let correlation: f64 = column(0, 1).zip(column(1, 1)).map(|(a, b)| a * b).sum::<f64>() / 500.0 * 12.0;
        assert!(correlation.abs() < 0.15, "{correlation}");
        assert!(column(0, 1).ne(column(0, 2)));
    }
}
