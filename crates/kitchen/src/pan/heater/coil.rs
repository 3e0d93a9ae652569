//! The coil of an induction hob, and its electronics.

use saute_food::sourced_table;

use crate::pan::hob::PanPose;

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
    /// What the electronics of an induction hob do.
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
        /// By how much the hottest ring of the floor may be hotter than that limit [K].
        #[schemars(range(min = 0.0, max = 300.0), example = 25.0)]
        hottest_k: f64,
        /// A pan that stands higher than this is not detected [mm].
        #[schemars(range(min = 0.1, max = 500.0), example = 15.0)]
        lift_limit_mm: f64,
        /// Share of the power that reaches a pan at that height; it falls evenly up to there [-].
        #[schemars(range(min = 0.0, max = 1.0), example = 0.4)]
        coupling_at_limit: f64,
    }
}

impl Coil {
    /// Flux at a distance from the ring's centre [m], not normalised: q(r) ∝ (r/r_c)² exp(1 − (r/r_c)²) inside the coil
    /// radius, 0 outside.
    pub(crate) fn flux(&self, r: f64) -> f64 {
        let coil = self.radius_mm * 1e-3;
        let peak = coil * self.ring_over_radius;
        let s = (r / peak) * (r / peak);
        if r <= coil { s * libm::exp(1.0 - s) } else { 0.0 }
    }

    /// Returns true if the hob detects a pan at a place.
    pub(crate) fn detects(&self, control: &Control, pose: &PanPose) -> bool {
        pose.lift <= control.lift_limit_mm * 1e-3 && libm::hypot(pose.at[0], pose.at[1]) <= self.radius_mm * 1e-3
    }

    /// Share of the power that reaches a pan at a place [-].
    pub(crate) fn coupling(&self, control: &Control, pose: &PanPose) -> f64 {
        let height = pose.lift / (control.lift_limit_mm * 1e-3);
        if self.detects(control, pose) { 1.0 - height * (1.0 - control.coupling_at_limit) } else { 0.0 }
    }
}
