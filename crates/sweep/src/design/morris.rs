//! The design for elementary effects `[@morris-1991]`: trajectories on four levels, in which one value after the other makes a step
//! of 2/3, in random order and direction.

use crate::design::random;

/// Levels of each value [-] (Morris: even, so that every level is as likely; four are usual).
const LEVELS: u64 = 4;
/// Length of a step [-]: `LEVELS` / (2 (`LEVELS` − 1)).
pub const STEP: f64 = 2.0 / 3.0;

/// Returns the point of a row.
pub fn point(row: u64, dimensions: usize, seed: u64) -> Vec<f64> {
    let block = dimensions as u64 + 1;
    let (trajectory, place) = (row / block, row % block);
    let order = order(trajectory, dimensions, seed);
    let coordinate = |d: usize| {
        let has_stepped = (order[d] as u64) < place;
        // Half of the levels are low; each is left for the level a step above, or the other way round.
        let low = random::below(LEVELS / 2, seed, &[4, trajectory, d as u64]) as f64 / (LEVELS - 1) as f64;
        let goes_up = random::below(2, seed, &[5, trajectory, d as u64]) == 1;
        if goes_up == has_stepped { low + STEP } else { low }
    };
    (0..dimensions).map(coordinate).collect()
}

/// Returns the number of the step in which each value moves, from 0.
pub fn order(trajectory: u64, dimensions: usize, seed: u64) -> Vec<usize> {
    let mut values: Vec<usize> = (0..dimensions).collect();
    values.sort_by_key(|d| (random::bits(seed, &[6, trajectory, *d as u64]), *d));
    let mut order = vec![0; dimensions];
    values.into_iter().enumerate().for_each(|(step, d)| order[d] = step);
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_step_of_a_trajectory_moves_one_value_by_a_step_within_the_cube() {
        for trajectory in 0..20 {
            let points: Vec<_> = (0..4).map(|k| point(4 * trajectory + k, 3, 8)).collect();
            let mut moved = Vec::new();
            for pair in points.windows(2) {
                let steps: Vec<usize> = (0..3).filter(|d| pair[0][*d] != pair[1][*d]).collect();
                assert_eq!(steps.len(), 1);
                assert!(((pair[0][steps[0]] - pair[1][steps[0]]).abs() - STEP).abs() < 1e-12);
                moved.push(steps[0]);
            }
            moved.sort_unstable();
            assert_eq!(moved, [0, 1, 2]);
            assert!(points.iter().flatten().all(|u| (0.0..=1.0).contains(u)));
        }
    }
}
