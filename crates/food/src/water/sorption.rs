//! Sorption isotherm: water activity and boiling point of drying food.

use libm::{log, sqrt};

use crate::ZERO_C;
use crate::description::Sorption;
use crate::table::Table;
use crate::water::vapour::{ATMOSPHERE, VAPOUR_GAS_CONSTANT, latent_heat, saturation_pressure};

/// Sorption isotherm of one food, tabulated against the moisture X [kg water per kg dry matter without fat].
#[derive(Clone, Debug)]
pub struct Isotherm {
    activity: Table,
    boiling: Table,
    /// Boiling point at moistures beyond the table, and the lowest one in the table [K].
    wet_boiling: f64,
    lowest: f64,
}

/// Moisture above which a food counts as wet [kg/kg] (chosen: the GAB activity is within 1 % of that of fresh food).
const WETTEST: f64 = 2.0;

impl Isotherm {
    /// Tabulates the inverse of the GAB isotherm and the boiling point.
    ///
    /// X = X_m C K a / ((1 − K a)(1 − K a + C K a)), solved for the activity a up to that of fresh food. The boiling point
    /// solves a · p_sat(T) = 1 atm.
    pub fn new(gab: &Sorption) -> Self {
        let activity = Table::new(0.0, WETTEST, 0.005, |x| gab_activity(gab, x));
        let boiling = Table::new(0.0, WETTEST, 0.005, |x| boiling_point(gab_activity(gab, x)));
        Self::of(activity, boiling)
    }

    /// Isotherm of free water: activity 1 and a constant boiling point [K].
    pub fn free_water(boiling: f64) -> Self {
        let table = |value: f64| Table::new(0.0, WETTEST, WETTEST, move |_| value);
        Self::of(table(1.0), table(boiling))
    }

    fn of(activity: Table, boiling: Table) -> Self {
        Self { wet_boiling: boiling.at(2.0 * WETTEST), lowest: boiling.lowest(), activity, boiling }
    }

    /// Lowest boiling point at any moisture [K].
    pub(crate) fn lowest_boiling_point(&self) -> f64 {
        self.lowest
    }

    /// Water activity at moisture `x` [-].
    pub fn activity(&self, x: f64) -> f64 {
        self.activity.at(x)
    }

    /// Boiling point of food so wet that drying does not change it [K]; none at a moisture within or near the table.
    #[inline]
    pub(crate) fn wet_boiling_point(&self, x: f64) -> Option<f64> {
        (x > WET && x < f64::INFINITY).then_some(self.wet_boiling)
    }

    /// Boiling point at moisture `x` and a pressure of one atmosphere [K].
    pub fn boiling_point(&self, x: f64) -> f64 {
        self.boiling.at(x)
    }
}

/// Moisture that stays beyond the table after drying by half a percent [kg/kg] (chosen: with a margin for rounding).
const WET: f64 = 1.02 * WETTEST;

fn gab_activity(gab: &Sorption, x: f64) -> f64 {
    if x <= 0.0 {
        return 0.0;
    }
    // x (1 − Ka)(1 − Ka + CKa) = X_m C K a, a quadratic in u = Ka.
    let (c, ratio) = (gab.c, gab.monolayer / x);
    let a = 1.0 - c;
    let b = c - 2.0 - ratio * c;
    let u = (-b - sqrt((b * b - 4.0 * a).max(0.0))) / (2.0 * a);
    (u / gab.k).clamp(0.0, gab.fresh_activity)
}

/// Highest boiling point [K] (400 °C, chosen: drier food counts as dry).
const HOTTEST: f64 = 400.0 + ZERO_C;

/// Half width of the bracket around the estimate of a boiling point [K] (chosen: far above its error, and of the pressure's rounding).
const BRACKET: f64 = 1e-9;

/// Boiling point at a water activity [K], bisected to the last bit.
///
/// Most halves are decided by a bracket around an estimate, which spares the evaluations of the vapour pressure.
fn boiling_point(activity: f64) -> f64 {
    if !boils(activity, HOTTEST) {
        return HOTTEST;
    }
    let near = estimate(activity);
    let certain = !boils(activity, near - BRACKET) && boils(activity, near + BRACKET);
    let bracket = if certain { near - BRACKET..near + BRACKET } else { f64::NEG_INFINITY..f64::INFINITY };
    let (mut low, mut high) = (360.0, HOTTEST);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        let boiling = middle > bracket.end || (middle >= bracket.start && boils(activity, middle));
        if boiling { high = middle } else { low = middle }
    }
    0.5 * (low + high)
}

/// Whether water of an activity boils at a temperature [K].
fn boils(activity: f64, temperature: f64) -> bool {
    activity * saturation_pressure(temperature) >= ATMOSPHERE
}

/// Boiling point [K] by the Clausius–Clapeyron relation, repeated: each step leaves a few percent of the error, near the critical point half.
fn estimate(activity: f64) -> f64 {
    let mut t: f64 = 373.0;
    for _ in 0..40 {
        let rate = latent_heat(t) / VAPOUR_GAS_CONSTANT;
        let step = log(activity * saturation_pressure(t) / ATMOSPHERE) / rate;
        t = (1.0 / (1.0 / t + step)).clamp(360.0, HOTTEST);
        if step.abs() < 1e-17 {
            break;
        }
    }
    t
}

#[cfg(test)]
mod tests {
    use super::*;

    fn beef() -> Sorption {
        Sorption {
            monolayer: 0.08,
            c: 12.0,
            k: 0.96,
            fresh_activity: 0.99,
            source: String::new(),
            confidence: Default::default(),
        }
    }

    #[test]
    fn the_inverse_returns_to_the_isotherm() {
        let gab = beef();
        for a in [0.1, 0.3, 0.6, 0.9, 0.95] {
            let u = gab.k * a;
            let x = gab.monolayer * gab.c * u / ((1.0 - u) * (1.0 - u + gab.c * u));
            assert!((gab_activity(&gab, x) - a).abs() < 1e-9, "{a}");
        }
    }

    #[test]
    fn wet_food_boils_near_100_and_crust_far_above() {
        let isotherm = Isotherm::new(&beef());
        let wet = isotherm.boiling_point(3.0) - ZERO_C;
        assert!((100.0..101.0).contains(&wet), "{wet}");
        assert!(isotherm.boiling_point(0.08) > 130.0 + ZERO_C);
        assert!(isotherm.activity(0.0) == 0.0 && isotherm.activity(3.0) == 0.99);
    }

    #[test]
    fn the_bracket_leaves_every_bit_of_the_bisection() {
        for step in 1..=2000 {
            let activity = f64::from(step) / 2000.0;
            let (mut low, mut high) = (360.0, HOTTEST);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if boils(activity, middle) { high = middle } else { low = middle }
            }
            let plain = if boils(activity, HOTTEST) { 0.5 * (low + high) } else { HOTTEST };
            assert_eq!(boiling_point(activity).to_bits(), plain.to_bits(), "{activity}");
        }
    }

    #[test]
    fn the_estimate_is_within_its_bracket() {
        // Below 0.6 % the water boils above 640 K, where the formula of the pressure ends.
        for step in 6..=1000 {
            let activity = f64::from(step) / 1000.0;
            if boils(activity, HOTTEST) {
                let near = estimate(activity);
                assert!(!boils(activity, near - BRACKET) && boils(activity, near + BRACKET), "{activity}: {near}");
            }
        }
    }
}
