//! A radiant element behind glass-ceramic: it glows in turns, heats the glass, and through the glass the pan.

use core::f64::consts::PI;

use saute_food::sourced_table;

use crate::pan::heater::{Given, Meets};

/// Stefan–Boltzmann constant [W/(m²·K⁴)] (CODATA).
const SIGMA: f64 = 5.670_374_419e-8;

sourced_table! {
    /// Radiant element behind glass-ceramic.
    Element {
        /// Power while it is on [W].
        #[schemars(range(min = 100.0, max = 1e4), example = 1800.0)]
        largest_w: f64,
        /// Settings on the dial, as mean powers [W].
        #[schemars(inner(range(min = 0.0, max = 1e4)), extend("examples" = [[0.0, 450.0, 1100.0, 1800.0]]))]
        settings_w: Vec<f64>,
        /// Radius of the zone [mm].
        #[schemars(range(min = 50.0, max = 500.0), example = 90.0)]
        radius_mm: f64,
        /// Share of the power that leaves it upwards; the rest warms insulation and edge [-].
        #[schemars(range(min = 0.0, max = 1.0), example = 0.88)]
        efficiency: f64,
        /// Period in which the regulator switches it on and off [s].
        #[schemars(range(min = 0.5, max = 600.0), example = 30.0)]
        period_s: f64,
        /// Heat capacity of the element [J/K].
        #[schemars(range(min = 1.0, max = 5000.0), example = 120.0)]
        heat_capacity_j_k: f64,
        /// Emissivity of element and insulation together, over the zone's area [-].
        #[schemars(range(min = 0.05, max = 1.0), example = 0.75)]
        emissivity: f64,
        /// Share of the radiation that the glass lets through to the pan [-].
        #[schemars(range(min = 0.0, max = 0.95), example = 0.4)]
        through_share: f64,
        /// Mean temperature of the glass over the zone at which the limiter switches the element off [°C].
        #[schemars(range(min = 100.0, max = 900.0), example = 540.0)]
        limit_c: f64,
        /// By how much it must cool until the limiter switches on again [K].
        #[schemars(range(min = 1.0, max = 300.0), example = 40.0)]
        resume_k: f64,
    }
}

impl Element {
    fn area(&self) -> f64 {
        PI * 1e-6 * self.radius_mm * self.radius_mm
    }

    /// Share of the zone's view that a pan at a height [m] fills [-]: R²/(R² + h²), that of a disc from its middle.
    pub(crate) fn view(&self, lift: f64) -> f64 {
        let radius = 1e-3 * self.radius_mm;
        radius * radius / (radius * radius + lift * lift)
    }

    /// Largest conductance by radiation [W/(m²·K)], 4 ε σ T³ of an element in balance at full power; limits the stable step.
    pub(crate) fn steepest_w_m2k(&self) -> f64 {
        let hottest = libm::sqrt(libm::sqrt(self.largest_w / (self.emissivity * SIGMA * self.area())));
        4.0 * SIGMA * (hottest + crate::kelvin(0.0)) * hottest * hottest
    }

    /// Returns true if the limiter keeps the element off, given whether it did, with glass at `glass` [K].
    pub(crate) fn limits(&self, did: bool, glass: &[f64], shares: &[f64]) -> bool {
        let whole: f64 = shares.iter().sum();
        if whole == 0.0 {
            return did;
        }
        let mean = glass.iter().zip(shares).map(|(t, s)| t * s).sum::<f64>() / whole;
        mean > crate::kelvin(self.limit_c) - if did { self.resume_k } else { 0.0 }
    }

    /// Lets the element at `element_k` [K] glow for a step: into the glass, each node of which gets its heat in `into_glass`
    /// [J], and through it into the pan; adds what the metal takes to `heat` [J].
    ///
    /// Radiation ε σ A (T⁴ − T_s⁴) is linear in the step's new temperature, which is found implicitly. What passes a pan that
    /// is small or lifted goes to the room.
    pub(crate) fn glow(
        &self,
        element_k: &mut f64,
        glass: &[f64],
        into_glass: &mut Vec<f64>,
        meets: &Meets,
        heat: &mut [f64],
    ) -> Given {
        let Meets { metal, shares, lift, power, room, dt, .. } = *meets;
        let black = self.emissivity * SIGMA * self.area();
        let start = *element_k;
        let linear = |t: f64| black * (start * start + t * t) * (start + t);
        let through = |i: usize| self.through_share * shares[i] * self.view(lift) * linear(metal[i]);
        let absorbed = |i: usize| (1.0 - self.through_share) * shares[i] * linear(glass[i]);
        let past = self.past(shares, lift) * linear(room);
        let (mut whole, mut around) = (past, past * room);
        for i in 0..shares.len() {
            whole += through(i) + absorbed(i);
            around += through(i) * metal[i] + absorbed(i) * glass[i];
        }
        let stored = self.heat_capacity_j_k / dt;
        let now = (stored * start + self.efficiency * power + around) / (stored + whole);
        into_glass.clear();
        into_glass.extend((0..shares.len()).map(|i| absorbed(i) * (now - glass[i]) * dt));
        let mut to_pan = 0.0;
        for i in 0..shares.len() {
            let given = through(i) * (now - metal[i]) * dt;
            heat[i] += given;
            to_pan += given;
        }
        *element_k = now;
        Given { drawn: power * dt, to_pan }
    }

    /// Share of the radiation that meets no pan [-].
    fn past(&self, shares: &[f64], lift: f64) -> f64 {
        let covered: f64 = shares.iter().sum();
        (1.0 - covered).max(0.0) + self.through_share * covered * (1.0 - self.view(lift))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn radiant() -> Element {
        crate::Library::embedded().expect("embedded data").hobs["radiant"].element.clone().expect("an element")
    }

    #[test]
    fn in_balance_it_gives_what_it_gets_by_the_law_of_stefan_and_boltzmann() {
        let element = radiant();
        let (metal, areas) = ([400.0], [element.area()]);
        let (mut at, mut into_glass, mut given) = (293.15, Vec::new(), Given::default());
        let mut heat = [0.0];
        let meets =
            Meets { metal: &metal, areas: &areas, shares: &[1.0], lift: 0.0, power: 1000.0, room: 293.15, dt: 0.1 };
        for _ in 0..20_000 {
            heat = [0.0];
            given = element.glow(&mut at, &[400.0], &mut into_glass, &meets, &mut heat);
        }
        let upwards = element.efficiency * 1000.0;
        assert!(((heat[0] + into_glass[0]) / 0.1 - upwards).abs() < 1e-6 * upwards);
        assert!((given.to_pan / 0.1 - element.through_share * upwards).abs() < 1e-6 * upwards);
        let exact = (upwards / (element.emissivity * SIGMA * element.area()) + 400.0f64.powi(4)).powf(0.25);
        assert!((at - exact).abs() < 1e-6 * exact, "{at} {exact}");
    }

    #[test]
    fn the_limiter_switches_off_and_on_again() {
        let element = radiant();
        let at = |did, c: f64| element.limits(did, &[crate::kelvin(c)], &[1.0]);
        let (limit, back) = (element.limit_c, element.limit_c - element.resume_k);
        assert_eq!(
            [at(false, limit - 1.0), at(false, limit + 1.0), at(true, back + 1.0), at(true, back - 1.0)],
            [false, true, true, false]
        );
    }
}
