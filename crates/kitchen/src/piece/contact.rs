//! Contact conductance between food and pan from the gap between them.

use crate::data::room::ContactGap;

/// What the contact of a whole face depends on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FaceContact {
    /// Time since the face was laid down [s].
    pub since: f64,
    /// Pressure on it [Pa].
    pub pressure: f64,
    /// Thickness of the oil film [m].
    pub film: f64,
    /// Conductance of the pan's coating [W/(m²·K)].
    pub coating: f64,
}

impl FaceContact {
    /// Mean gap of the face [m]: it settles, then steam and crust lift it; pressure narrows it.
    ///
    /// δ = (δ_final + (δ_initial − δ_final) e^(−t/τ) + δ_settling e^(−t/τ_s)) / (1 + (p − p₀)/p_½).
    pub fn mean_gap(&self, gap: &ContactGap) -> f64 {
        let lifted = libm::exp(-self.since / gap.time_constant_s);
        let unsettled = libm::exp(-self.since / gap.settling_s);
        let free =
            gap.final_gap_mm + (gap.initial_gap_mm - gap.final_gap_mm) * lifted + gap.settling_gap_mm * unsettled;
        let pressed =
            1.0 + (self.pressure - gap.pressure_pa).max(-0.5 * gap.halving_pressure_pa) / gap.halving_pressure_pa;
        1e-3 * free / pressed
    }

    /// Conductance across a gap that oil fills up to its film's thickness and vapour beyond [W/(m²·K)].
    ///
    /// 1/h = min(δ, δ_oil)/k_oil + max(0, δ − δ_oil)/k_vapour + 1/h_coating.
    pub fn conductance(&self, gap: &ContactGap, thickness: f64) -> f64 {
        let thickness = thickness.max(gap.least_gap_mm * 1e-3);
        let oil = thickness.min(self.film) / gap.oil_conductivity_w_mk;
        let vapour = (thickness - self.film).max(0.0) / gap.vapour_conductivity_w_mk;
        1.0 / (oil + vapour + 1.0 / self.coating)
    }
}

/// Share of the conductance that steam leaves to a wet face on a pan at `pan` [K]: 1 up to the Leidenfrost region,
/// falling linearly through it [-].
pub fn steam_share(gap: &ContactGap, pan: f64, wet: bool) -> f64 {
    let [from, to] = gap.steam_c;
    let riding = if wet { ((crate::celsius(pan) - from) / (to - from)).clamp(0.0, 1.0) } else { 0.0 };
    1.0 - riding * (1.0 - gap.steam_factor)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gap() -> ContactGap {
        crate::Library::embedded().expect("embedded data").room.contact
    }

    fn face(since: f64, pressure: f64) -> FaceContact {
        FaceContact { since, pressure, film: 0.177e-3, coating: 1e9 }
    }

    fn mean(since: f64, pressure: f64) -> f64 {
        let (gap, face) = (gap(), face(since, pressure));
        face.conductance(&gap, face.mean_gap(&gap))
    }

    /// Wichchukit et al. 2001 `[@wichchukit-2001]`: 250–650 W/(m²·K), rising to a maximum, then
    /// decaying to an asymptote.
    #[test]
    fn conductance_rises_to_a_maximum_and_decays_to_an_asymptote_within_the_measured_range() {
        let series: Vec<f64> = (0..600).map(|s| mean(f64::from(s), 260.0)).collect();
        assert!(series.iter().all(|h| (200.0..650.0).contains(h)), "{series:?}");
        let peak = series.iter().copied().fold(0.0, f64::max);
        let when = series.iter().position(|h| *h == peak).expect("a maximum");
        assert!((3..30).contains(&when) && peak > 1.2 * series[0], "{peak} at {when} s");
        assert!((250.0..350.0).contains(&series[599]) && peak > 450.0, "{peak} {}", series[599]);
    }

    #[test]
    fn a_wider_gap_conducts_less() {
        let gap = gap();
        let face = face(0.0, 260.0);
        let h: Vec<f64> = [0.05e-3, 0.1e-3, 0.2e-3, 0.4e-3].iter().map(|&d| face.conductance(&gap, d)).collect();
        assert!(h.windows(2).all(|w| w[1] < w[0]), "{h:?}");
    }

    /// Pressing with 5 kPa raises the conductance 1.5 to 2 times; squeezing hard between plates to 3800 W/(m²·K) at most.
    #[test]
    fn pressure_raises_the_conductance_as_measured() {
        let ratio = mean(120.0, 5e3) / mean(120.0, 260.0);
        assert!((1.4..2.1).contains(&ratio), "{ratio}");
        assert!((1500.0..3800.0).contains(&mean(120.0, 1e5)), "{}", mean(120.0, 1e5));
    }

    #[test]
    fn a_wet_face_rides_on_steam_above_the_leidenfrost_point_alone() {
        let gap = gap();
        let at = |c: f64, wet| steam_share(&gap, crate::kelvin(c), wet);
        assert_eq!((at(180.0, true), at(300.0, false)), (1.0, 1.0));
        assert!(at(225.0, true) < 0.75 && (at(300.0, true) - 0.4).abs() < 1e-12);
    }
}
