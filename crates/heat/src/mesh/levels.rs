//! Graded node levels along the path of a swept body, fine at both faces.

/// Returns the heights of the node levels from 0 to `thickness`, symmetric, with one at mid-height [m].
///
/// The spacing starts at `first` at both faces, grows by the factor `growth` ≥ 1 per layer and is limited to `largest`. All
/// spacings are then scaled by one factor ≤ 1 so that they fill the thickness.
///
/// ```
/// let levels_m = saute_heat::graded_levels(0.024, 1e-3, 2.0, 4e-3);
/// let spacings_mm: Vec<f64> = levels_m.windows(2).map(|w| (1e4 * (w[1] - w[0])).round() / 10.0).collect();
/// assert_eq!(spacings_mm, [0.8, 1.6, 3.2, 3.2, 3.2, 3.2, 3.2, 3.2, 1.6, 0.8]);
/// ```
pub fn graded_levels(thickness: f64, first: f64, growth: f64, largest: f64) -> Vec<f64> {
    let half = 0.5 * thickness;
    let mut spacings = vec![first.min(half)];
    while spacings.iter().sum::<f64>() < half * (1.0 - 1e-9) {
        let last = spacings[spacings.len() - 1];
        spacings.push((last * growth).min(largest));
    }
    let scale = half / spacings.iter().sum::<f64>();
    let mut levels = vec![0.0];
    for spacing in spacings.iter().chain(spacings.iter().rev()) {
        levels.push(levels[levels.len() - 1] + spacing * scale);
    }
    let middle = spacings.len();
    levels[middle] = half;
    levels[2 * middle] = thickness;
    levels
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_fill_the_thickness_symmetrically() {
        let levels = graded_levels(0.025, 0.35e-3, 1.4, 2.5e-3);
        assert_eq!((levels[0], levels[levels.len() - 1]), (0.0, 0.025));
        for (low, high) in levels.iter().zip(levels.iter().rev()) {
            assert!((low + high - 0.025).abs() < 1e-15);
        }
        assert!(levels.windows(2).all(|w| w[1] > w[0] && w[1] - w[0] <= 2.5e-3 + 1e-12));
        assert!(levels[1] <= 0.35e-3 + 1e-12);
    }

    #[test]
    fn a_thin_body_still_has_a_middle() {
        assert_eq!(graded_levels(1.0e-3, 0.35e-3, 1.4, 2.5e-3).len(), 5);
        assert_eq!(graded_levels(0.5e-3, 1e-3, 1.4, 2.5e-3), vec![0.0, 0.25e-3, 0.5e-3]);
    }
}
