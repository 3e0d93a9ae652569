//! About how long a cook takes from the cold pan until the food is eaten, given before it begins.

use saute_kitchen::celsius;

use super::Session;
use crate::hands::Hands;

/// Time in which a usual pan gets hot at the power that is advised [s] (chosen: the shipped pans take 2 to 4 minutes).
const PAN_S: f64 = 170.0;
/// Time to rest [s] (chosen: until the core of a steak has risen).
const REST_S: f64 = 120.0;
/// Thermal diffusivity of flesh [m²/s] (Singh & Heldman 2014, table A.2.2: beef 1.3 to 1.5e-7).
const DIFFUSIVITY: f64 = 1.35e-7;
/// Mean temperature of the two faces through a cook with turns [°C] (chosen: the lower boils at 100, the upper cools to 50 to 60).
const FACES_C: f64 = 82.0;
/// How far a core rises after it was taken out [K] (chosen: as the advice assumes for a steak).
const RISES_K: f64 = 6.0;

impl<H: Hands> Session<H> {
    /// Returns about how long the shown food takes to a goal for its core [°C], from the cold pan to the end of its rest [s]: the first
    /// term of the series for a slab of constant face temperature, θ = (4/π) exp(−π² Fo / 4), in which the pan's heating and the
    /// rest are added. For flat flesh; none where the goal is beyond the faces, and of frozen food, whose latent heat is not in it.
    pub fn whole_time_s(&self, goal_c: f64) -> Option<f64> {
        let piece = self.shown_piece().filter(|piece| celsius(piece.core()) > 0.0)?;
        Some(PAN_S + frying_s(0.5 * piece.model.size()[2], celsius(piece.core()), goal_c - RISES_K)? + REST_S)
    }
}

/// Time in which the middle of a slab of half a thickness [m] gets from one temperature to another [°C].
fn frying_s(half_m: f64, from_c: f64, to_c: f64) -> Option<f64> {
    let left = (FACES_C - to_c) / (FACES_C - from_c);
    let fourier = (4.0 / (std::f64::consts::PI * left)).ln() * 4.0 / std::f64::consts::PI.powi(2);
    (left > 0.0 && fourier > 0.0).then(|| fourier * half_m * half_m / DIFFUSIVITY)
}

#[cfg(test)]
mod tests {
    use super::frying_s;

    #[test]
    fn the_middle_of_a_slab_warms_as_its_series_states_it() {
        // Fo = 0.5: θ = (4/π) exp(−π²/8) = 0.3709.
        let to_c = 82.0 - 0.3709 * 77.0;
        let s = frying_s(0.0125, 5.0, to_c).expect("within reach");
        assert!((s * 1.35e-7 / (0.0125 * 0.0125) - 0.5).abs() < 1e-3, "{s}");
        assert_eq!(frying_s(0.0125, 5.0, 90.0), None);
        assert!(frying_s(0.0175, 5.0, 56.0) > frying_s(0.0125, 5.0, 56.0));
    }
}
