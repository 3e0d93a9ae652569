//! Contact conductance between food and pan: asperities, oil, steam and juice in the gap between them.
//!
//! A face lies on its asperities at a mean gap δ above the pan. Oil of film thickness f bridges the share φ = min(1, f/δ)
//! of the gap; in the rest a wet face rides on a layer of steam that its own vapour keeps open, and a dry face is in
//! steam and air across the whole gap:
//!
//! h = a π l² h_a + φ k_o/δ + (1 − φ) (w h_wet + (1 − w) h_dry), in series with the pan's coating; a = 1 for a wet face and
//! less for a crust, which conducts worse; π grows with the pressure; l = min(1, δ₀/δ) falls where a patch is lifted.
//!
//! The layer of steam is that of lubrication theory under a load p, with vents R apart:
//! δ_s = (3 μ k_v ΔT R² / (2 ρ L p))^¼. It is never thicker than the gap, so that the flux rises with ΔT^¾ and does not fall
//! above the Leidenfrost point: a food that lies with its weight does not float.

use saute_food::ZERO_C;
use saute_food::water::latent_heat;

use crate::piece::contact_gap::ContactGap;

/// Boiling point of juice in the gap [K].
const BOILING: f64 = ZERO_C + 100.0;
/// Shares of the raw water between which a face counts as dry, partly wet, and wet [-] (chosen: far above a crust, below
/// bound water; a smooth transition, because a face dries patch by patch).
const WETS: [f64; 2] = [0.25, 0.55];

/// State of the contact of a whole face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FaceContact {
    /// Time since the start of the contact [s].
    pub since: f64,
    /// Pressure on it [Pa].
    pub pressure: f64,
    /// Distance over which steam escapes: the face's radius, or the distance between vents if that is less [m].
    pub escape: f64,
    /// Thickness of the oil film [m].
    pub film: f64,
    /// Conductance of the pan's coating; `None` on bare metal [W/(m²·K)].
    pub coating: Option<f64>,
}

/// A patch of a face over the pan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PatchGap {
    /// Gap below the patch [m].
    pub thickness: f64,
    /// Temperature of the pan below it [K].
    pub pan: f64,
    /// Wet share of the patch [-].
    pub wetness: f64,
}

/// Returns the wet share of a face whose node contains a share of its raw water [-].
pub fn wetness(held: f64) -> f64 {
    ((held - WETS[0]) / (WETS[1] - WETS[0])).clamp(0.0, 1.0)
}

/// Returns the share by which a patch at a gap [m] rests on the pan, l = min(1, δ₀/δ) [-].
pub fn lying(gap: &ContactGap, thickness: f64) -> f64 {
    (1e-3 * gap.gap_mm / thickness.max(1e-3 * gap.least_gap_mm)).min(1.0)
}

impl FaceContact {
    /// Mean gap of the face [m]: the face settles; pressure narrows the gap.
    ///
    /// δ = (δ₀ + δ_settling e^(−t/τ_s)) / (1 + (p − p₀)/p_½).
    pub fn mean_gap(&self, gap: &ContactGap) -> f64 {
        let unsettled = libm::exp(-self.since / gap.settling_s);
        1e-3 * (gap.gap_mm + gap.settling_gap_mm * unsettled) / self.pressed(gap)
    }

    /// Factor by which pressure narrows the gap and presses the asperities [-].
    fn pressed(&self, gap: &ContactGap) -> f64 {
        1.0 + (self.pressure - gap.pressure_pa).max(-0.5 * gap.halving_pressure_pa) / gap.halving_pressure_pa
    }

    /// Conductance of a patch [W/(m²·K)].
    pub fn conductance(&self, gap: &ContactGap, patch: &PatchGap) -> f64 {
        let thickness = patch.thickness.max(1e-3 * gap.least_gap_mm);
        let oiled = (self.film / thickness).min(1.0);
        let dry = gap.vapour_conductivity_w_mk / thickness;
        let wet = if patch.wetness > 0.0 { self.wet(gap, thickness, patch.pan) } else { 0.0 };
        let rest = patch.wetness * wet + (1.0 - patch.wetness) * dry;
        let whole = self.touching(gap, thickness, patch.wetness)
            + oiled * gap.oil_conductivity_w_mk / thickness
            + (1.0 - oiled) * rest;
        self.coating.map_or(whole, |coating| 1.0 / (1.0 / whole + 1.0 / coating))
    }

    /// Conductance of the places at which a patch of a wet share touches the metal across a mean gap [m], its asperities [W/(m²·K)].
    pub fn touching(&self, gap: &ContactGap, thickness: f64, wetness: f64) -> f64 {
        // A lifted patch rests on no asperities.
        let lying = lying(gap, thickness);
        let moist = wetness + (1.0 - wetness) * gap.crust_asperities;
        gap.asperity_w_m2k * moist * self.pressed(gap) * lying * lying
    }

    /// Conductance of a gap that a wet face fills with steam and, beyond the layer of steam, with juice [W/(m²·K)].
    fn wet(&self, gap: &ContactGap, thickness: f64, pan: f64) -> f64 {
        let steam = self.steam_layer(gap, pan - BOILING).min(thickness);
        // Juice only fills a gap as narrow as that of a face that lies.
        let juice = (thickness - steam).min(1e-3 * gap.gap_mm);
        let open = thickness - steam - juice;
        1.0 / ((steam + open) / gap.vapour_conductivity_w_mk + juice / gap.juice_conductivity_w_mk)
    }

