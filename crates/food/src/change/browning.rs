//! Browning and charring of a surface.

use crate::change::changes::arrhenius;
use crate::description::{BrowningRate, CharringRate};
use crate::table::{Table, interpolate};

/// Coldest temperature at which browning is followed [K] (95 °C, chosen: below it a cook's browning is under 0.1 %).
pub const BROWNING_FROM: f64 = 368.15;

/// Rates of browning and charring, tabulated.
#[derive(Clone, Debug)]
pub struct Browning {
    rate: Table,
    activity_factor: Table,
    char_rate: Table,
}

impl Browning {
    /// Tabulates both rates from 95 to 450 °C.
    pub fn new(browning: &BrowningRate, charring: &CharringRate) -> Self {
        let brown = arrhenius(browning.activation_energy_kj_mol, browning.anchor_c, browning.anchor_rate_per_s);
        let char = arrhenius(charring.activation_energy_kj_mol, charring.anchor_c, charring.anchor_rate_per_s);
        Self {
            rate: Table::new(BROWNING_FROM, 723.15, 1.0, brown),
            char_rate: Table::new(BROWNING_FROM, 723.15, 1.0, char),
            activity_factor: Table::new(0.0, 1.0, 0.005, |a| interpolate(&browning.activity, &browning.factor, a)),
        }
    }

    /// Moves browning B and charring C through `dt` [s]: dB/dt = k_B(T) g(a_w) (1 − B), dC/dt = k_C(T) B (1 − C).
    ///
    /// Implicit in B and C, so both stay in 0–1 and never fall.
    pub fn advance(&self, state: (f64, f64), temperature: f64, activity: f64, dt: f64) -> (f64, f64) {
        let brown = self.rate.at(temperature) * self.activity_factor.at(activity) * dt;
        let browning = 1.0 - (1.0 - state.0) / (1.0 + brown);
        let char = self.char_rate.at(temperature) * browning * dt;
        (browning, 1.0 - (1.0 - state.1) / (1.0 + char))
    }
}
