//! The induction hob: a ring-shaped heat source and the glass between it and the pan.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use saute_food::sourced_table;

use crate::pan::hold::Hold;
use crate::pan::overheat::Overheat;

sourced_table! {
    /// Coil of an induction hob.
    Coil {
        /// Electrical power to pan metal [-].
        #[schemars(range(min = 0.0, max = 1.0), example = 0.87)]
        efficiency: f64,
        /// Radius beyond which no heat is made [mm].
        #[schemars(range(min = 10.0, max = 500.0), example = 90.0)]
        radius_mm: f64,
        /// Radius of the strongest heating over the coil radius [-].
        #[schemars(range(min = 0.01, max = 10.0), example = 0.575)]
        ring_over_radius: f64,
        /// Largest power that may be set [W].
        #[schemars(range(min = 1.0, max = 1e5), example = 3500.0)]
        largest_w: f64,
        /// Settings on the dial [W].
        #[schemars(inner(range(min = 0.0, max = 1e5)), extend("examples" = [[0.0, 400.0, 1100.0, 2000.0]]))]
        settings_w: Vec<f64>,
    }
}

sourced_table! {
    /// What the hob's electronics do.
    Control {
        /// Settings below this are switched on and off [W].
        #[schemars(range(min = 0.0, max = 1e5), example = 500.0)]
        duty_below_w: f64,
        /// Period of that [s].
        #[schemars(range(min = 0.01, max = 600.0), example = 2.0)]
        duty_period_s: f64,
        /// Mean temperature of the floor, as the electronics infer it, at which the power is off [°C].
        #[schemars(range(min = 0.0, max = 1000.0), example = 250.0)]
        limit_c: f64,
        /// Range below it over which the power falls to nothing [K].
        #[schemars(range(min = 0.1, max = 500.0), example = 15.0)]
        resume_k: f64,
        /// A pan that stands higher than this is not detected [mm].
        #[schemars(range(min = 0.1, max = 500.0), example = 15.0)]
        lift_limit_mm: f64,
        /// Share of the power that reaches a pan at that height; it falls evenly up to there [-].
        #[schemars(range(min = 0.0, max = 1.0), example = 0.4)]
        coupling_at_limit: f64,
    }
}

sourced_table! {
    /// Glass of the hob.
    Glass {
        /// Conductance between pan and glass [W/(m²·K)].
        #[schemars(range(min = 0.1, max = 1e6), example = 200.0)]
        gap_conductance_w_m2k: f64,
        /// Heat capacity [J/(m²·K)].
        #[schemars(range(min = 1.0, max = 1e6), example = 8000.0)]
        areal_capacity_j_m2k: f64,
        /// Loss to the inside of the hob [W/(m²·K)].
        #[schemars(range(min = 0.0, max = 1e5), example = 10.0)]
        loss_w_m2k: f64,
    }
}

/// A hob as its file describes it.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "saute hob")]
pub struct HobDescription {
    /// Name for people.
    #[schemars(example = &"Induction hob")]
    pub name: String,
    /// Coil.
    pub coil: Coil,
    /// Electronics.
    pub control: Control,
    /// Glass.
    pub glass: Glass,
    /// Inferring that a pan overheats.
    pub overheat: Overheat,
    /// Holding a pan at a temperature.
    pub hold: Hold,
}

/// Place of a pan over its ring.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct PanPose {
    /// Centre of the pan relative to the ring's [m].
    pub at: [f64; 2],
    /// Height above the glass [m].
    pub lift: f64,
}

