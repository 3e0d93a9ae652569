//! The Sobol' sequence in the order of the Gray code `[@joe-kuo-2008]`, with a random digital shift.

use crate::design::random;
use crate::design::sobol_directions::DIRECTIONS;

/// Bits of a coordinate [-]: as many rows have distinct points.
const BITS: u32 = 32;

/// Returns a coordinate of a point of the plain sequence, of 0 to 1.
pub fn coordinate(index: u64, dimension: usize) -> f64 {
    to_unit(digits(index, dimension))
}

/// Returns a coordinate of a point with the digits of each dimension shifted at random; the plain one for the seed 0.
pub fn shifted(index: u64, dimension: usize, seed: u64) -> f64 {
    let shift = if seed == 0 { 0 } else { (random::bits(seed, &[3, dimension as u64]) >> BITS) as u32 };
    to_unit(digits(index, dimension) ^ shift)
}

fn to_unit(digits: u32) -> f64 {
    f64::from(digits) / (1_u64 << BITS) as f64
}

fn digits(index: u64, dimension: usize) -> u32 {
    let gray = index ^ (index >> 1);
    let directions = directions(dimension);
    (0..BITS as usize).filter(|bit| gray >> bit & 1 == 1).fold(0, |digits, bit| digits ^ directions[bit])
}

/// Returns the direction numbers of a dimension as fractions of 2³².
fn directions(dimension: usize) -> [u32; BITS as usize] {
    let Some((polynomial, initial)) = dimension.checked_sub(1).and_then(|d| DIRECTIONS.get(d)) else {
        return core::array::from_fn(|bit| 1 << (BITS as usize - 1 - bit));
    };
    let degree = initial.len();
    let mut numbers = [0; BITS as usize];
    for bit in 0..BITS as usize {
        numbers[bit] = match initial.get(bit) {
            Some(number) => number << (BITS as usize - 1 - bit),
            None => (1..degree)
                .filter(|k| polynomial >> (degree - k) & 1 == 1)
                .fold(numbers[bit - degree] ^ (numbers[bit - degree] >> degree), |v, k| v ^ numbers[bit - k]),
        };
    }
    numbers
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::MOST_DIMENSIONS;

    #[test]
    fn the_first_points_are_those_that_are_published() {
        let points: Vec<[f64; 3]> = (0..8).map(|i| [0, 1, 2].map(|d| coordinate(i, d))).collect();
        let known = [
            [0.0, 0.0, 0.0],
            [0.5, 0.5, 0.5],
            [0.75, 0.25, 0.25],
            [0.25, 0.75, 0.75],
            [0.375, 0.375, 0.625],
            [0.875, 0.875, 0.125],
            [0.625, 0.125, 0.875],
            [0.125, 0.625, 0.375],
        ];
        assert_eq!(points, known);
    }

    #[test]
    fn every_dimension_fills_every_interval_of_a_power_of_two_once_with_and_without_a_shift() {
        for (dimension, seed) in (0..MOST_DIMENSIONS).flat_map(|d| [(d, 0), (d, 5)]) {
            let mut hit = [false; 256];
            (0..256).for_each(|i| hit[(256.0 * shifted(i, dimension, seed)) as usize] = true);
            assert!(hit.iter().all(|hit| *hit), "dimension {dimension}");
        }
    }
}
