//! An iron plate: heavy, with steps of power, and slow.

use core::f64::consts::PI;

use saute_food::sourced_table;

use crate::pan::heater::{Given, Meets};
use crate::pan::under::lifted;

sourced_table! {
    /// Iron plate with heaters in it.
    Plate {
        /// Steps of its switch [W].
        #[schemars(inner(range(min = 0.0, max = 1e4)), extend("examples" = [[0.0, 180.0, 500.0, 1500.0]]))]
        settings_w: Vec<f64>,
        /// Radius [mm].
        #[schemars(range(min = 30.0, max = 500.0), example = 90.0)]
        radius_mm: f64,
        /// Share of the power that warms the plate; the rest goes down [-].
        #[schemars(range(min = 0.0, max = 1.0), example = 0.92)]
        efficiency: f64,
        /// Heat capacity [J/K].
        #[schemars(range(min = 10.0, max = 2e4), example = 1000.0)]
        heat_capacity_j_k: f64,
        /// Conductance of the gap between plate and pan [W/(m²·K)].
        #[schemars(range(min = 1.0, max = 1e4), example = 300.0)]
        gap_conductance_w_m2k: f64,
        /// Loss of the plate to the room [W/K].
        #[schemars(range(min = 0.0, max = 50.0), example = 0.3)]
        loss_w_k: f64,
        /// Temperature of the plate at which its switch opens [°C].
        #[schemars(range(min = 100.0, max = 1000.0), example = 480.0)]
        limit_c: f64,
        /// By how much it must cool until the switch closes again [K].
        #[schemars(range(min = 1.0, max = 300.0), example = 40.0)]
        resume_k: f64,
    }
}

impl Plate {
    /// Largest step [W].
    pub(crate) fn largest_w(&self) -> f64 {
        self.settings_w.iter().copied().fold(0.0, f64::max)
    }

    /// Step nearest to `w` [W].
    pub(crate) fn nearest_w(&self, w: f64) -> f64 {
        let near = |a: &f64, b: &f64| libm::fabs(a - w).total_cmp(&libm::fabs(b - w));
        self.settings_w.iter().copied().min_by(near).unwrap_or(0.0)
    }

    /// Returns true if the switch is open, given whether it was, with the plate at `plate` [K].
    pub(crate) fn limits(&self, was: bool, plate: f64) -> bool {
        plate > crate::kelvin(self.limit_c) - if was { self.resume_k } else { 0.0 }
    }

    /// Heats the plate at `plate_k` [K] for a step and lets it give heat to the pan, at the same temperature all over; adds
    /// what the metal takes to `heat` [J].
    ///
    /// C dT/dt = ηP − Σ h A (T − T_pan) − k (T − T_room), implicit in T.
    pub(crate) fn warm(&self, plate_k: &mut f64, meets: &Meets, heat: &mut [f64]) -> Given {
        let Meets { metal, shares, lift, power, room, dt, .. } = *meets;
        let area = PI * 1e-6 * self.radius_mm * self.radius_mm;
        let whole = lifted(self.gap_conductance_w_m2k, lift) * area;
        let covered: f64 = shares.iter().sum();
        let pan: f64 = metal.iter().zip(shares).map(|(t, share)| t * share).sum();
        let stored = self.heat_capacity_j_k / dt;
        let taken = stored * *plate_k + self.efficiency * power + whole * pan + self.loss_w_k * room;
        let now = taken / (stored + whole * covered + self.loss_w_k);
        for ((q, t), share) in heat.iter_mut().zip(metal).zip(shares) {
            *q += whole * share * (now - t) * dt;
        }
        *plate_k = now;
        Given { drawn: power * dt, to_pan: whole * (covered * now - pan) * dt }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plate() -> Plate {
        crate::Library::embedded().expect("embedded data").hobs["iron-plate"].plate.clone().expect("a plate")
    }

    #[test]
    fn its_time_constant_is_that_of_its_mass_over_the_gap() {
        let plate = Plate { loss_w_k: 0.0, ..plate() };
        let area = PI * 1e-6 * plate.radius_mm * plate.radius_mm;
        let tau = plate.heat_capacity_j_k / (plate.gap_conductance_w_m2k * area);
        assert!((100.0..160.0).contains(&tau), "about two minutes: {tau}");
        let meets =
            Meets { metal: &[300.0], areas: &[area], shares: &[1.0], lift: 0.0, power: 0.0, room: 300.0, dt: 0.01 };
        let mut at = 400.0;
        let mut given = 0.0;
        for _ in 0..(100.0 * tau) as usize {
            given += plate.warm(&mut at, &meets, &mut [0.0]).to_pan;
        }
        let exact = 300.0 + 100.0 * (-1.0f64).exp();
        assert!((at - exact).abs() < 0.02, "{at} {exact}");
        assert!((given - plate.heat_capacity_j_k * (400.0 - at)).abs() < 1e-6 * given, "nothing is lost");
    }

    #[test]
    fn its_switch_has_steps_only() {
        let plate = plate();
        let steps = &plate.settings_w;
        let between = 0.4 * steps[1] + 0.6 * steps[2];
        assert_eq!([0.0, between, 9e9].map(|w| plate.nearest_w(w)), [0.0, steps[2], plate.largest_w()]);
    }
}