impl HobDescription {
    /// Share of the set power in each node of a pan's floor [-]. The shares sum to 1 on the ring, to less off it, and to 0
    /// if the pan is too far away to be detected.
    ///
    /// Flux q(r) ∝ (r/r_c)² exp(1 − (r/r_c)²) inside the coil radius, 0 outside.
    pub fn ring_shares(&self, points: &[[f64; 2]], areas: &[f64], pose: &PanPose) -> Vec<f64> {
        let weights = |at: [f64; 2]| -> Vec<f64> {
            points.iter().zip(areas).map(|(p, a)| self.flux(libm::hypot(p[0] + at[0], p[1] + at[1])) * a).collect()
        };
        let whole: f64 = weights([0.0; 2]).iter().sum();
        let height = pose.lift / (self.control.lift_limit_mm * 1e-3);
        let coupling = if self.detects(pose) { 1.0 - height * (1.0 - self.control.coupling_at_limit) } else { 0.0 };
        if whole == 0.0 {
            // A coil that lies between two rings of nodes heats the node in the middle.
            return (0..points.len()).map(|i| if i == 0 { coupling } else { 0.0 }).collect();
        }
        weights(pose.at).iter().map(|w| coupling * w / whole).collect()
    }

    /// Flux at a distance from the ring's centre [m], not normalised.
    fn flux(&self, r: f64) -> f64 {
        let coil = self.coil.radius_mm * 1e-3;
        let peak = coil * self.coil.ring_over_radius;
        let s = (r / peak) * (r / peak);
        if r <= coil { s * libm::exp(1.0 - s) } else { 0.0 }
    }

    /// Returns true if the hob detects a pan at a place.
    pub fn detects(&self, pose: &PanPose) -> bool {
        pose.lift <= self.control.lift_limit_mm * 1e-3
            && libm::hypot(pose.at[0], pose.at[1]) <= self.coil.radius_mm * 1e-3
    }

    /// Mean power over a tick from `time` to `time + dt` [W]; low settings are pulse-width modulated.
    pub fn switched(&self, power: f64, time: f64, dt: f64) -> f64 {
        let Control { duty_below_w: full, duty_period_s: period, .. } = self.control;
        if power <= 0.0 || power >= full {
            return power;
        }
        let on_until = |t: f64| {
            let periods = libm::floor(t / period);
            (periods * power / full + (t / period - periods).min(power / full)) * period
        };
        full * (on_until(time + dt) - on_until(time)) / dt
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn hob() -> HobDescription {
        crate::Library::embedded().expect("embedded data").hob
    }

    #[test]
    fn low_settings_are_switched_and_keep_their_mean() {
        let hob = hob();
        let ticks: Vec<f64> = (0..20).map(|i| hob.switched(200.0, f64::from(i) * 0.1, 0.1)).collect();
        assert!((ticks.iter().sum::<f64>() / 20.0 - 200.0).abs() < 1e-6, "{ticks:?}");
        assert!((ticks[0] - 500.0).abs() < 1e-6 && ticks[19].abs() < 1e-6);
        assert_eq!(hob.switched(800.0, 3.0, 0.1), 800.0);
    }

    #[test]
    fn a_pan_lifted_or_off_its_ring_gets_no_power() {
        let hob = hob();
        let (points, areas) = ([[0.05, 0.0], [-0.05, 0.0]], [1.0, 1.0]);
        let total = |pose: PanPose| hob.ring_shares(&points, &areas, &pose).iter().sum::<f64>();
        assert!((total(PanPose::default()) - 1.0).abs() < 1e-12);
        assert!((total(PanPose { lift: 0.0075, ..Default::default() }) - 0.7).abs() < 1e-12);
        assert_eq!(total(PanPose { lift: 0.016, ..Default::default() }), 0.0);
        assert_eq!(total(PanPose { at: [0.1, 0.0], lift: 0.0 }), 0.0);
        let beside = total(PanPose { at: [0.06, 0.0], lift: 0.0 });
        assert!(beside < 0.9, "{beside}");
    }

    #[test]
    fn a_coil_that_lies_between_two_rings_of_nodes_heats_the_middle() {
        let mut hob = hob();
        hob.coil.radius_mm = 10.0;
        let shares = hob.ring_shares(&[[0.0; 2], [0.02, 0.0]], &[1.0, 1.0], &PanPose::default());
        assert_eq!(shares, [1.0, 0.0]);
    }
}
