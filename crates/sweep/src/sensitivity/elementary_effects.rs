//! Elementary effects `[@morris-1991]`: how a number changes when one value alone goes from one end of its range to the other,
//! from steps of two thirds of the range at many places.

use crate::design::Design;
use crate::sensitivity::{mean, whole_blocks};

/// The effect of one value, over its whole range, in the unit of the number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effect {
    /// Mean of the effects.
    pub mean: f64,
    /// Mean of their sizes, without signs: how much the value matters.
    pub mean_size: f64,
    /// Their standard deviation: how much the effect depends on the other values, or bends.
    pub deviation: f64,
}

/// What a number depends on.
#[derive(Clone, Debug, PartialEq)]
pub struct ElementaryEffects {
    /// Effect of each value, in their order.
    pub of: Vec<Effect>,
    /// Trajectories that were used [-].
    pub used: usize,
    /// Trajectories that were left out, as a row of them has no number [-].
    pub left_out: usize,
}

/// Returns the effects of the values of a `morris` design on a number of every row; none if too few rows have it.
pub fn elementary_effects(numbers: &[Option<f64>], design: &Design) -> Option<ElementaryEffects> {
    let block = design.dimensions() + 1;
    let mut effects = vec![Vec::new(); design.dimensions()];
    for (trajectory, rows) in numbers.chunks_exact(block).enumerate() {
        let Some(rows) = rows.iter().copied().collect::<Option<Vec<f64>>>() else { continue };
        let first = (trajectory * block) as u64;
        let points: Vec<Vec<f64>> = (0..block as u64).map(|k| design.point(first + k)).collect();
        for (pair, number) in points.windows(2).zip(rows.windows(2)) {
            let moved = (0..design.dimensions()).find(|d| pair[0][*d] != pair[1][*d])?;
            effects[moved].push((number[1] - number[0]) / (pair[1][moved] - pair[0][moved]));
        }
    }
    let used = whole_blocks(numbers, block).len();
    let of = (used >= 2).then(|| effects.iter().map(|own| effect(own)).collect())?;
    Some(ElementaryEffects { of, used, left_out: numbers.len() / block - used })
}

fn effect(effects: &[f64]) -> Effect {
    let middle = mean(effects.iter().copied());
    let squares: f64 = effects.iter().map(|e| (e - middle).powi(2)).sum();
    let deviation = libm::sqrt(squares / (effects.len() as f64 - 1.0));
    Effect { mean: middle, mean_size: mean(effects.iter().map(|e| e.abs())), deviation }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::design::DesignKind;

    #[test]
    fn effects_of_a_plane_are_its_slopes_and_a_product_has_a_deviation() {
        let design = Design { kind: DesignKind::Morris, n: 20, seed: 3, levels: vec![0; 3] };
        let points = (0..design.rows().unwrap()).map(|row| design.point(row));
        let mut numbers: Vec<_> = points.map(|p| Some(5.0 - 2.0 * p[0] + 8.0 * p[1] * p[2])).collect();
        numbers[0] = None;
        let found = elementary_effects(&numbers, &design).unwrap();
        assert_eq!((found.used, found.left_out), (19, 1));
        let plane = found.of[0];
        assert!((plane.mean + 2.0).abs() < 1e-12 && (plane.mean_size - 2.0).abs() < 1e-12 && plane.deviation < 1e-9);
        assert!(found.of[1].deviation > 1.0 && found.of[1].mean_size > 2.0, "{found:?}");
    }
}
