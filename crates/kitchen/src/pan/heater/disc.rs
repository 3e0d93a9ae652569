//! A heater that is a disc: how much of it is under each place of a pan.

use core::f64::consts::PI;

/// Share of a disc of radius `radius` [m] under each floor node, with the pan's middle at `at` [m] from the disc's [-].
///
/// The shares sum to 1 where the floor covers the disc, to the covered part elsewhere.
pub(crate) fn disc_shares(radius: f64, points: &[[f64; 2]], areas: &[f64], at: [f64; 2]) -> Vec<f64> {
    let inside = |p: &[f64; 2], at: [f64; 2]| libm::hypot(p[0] + at[0], p[1] + at[1]) <= radius;
    let on = |at: [f64; 2]| points.iter().zip(areas).map(move |(p, a)| if inside(p, at) { *a } else { 0.0 });
    let (disc, floor): (f64, f64) = (PI * radius * radius, areas.iter().sum());
    // The nodes inside represent the whole disc where the floor covers it, whatever their size.
    let whole = if floor >= disc { on([0.0; 2]).sum::<f64>() } else { disc };
    if whole == 0.0 {
        return (0..points.len()).map(|i| if i == 0 { 1.0 } else { 0.0 }).collect();
    }
    on(at).map(|area| area / whole).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_disc_is_shared_by_what_lies_on_it_and_a_small_pan_leaves_some_free() {
        let points: Vec<[f64; 2]> = (1..11).map(|i| [0.01 * f64::from(i), 0.0]).collect();
        let areas = [0.003; 10];
        let sum = |radius: f64, at: [f64; 2]| disc_shares(radius, &points, &areas, at).iter().sum::<f64>();
        assert!((sum(0.06, [0.0; 2]) - 1.0).abs() < 1e-12);
        assert!(sum(0.06, [0.04, 0.0]) < 0.5, "moved away");
        let free = 0.03 / (PI * 0.04);
        assert!((sum(0.2, [0.0; 2]) - free).abs() < 1e-9, "{} of {free}", sum(0.2, [0.0; 2]));
        assert_eq!(sum(1e-9, [0.0; 2]), 1.0, "a disc between two nodes counts as in the middle");
    }
}
