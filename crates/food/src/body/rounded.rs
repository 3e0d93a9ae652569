//! Cross-sections of round bodies: rings of nodes, fine below the skin and coarse inside.

/// Returns the radii of `intervals` rings over the radius of the skin, from 1 inwards and without the centre [-].
///
/// The first layer is about `first` [m] thick, in a body with the skin at `half` [m] from the middle. Each layer grows by
/// one factor towards the middle. A body too thin for that is divided evenly.
pub fn ring_shares(half: f64, first: f64, intervals: usize) -> Vec<f64> {
    let first = first.min(half / intervals as f64);
    let growth = growth_to_fill(half / first, intervals);
    let (mut depth, mut layer) = (0.0, first);
    let mut shares = Vec::with_capacity(intervals);
    for _ in 0..intervals {
        shares.push(1.0 - depth / half);
        depth += layer;
        layer *= growth;
    }
    shares
}

/// Returns the factor g ≥ 1 with 1 + g + … + gⁿ⁻¹ = `sum`, by bisection [-].
fn growth_to_fill(sum: f64, count: usize) -> f64 {
    let total = |growth: f64| (0..count).fold((0.0, 1.0), |(sum, term), _| (sum + term, term * growth)).0;
    let (mut low, mut high) = (1.0, 16.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if total(middle) < sum { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// Returns rings as (number of nodes, share of the radius): `around` nodes each, half as many on the innermost, and one
/// node in the centre.
pub fn ringed(around: usize, shares: &[f64]) -> Vec<(usize, f64)> {
    let last = shares.len().saturating_sub(1);
    let count = |i: usize| if i == last { around.div_ceil(2) } else { around };
    shares.iter().enumerate().map(|(i, share)| (count(i), *share)).chain([(1, 0.0)]).collect()
}

/// Number of nodes of a section of rings [-].
pub fn node_count(rings: &[(usize, f64)]) -> usize {
    rings.iter().map(|(count, _)| count).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rings_begin_at_the_skin_with_the_first_layer_and_fill_the_radius() {
        let shares = ring_shares(6.5e-3, 0.4e-3, 5);
        assert_eq!(shares.len(), 5);
        assert!((shares[0] - 1.0).abs() < 1e-12 && (6.5e-3 * (1.0 - shares[1]) - 0.4e-3).abs() < 1e-9);
        let layers: Vec<f64> =
            shares.iter().chain([&0.0]).collect::<Vec<_>>().windows(2).map(|w| w[0] - w[1]).collect();
        assert!(layers.windows(2).all(|w| w[1] > 1.2 * w[0]), "{layers:?}");
        let ratio = layers[4] / layers[3];
        assert!((layers[1] / layers[0] - ratio).abs() < 1e-6, "the last layer reaches the centre: {layers:?}");
    }

    #[test]
    fn a_thin_skin_is_divided_evenly() {
        let shares = ring_shares(1.0e-3, 0.4e-3, 5);
        assert!(shares.iter().enumerate().all(|(i, s)| (s - (1.0 - 0.2 * i as f64)).abs() < 1e-6), "{shares:?}");
    }
}
