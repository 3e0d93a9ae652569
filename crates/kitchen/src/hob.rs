//! The induction hob: a ring-shaped heat source and the glass between it and the pan.

use serde::Deserialize;

use saute_food::sourced_table;

sourced_table! {
    /// Coil of an induction hob.
    Coil {
        /// Electrical power to pan metal [-].
        efficiency: f64,
        /// Radius beyond which no heat is made [mm].
        radius_mm: f64,
        /// Radius of the strongest heating over the coil radius [-].
        ring_over_radius: f64,
        /// Largest power that may be set [W].
        largest_w: f64,
        /// Settings on the dial [W].
        settings_w: Vec<f64>,
    }
}

sourced_table! {
    /// Glass of the hob.
    Glass {
        /// Conductance between pan and glass [W/(m²·K)].
        gap_conductance_w_m2k: f64,
        /// Heat capacity [J/(m²·K)].
        areal_capacity_j_m2k: f64,
        /// Loss to the inside of the hob [W/(m²·K)].
        loss_w_m2k: f64,
    }
}

/// A hob as its file describes it.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HobDescription {
    /// Name for people.
    pub name: String,
    /// Coil.
    pub coil: Coil,
    /// Glass.
    pub glass: Glass,
}

impl HobDescription {
    /// Share of the power that goes into each node of the pan's floor; the shares sum to 1.
    ///
    /// Flux q(r) ∝ (r/r_c)² exp(1 − (r/r_c)²) inside the coil radius, 0 outside.
    pub fn ring_shares(&self, radii: &[f64], areas: &[f64]) -> Vec<f64> {
        let coil = self.coil.radius_mm * 1e-3;
        let peak = coil * self.coil.ring_over_radius;
        let weight = |r: f64| {
            let s = (r / peak) * (r / peak);
            if r <= coil { s * libm::exp(1.0 - s) } else { 0.0 }
        };
        let weights: Vec<f64> = radii.iter().zip(areas).map(|(&r, a)| weight(r) * a).collect();
        let total: f64 = weights.iter().sum();
        weights.iter().map(|w| w / total).collect()
    }
}
