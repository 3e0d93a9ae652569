//! Irreversible changes: denaturation, softening, gelatinisation, loss of colour.

use libm::exp;

use crate::ZERO_C;
use crate::description::{Change, Kinetics};
use crate::table::Table;

/// Molar gas constant [J/(mol·K)] (CODATA 2018 `[@codata-2018]`, exact to 6 digits).
const GAS_CONSTANT: f64 = 8.314_46;

/// Returns the Arrhenius rate as a function of the temperature [K], in the unit of `rate`.
///
/// k(T) = k_a · exp(−Ea/R · (1/T − 1/T_a)), with k_a = `rate` at T_a = `anchor_c`.
///
/// ```
/// use saute_food::ZERO_C;
/// use saute_food::change::changes::arrhenius;
///
/// // Myosin of beef: 2.66 1/min at 57 °C with 241 kJ/mol, so 0.40 1/min at 50 °C.
/// let rate = arrhenius(241.0, 57.0, 2.66)(ZERO_C + 50.0);
/// assert!((rate - 0.40).abs() < 0.02);
/// ```
pub fn arrhenius(activation_energy_kj_mol: f64, anchor_c: f64, rate: f64) -> impl Fn(f64) -> f64 {
    let ratio = activation_energy_kj_mol * 1e3 / GAS_CONSTANT;
    move |t| rate * exp(-ratio * (1.0 / t - 1.0 / (anchor_c + ZERO_C)))
}

/// Lowest temperature with changes [K] (30 °C, chosen: the reactions take more than a day there).
pub const CHANGES_FROM: f64 = 303.15;

/// Number of nodes that are changed together [-] (chosen: a block fits a few SIMD vectors).
const BLOCK: usize = 32;

/// Tables of the rates of the changes [1/s].
#[derive(Clone, Debug)]
pub struct ChangeRates {
    tables: Vec<Table>,
    /// Shares by which changes that speed themselves up begin [-]; none of first-order ones.
    seeds: Vec<Option<f64>>,
}

impl ChangeRates {
    /// Tabulates the rates every quarter kelvin from 30 to 110 °C and keeps them constant beyond (every change is complete there).
    pub fn new(kinetics: &Kinetics) -> Self {
        let table = |c: &Change| {
            let rate = arrhenius(c.activation_energy_kj_mol, c.anchor_c, c.anchor_rate_per_min / 60.0);
            Table::new(CHANGES_FROM, 383.15, 0.25, rate)
        };
        let seeds = kinetics.change.iter().map(|c| c.autocatalysis).collect();
        Self { tables: kinetics.change.iter().map(table).collect(), seeds }
    }

    /// Number of changes [-].
    pub fn count(&self) -> usize {
        self.tables.len()
    }

    /// Advances the shares of all changes of every node by `dt` [s] at its temperature [K]; below [`CHANGES_FROM`] they stay.
    ///
    /// 1 − (1 − X)/(1 + x + x²/2) with x = k Δt: second order in Δt, monotone, and without an exponential. A complete change stays
    /// complete. Of a change that begins by a share s, (X + s)/(1 − X) grows by 1 + y + y²/2 with y = (1 + s) x, in the same way.
    pub fn advance(&self, changed: &mut [Vec<f64>], temperature: &[f64], dt: f64) {
        for (first, t) in (0..).step_by(BLOCK).zip(temperature.chunks(BLOCK)) {
            // Most blocks of raw flesh are cold: without a branch at each node.
            if t.iter().fold(false, |any, t| any | (*t > CHANGES_FROM)) {
                self.advance_block(changed, first, t, dt);
            }
        }
    }