    /// Thickness of the layer of steam that carries a wet face over a pan `excess` hotter than boiling [K] [m].
    fn steam_layer(&self, gap: &ContactGap, excess: f64) -> f64 {
        if excess <= 0.0 {
            return 0.0;
        }
        let pressure = self.pressure.max(gap.least_pressure_pa);
        let driven =
            1.5 * gap.vapour_viscosity_pa_s * gap.vapour_conductivity_w_mk * excess * self.escape * self.escape;
        let resisted = gap.vapour_density_kg_m3 * latent_heat(BOILING) * pressure;
        libm::sqrt(libm::sqrt(driven / resisted))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kelvin;

    fn gap() -> ContactGap {
        crate::Library::embedded().expect("embedded data").room.contact
    }

    fn face(pressure: f64, escape: f64, film: f64) -> FaceContact {
        FaceContact { since: 1e3, pressure, escape, film, coating: None }
    }

    fn steak(film: f64) -> FaceContact {
        face(260.0, 0.01, film)
    }

    fn mean(face: &FaceContact, pan_c: f64, wetness: f64) -> f64 {
        let gap = gap();
        face.conductance(&gap, &PatchGap { thickness: face.mean_gap(&gap), pan: kelvin(pan_c), wetness })
    }

    /// Film of the default oil [m].
    const OILED: f64 = 0.177e-3;

    /// Wichchukit et al. 2001 `[@wichchukit-2001]`: 250–650 W/(m²·K), rising to a maximum, then decaying to an asymptote.
    #[test]
    fn an_oiled_face_conducts_within_the_measured_range_from_wet_to_crust() {
        let unsettled = FaceContact { since: 0.0, ..steak(OILED) };
        let [first, wet, crust] =
            [mean(&unsettled, 190.0, 1.0), mean(&steak(OILED), 190.0, 1.0), mean(&steak(OILED), 190.0, 0.0)];
        assert!(first < wet && crust < wet, "{first} {wet} {crust}");
        assert!([first, wet, crust].iter().all(|h| (250.0..680.0).contains(h)), "{first} {wet} {crust}");
    }

    /// T5: every wet face conducts 200–1200 W/(m²·K), oiled or not, from 180 to 320 °C.
    #[test]
    fn every_wet_face_conducts_as_much_as_a_dry_pan_measures() {
        for pan in [180.0, 220.0, 260.0, 320.0] {
            for (pressure, radius) in [(260.0, 0.05), (80.0, 0.015), (80.0, 0.008)] {
                for film in [0.0, 0.02e-3, OILED, 1e-3] {
                    let h = mean(&face(pressure, f64::min(radius, 0.01), film), pan, 1.0);
                    assert!((200.0..1200.0).contains(&h), "{pan} °C, {pressure} Pa, {film} m: {h}");
                }
            }
        }
    }

    /// T6: the flux into a face of one temperature rises with the pan's, wet or dry.
    #[test]
    fn the_flux_never_falls_as_the_pan_gets_hotter() {
        for film in [0.0, 0.05e-3, OILED] {
            for wetness in [0.0, 0.5, 1.0] {
                let flux = |c: f64| mean(&steak(film), c, wetness) * (c - 100.0);
                let fluxes: Vec<f64> = (105..350).map(|c| flux(f64::from(c))).collect();
                assert!(fluxes.windows(2).all(|w| w[1] >= w[0]), "{film} {wetness}");
            }
        }
    }

    /// S2: oil never makes the contact worse on a frying pan.
    #[test]
    fn oil_never_lowers_the_conductance() {
        for pan in [140.0, 180.0, 250.0, 320.0] {
            for wetness in [0.0, 1.0] {
                let h: Vec<f64> = (0..40).map(|i| mean(&steak(1e-5 * f64::from(i)), pan, wetness)).collect();
                assert!(h.windows(2).all(|w| w[1] >= w[0] - 1e-9), "{pan} {wetness} {h:?}");
            }
        }
    }

    #[test]
    fn a_wider_gap_conducts_less() {
        let gap = gap();
        let at =
            |thickness: f64| steak(OILED).conductance(&gap, &PatchGap { thickness, pan: kelvin(200.0), wetness: 1.0 });
        let h: Vec<f64> = [0.05e-3, 0.1e-3, 0.2e-3, 0.4e-3, 1e-3, 3e-3].iter().map(|&d| at(d)).collect();
        assert!(h.windows(2).all(|w| w[1] < w[0]) && h[5] < 40.0, "{h:?}");
    }

    /// Pressing with 5 kPa raises the conductance 1.5 to 2 times; squeezing hard between plates to 3800 W/(m²·K) at most.
    #[test]
    fn pressure_raises_the_conductance_as_measured() {
        let at = |pressure: f64| mean(&face(pressure, 0.01, OILED), 190.0, 0.0);
        let ratio = at(5e3) / at(260.0);
        assert!((1.4..2.1).contains(&ratio), "{ratio}");
        assert!((1500.0..3800.0).contains(&at(1e5)), "{}", at(1e5));
    }
}
