//! A piece as it differs from the mean of its food: composition, direction of the fibres, unevenness, and water that heating releases.

use crate::description::{Anisotropy, Composition, FoodDescription, Kinetics, PieceSpread};
use crate::piece_spec::PieceSpec;
use crate::tissue::noise::uniform;

/// Where the numbers of one piece are in the stream of its seed.
const STREAM: u64 = 700;
/// Summands of a bell: their sum has a standard deviation of half of one, and ends at three of them.
const SUMMANDS: u64 = 3;
/// Share of water or fat that a piece keeps at least [-] (chosen: as in the files of foods).
const LEAST_SHARE: f64 = 0.001;

/// An individual piece: its food, its kinetics, and its size as cut.
pub(crate) type Individual = (FoodDescription, Kinetics, PieceSpec);

/// The individual piece of a seed, of a food with a spread.
///
/// Each number strays by its own bell (the sum of three uniform ones, within three standard deviations), independent of the others.
pub(crate) fn individual(
    food: &FoodDescription,
    spread: &PieceSpread,
    kinetics: &Kinetics,
    piece: &PieceSpec,
) -> Individual {
    let (mut food, mut kinetics, piece, seed) = (food.clone(), kinetics.clone(), as_cut(food, piece), piece.seed);
    food.lean = strayed(&food.lean, spread, bell(seed, 0), bell(seed, 1));
    food.anisotropy = food.anisotropy.as_ref().map(|mean| turned(mean, spread.fibre_deg * bell(seed, 2)));
    food.outline.wedge += spread.wedge * bell(seed, 3).abs();
    let released = (1.0 + spread.released * bell(seed, 4)).max(0.0);
    let holding = &mut kinetics.water_holding;
    holding.drop = (holding.drop * released).min(1.0 - LEAST_SHARE);
    holding.change.values_mut().for_each(|share| *share *= released);
    (food, kinetics, piece)
}

/// What a piece is built from, with its thickness as cut.
pub(crate) fn as_cut(food: &FoodDescription, piece: &PieceSpec) -> PieceSpec {
    let spread = food.spread.as_ref().filter(|_| piece.is_individual());
    let thicker = spread.map_or(1.0, |spread| 1.0 + spread.thickness * bell(piece.seed, 5));
    let [length, width, thickness] = piece.size;
    PieceSpec { size: [length, width, thickness * thicker], ..*piece }
}

/// A number with mean 0 and standard deviation 1, within ±3.
fn bell(seed: u64, number: u64) -> f64 {
    let sum: f64 = (0..SUMMANDS).map(|k| uniform(seed, STREAM + SUMMANDS * number + k)).sum();
    2.0 * (sum - 0.5 * SUMMANDS as f64)
}

/// Lean flesh with other shares of fat and of water; what else there is keeps its proportions, and all add up to 1 as before.
fn strayed(mean: &Composition, spread: &PieceSpread, fat: f64, water: f64) -> Composition {
    let total = mean.total();
    // What is fat for the most part becomes no fatter: the rest keeps room for water and solids.
    let fattest = (0.5 * total).max(mean.fat);
    let new_fat = (mean.fat + spread.fat * fat).clamp(LEAST_SHARE.min(mean.fat), fattest);
    // Fat takes the place of everything else.
    let left = (total - new_fat) / (total - mean.fat);
    let solids = mean.protein + mean.carbohydrate + mean.fibre + mean.ash;
    let new_water =
        (mean.water * left + spread.water * water).clamp(LEAST_SHARE, (mean.water + solids) * left - LEAST_SHARE);
    let rest = ((mean.water + solids) * left - new_water) / solids;
    Composition {
        water: new_water,
        fat: new_fat,
        protein: rest * mean.protein,
        carbohydrate: rest * mean.carbohydrate,
        fibre: rest * mean.fibre,
        ash: rest * mean.ash,
        ..mean.clone()
    }
}

/// Conductivities with the fibres turned out of the direction of the thickness by an angle [°]: k = k_along·cos² + k_across·sin² through the
/// thickness; in the plane the mean over its directions, so that their sum stays.
fn turned(mean: &Anisotropy, deg: f64) -> Anisotropy {
    let sin = libm::sin(deg.to_radians());
    let share = sin * sin;
    let along = mean.along + share * (mean.across - mean.along);
    let across = mean.across + 0.5 * share * (mean.along - mean.across);
    Anisotropy { along, across, ..mean.clone() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bell_has_mean_0_and_standard_deviation_1_and_ends_at_3() {
        let numbers: Vec<f64> = (0..20_000).map(|seed| bell(seed, 2)).collect();
        let n = numbers.len() as f64;
        let mean = numbers.iter().sum::<f64>() / n;
        let variance = numbers.iter().map(|v| (v - mean) * (v - mean)).sum::<f64>() / n;
        // Four standard errors of 20,000 numbers.
        assert!(mean.abs() < 0.03 && (variance - 1.0).abs() < 0.04, "{mean} {variance}");
        assert!(numbers.iter().all(|v| v.abs() <= 3.0));
    }

    #[test]
    fn fibres_that_turn_keep_the_sum_of_the_conductivities_and_lie_across_at_a_right_angle() {
        let mean = Anisotropy { along: 1.07, across: 0.93, source: String::new(), confidence: Default::default() };
        for deg in [0.0, 20.0, 45.0, 90.0] {
            let turned = turned(&mean, deg);
            assert!((turned.along + 2.0 * turned.across - (1.07 + 2.0 * 0.93)).abs() < 1e-12, "{deg}");
        }
        assert!((turned(&mean, 90.0).along - 0.93).abs() < 1e-12);
        assert!((turned(&mean, 0.0).along - 1.07).abs() < 1e-12);
    }

    #[test]
    fn a_composition_strays_as_stated_and_still_adds_up() {
        let source = String::new;
        let mean = Composition {
            water: 0.73,
            protein: 0.222,
            fat: 0.035,
            carbohydrate: 0.002,
            fibre: 0.0,
            ash: 0.011,
            source: source(),
            confidence: Default::default(),
        };
        let spread = PieceSpread {
            fat: 0.012,
            water: 0.01,
            fibre_deg: 0.0,
            wedge: 0.0,
            released: 0.0,
            thickness: 0.0,
            source: source(),
            confidence: Default::default(),
        };
        let same = strayed(&mean, &spread, 0.0, 0.0);
        assert!((same.water - mean.water).abs() < 1e-15 && (same.protein - mean.protein).abs() < 1e-15);
        for (fat, water) in [(3.0, -3.0), (-3.0, 3.0), (1.0, 1.0)] {
            let piece = strayed(&mean, &spread, fat, water);
            assert!((piece.total() - mean.total()).abs() < 1e-12);
            assert!(piece.fat > 0.0 && piece.protein > 0.0);
        }
        let fatty = Composition { water: 0.15, protein: 0.03, fat: 0.807, ..mean.clone() };
        assert!((strayed(&fatty, &spread, 0.0, 0.0).fat - 0.807).abs() < 1e-15, "its mean piece is its mean");
        // One standard deviation more of fat displaces 73 parts of water in 96.5; then the water strays by its own.
        let piece = strayed(&mean, &spread, 1.0, 1.0);
        let displaced = 0.73 * (1.0 - 0.047) / (1.0 - 0.035);
        assert!((piece.fat - 0.047).abs() < 1e-12 && (piece.water - displaced - 0.01).abs() < 1e-12);
    }
}