    /// [`Self::advance`] of a block of nodes.
    fn advance_block(&self, changed: &mut [Vec<f64>], first: usize, temperature: &[f64], dt: f64) {
        let Some(table) = self.tables.first() else { return };
        // All tables have the same grid.
        let mut places = [(0, 0.0); BLOCK];
        places.iter_mut().zip(temperature).for_each(|(place, t)| *place = table.place(*t));
        for ((table, seed), changed) in self.tables.iter().zip(&self.seeds).zip(changed) {
            let changed = &mut changed[first..first + temperature.len()];
            if changed.iter().fold(true, |all, share| all & (*share == 1.0)) {
                continue;
            }
            let mut x = [0.0; BLOCK];
            x.iter_mut().zip(places).for_each(|(x, (cell, share))| *x = table.within(cell, share) * dt);
            if let Some(seed) = *seed {
                speed_up(changed, temperature, &x, seed);
                continue;
            }
            for ((changed, t), x) in changed.iter_mut().zip(temperature).zip(x) {
                let next = 1.0 - (1.0 - *changed) / (1.0 + x + 0.5 * x * x);
                *changed = if *t > CHANGES_FROM { next } else { *changed };
            }
        }
    }
}

/// Advances the shares of a change with dX/dt = k (1 − X)(X + s), given k Δt.
fn speed_up(changed: &mut [f64], temperature: &[f64], x: &[f64], seed: f64) {
    for ((changed, t), x) in changed.iter_mut().zip(temperature).zip(x) {
        if *t > CHANGES_FROM && *changed < 1.0 {
            let y = (1.0 + seed) * x;
            let odds = (*changed + seed) / (1.0 - *changed) * (1.0 + y + 0.5 * y * y);
            *changed = if odds.is_finite() { (odds - seed) / (1.0 + odds) } else { 1.0 };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn denaturation(activation_energy_kj_mol: f64, anchor_c: f64, anchor_rate_per_min: f64) -> impl Fn(f64) -> f64 {
        arrhenius(activation_energy_kj_mol, anchor_c, anchor_rate_per_min)
    }

    /// Published rates: myosin 0.40/min at 50 °C and 21/min at 65 °C, actin 0.23/min at 70 °C (same set, k₀ form).
    #[test]
    fn anchored_rates_reproduce_the_published_set() {
        let myosin = denaturation(241.0, 57.0, 2.66);
        assert!((myosin(323.15) / 0.40 - 1.0).abs() < 0.05);
        assert!((myosin(338.15) / 21.0 - 1.0).abs() < 0.05);
        let actin = denaturation(250.0, 79.5, 2.42);
        assert!((actin(343.15) / 0.23 - 1.0).abs() < 0.05);
    }

    /// Geileskey et al. 1998 `[@geileskey-1998]`: 63 °C for one minute denatures 6.5 % of beef myoglobin.
    #[test]
    fn a_minute_at_63_denatures_the_published_share_of_myoglobin() {
        let k = denaturation(290.0, 63.0, 0.0676)(336.15);
        assert!((1.0 - exp(-k) - 0.065).abs() < 0.002);
    }

    /// Potato in boiling water (Kubota 1981): dX/dt = k (1 − X)(X + 0.1) reaches 0.9 after ln(100)/(1.1 k), 5.5 min with 0.76 1/min.
    #[test]
    fn a_change_that_speeds_itself_up_takes_the_time_of_its_equation() {
        let mut kinetics: Kinetics =
            toml::from_str(include_str!("../../../../data/kinetics/carrot.toml")).expect("is sound");
        let (place, seed) = (1, 0.1);
        let change = &mut kinetics.change[place];
        (change.activation_energy_kj_mol, change.anchor_c, change.anchor_rate_per_min) = (123.0, 100.0, 0.76);
        change.autocatalysis = Some(seed);
        let rate = arrhenius(change.activation_energy_kj_mol, change.anchor_c, change.anchor_rate_per_min)(373.15);
        let expected_s = 60.0 * libm::log((0.9 + seed) / 0.1 / seed) / ((1.0 + seed) * rate);
        assert!((expected_s / 330.0 - 1.0).abs() < 0.02, "{expected_s}");
        let rates = ChangeRates::new(&kinetics);
        let mut changed = vec![vec![0.0]; rates.count()];
        let dt = 0.1;
        let mut time_s = 0.0;
        while changed[place][0] < 0.9 {
            rates.advance(&mut changed, &[373.15], dt);
            time_s += dt;
        }
        assert!((time_s / expected_s - 1.0).abs() < 0.002, "{time_s} for {expected_s}");
    }
}
