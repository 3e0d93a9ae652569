//! Waves of a thin slice whose strips contract differently: streaks of lean shorten, and what stays longer beside them buckles.

use core::f64::consts::{PI, TAU};

use crate::body::shrink::POISSON;
use crate::tissue::noise::uniform;

/// Shares of the wave of the stated length and of one that is longer, whose sum never repeats over a slice [-] (chosen by eye).
const SHARES: [f64; 2] = [0.7, 0.3];
const LONGER: f64 = 1.7;
/// Shift of the waves from edge to edge over their length [-] (chosen by eye: crests do not run straight across).
const SLANT: f64 = 0.35;
/// Steepness of a wave whose troughs and crests are level, over that of a sine [-] (chosen: a limp slice lies on a quarter of its face),
/// and its excess of length over that of a sine of the same height and length [-] (computed).
const STEEP: f64 = 2.0;
const LONGER_THAN_SINE: f64 = 1.541;

/// Where the crests of a slice are, by its seed.
#[derive(Clone, Debug, PartialEq)]
pub struct Waves {
    /// From crest to crest [m].
    length: f64,
    /// Width of the slice [m].
    width: f64,
    /// Of both waves [rad], and the slant of this slice [-].
    phases: [f64; 2],
    slant: f64,
}

impl Waves {
    /// Waves of a length [m] on a slice of a width [m].
    pub(crate) fn new(length: f64, width: f64, seed: u64) -> Self {
        let phases = [580, 581].map(|index| TAU * uniform(seed, index));
        Self { length, width, phases, slant: SLANT * (2.0 * uniform(seed, 582) - 1.0) }
    }

    /// Height at a point over that from trough to crest, 0 in a trough, 1 on a crest [-].
    pub(crate) fn at(&self, [x, y]: [f64; 2]) -> f64 {
        let across = 2.0 * y / self.width;
        let turns = x / self.length + 0.5 * self.slant * across;
        let wave = SHARES[0] * libm::cos(TAU * turns + self.phases[0])
            + SHARES[1] * libm::cos(TAU * turns / LONGER + self.phases[1]);
        0.5 + 0.5 * (STEEP * wave).clamp(-1.0, 1.0)
    }

    /// Height from trough to crest [m] of a plate with an excess of length [-], a thickness [m], a rigidity per width [N·m] and a
    /// weight per area [N/m²].
    ///
    /// A sine of height H and length λ is longer than its base by ε = (πH/2λ)², a steeper wave by more. A strip between two crests buckles beyond
    /// ε = π²h²/(3(1−ν²)λ²), and its weight pulls it down by 5 p (λ/2)⁴/(384 D).
    pub(crate) fn height(&self, excess: f64, thickness: f64, rigidity: f64, weight: f64) -> f64 {
        let slender = PI * thickness / self.length;
        let beyond = excess - slender * slender / (3.0 * (1.0 - POISSON * POISSON));
        if beyond <= 0.0 {
            return 0.0;
        }
        let half = 0.5 * self.length;
        let sag = 5.0 * weight * half * half * half * half / (384.0 * rigidity);
        (2.0 * self.length / PI * libm::sqrt(beyond / LONGER_THAN_SINE) - sag).max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn waves_of_their_height_have_the_excess_of_length() {
        let (length, excess, step) = (0.040, 0.02, 5e-5);
        let waves = Waves::new(length, 0.03, 7);
        let height = waves.height(excess, 1e-6, 1.0, 0.0);
        let rise = |k: u32| height * (waves.at([step * f64::from(k + 1), 0.0]) - waves.at([step * f64::from(k), 0.0]));
        // 17 waves are 10 of the longer ones.
        let steps = 13_600;
        let longer = (0..steps).map(|k| 0.5 * (rise(k) / step).powi(2)).sum::<f64>() / f64::from(steps);
        assert!((longer / excess - 1.0).abs() < 0.02, "{longer}");
    }

    #[test]
    fn troughs_and_crests_are_level() {
        let waves = Waves::new(0.040, 0.03, 7);
        let at = |k: u32| waves.at([1e-4 * f64::from(k), 0.0]);
        for side in [0.0, 1.0] {
            let level = (0..6800).filter(|k| (at(*k) - side).abs() < 0.05).count();
            assert!((1300..2100).contains(&level), "{level} of 6800 at {side}");
        }
    }

    #[test]
    fn a_thick_or_limp_slice_lies_flat() {
        let waves = Waves::new(0.040, 0.03, 1);
        assert_eq!(waves.height(0.02, 0.010, 1.0, 0.0), 0.0);
        assert_eq!(waves.height(0.02, 0.002, 1e-6, 20.0), 0.0);
    }
}
