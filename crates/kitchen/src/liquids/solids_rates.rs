//! Browning and charring rates of solids on the pan: milk solids of butter, and fond.

use saute_food::change::browning::BROWNING_FROM;
use saute_food::change::changes::arrhenius;
use saute_food::table::Table;

use crate::kelvin;
use crate::liquids::oil::SolidsChange;

/// Highest temperature of solids under water [K] (chosen: 105 °C, boiling brine).
const HOTTEST_WET: f64 = 378.15;

/// Rates of browning and charring, tabulated.
#[derive(Clone, Debug)]
pub struct SolidsRates {
    browning: Table,
    charring: Table,
}

impl SolidsRates {
    /// Tabulates both rates from 95 to 400 °C.
    pub fn new(browning: &SolidsChange, charring: &SolidsChange) -> Self {
        let rate = |c: &SolidsChange| {
            let at = arrhenius(c.activation_energy_kj_mol, c.anchor_c, c.anchor_rate_per_s);
            Table::new(BROWNING_FROM, kelvin(400.0), 1.0, at)
        };
        Self { browning: rate(browning), charring: rate(charring) }
    }

    /// Rates of browning and charring [1/s] of solids on metal of a temperature [K] with the share `wet` under water; 0
    /// below 95 °C.
    pub fn at(&self, metal: f64, wet: f64) -> [f64; 2] {
        let t = metal - wet * (metal - metal.min(HOTTEST_WET));
        if t > BROWNING_FROM { [self.browning.at(t), self.charring.at(t)] } else { [0.0; 2] }
    }
}
