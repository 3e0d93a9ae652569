//! Contact conductance between food and pan from the gap between them.

use saute_food::noise::fractal;
use saute_heat::{Located, Locator, Section};

use crate::room::ContactGap;

/// Where each node of a piece's section lies on the pan, and how uneven the face is there.
#[derive(Clone, Debug)]
pub struct ContactPatches {
    /// Place on the pan's mesh.
    pub located: Vec<Located>,
    /// Departure from the mean gap [m].
    pub unevenness: Vec<f64>,
}

impl ContactPatches {
    /// Lays a section at `at` [m] on the pan, turned over about its long axis where `flipped`.
    pub fn lay(
        section: &Section,
        pan: &Section,
        locator: &Locator,
        at: [f64; 2],
        flipped: bool,
        gap: &ContactGap,
        seed: u64,
    ) -> Self {
        let turn = if flipped { -1.0 } else { 1.0 };
        let on_pan = |p: &[f64; 2]| locator.locate_or_nearest(pan, [at[0] + p[0], at[1] + turn * p[1]]);
        let scale = gap.unevenness_scale_mm * 1e-3;
        let face = if flipped { 1.0 } else { 0.0 };
        let noise = |p: &[f64; 2]| fractal(seed ^ 0xc0_47ac, [p[0] / scale, p[1] / scale, 31.0 * face]);
        let raw: Vec<f64> = section.points.iter().map(noise).collect();
        let mean = raw.iter().sum::<f64>() / raw.len() as f64;
        let deviation =
            libm::sqrt(raw.iter().map(|v| (v - mean) * (v - mean)).sum::<f64>() / raw.len() as f64).max(1e-9);
        Self {
            located: section.points.iter().map(on_pan).collect(),
            unevenness: raw.iter().map(|v| (v - mean) / deviation * gap.unevenness_mm * 1e-3).collect(),
        }
    }
}

/// Mean gap after `since` seconds of contact [m]: from initial to final with one time constant.
pub fn mean_gap(gap: &ContactGap, since: f64) -> f64 {
    let decay = libm::exp(-since / gap.time_constant_s);
    1e-3 * (gap.final_gap_mm + (gap.initial_gap_mm - gap.final_gap_mm) * decay)
}

/// Conductance across a gap that oil fills up to its film's thickness and vapour beyond [W/(m²·K)].
///
/// 1/h = min(δ, δ_oil)/k_oil + max(0, δ − δ_oil)/k_vapour + 1/h_coating.
pub fn conductance(gap: &ContactGap, thickness: f64, coating: f64) -> f64 {
    let thickness = thickness.max(gap.least_gap_mm * 1e-3);
    let film = gap.oil_film_mm * 1e-3;
    let oil = thickness.min(film) / gap.oil_conductivity_w_mk;
    let vapour = (thickness - film).max(0.0) / gap.vapour_conductivity_w_mk;
    1.0 / (oil + vapour + 1.0 / coating)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gap() -> ContactGap {
        crate::Library::embedded().expect("embedded data").room.contact
    }

    /// Wichchukit et al. 2001: 250–650 W/(m²·K), decaying to an asymptote.
    #[test]
    fn conductance_starts_and_ends_in_the_measured_range() {
        let gap = gap();
        let (first, last) =
            (conductance(&gap, mean_gap(&gap, 0.0), 1e9), conductance(&gap, mean_gap(&gap, 600.0), 1e9));
        assert!((500.0..650.0).contains(&first), "{first}");
        assert!((250.0..350.0).contains(&last), "{last}");
    }

    #[test]
    fn a_wider_gap_conducts_less() {
        let gap = gap();
        let h: Vec<f64> = [0.05e-3, 0.1e-3, 0.2e-3, 0.4e-3].iter().map(|&d| conductance(&gap, d, 8000.0)).collect();
        assert!(h.windows(2).all(|w| w[1] < w[0]), "{h:?}");
    }
}
