//! Browning and charring of a surface.

use crate::change::changes::arrhenius;
use crate::description::{BrowningRate, CharringRate};
use crate::table::{Table, interpolate};

/// Lowest temperature with browning [K] (95 °C, chosen: below it browning during a cook is under 0.1 %).
pub const BROWNING_FROM: f64 = 368.15;

/// Tables of the rates of browning and charring [1/s].
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

    /// Returns browning B and charring C after `dt` [s] at `temperature` [K] and water activity `activity` [-]; `solids` are
    /// the protein and carbohydrate of the place over those of lean flesh [-].
    ///
    /// dB/dt = k_B(T) g(a_w) (1 − B), dC/dt = k_C(T) s B (1 − C), with Arrhenius rates k and solids s: char is what protein
    /// and carbohydrate leave, while fat renders and evaporates (estimate). Implicit in B and C, so both stay in 0–1 and never
    /// fall.
    ///
    /// ```
    /// use saute_food::ZERO_C;
    /// use saute_food::change::Browning;
    /// use saute_food::description::{BrowningRate, CharringRate};
    ///
    /// let browning: BrowningRate = toml::from_str(
    ///     "activation_energy_kj_mol = 100\nanchor_c = 150\nanchor_rate_per_s = 0.01\n\
    ///      activity = [0.0, 1.0]\nfactor = [1.0, 0.0]\nsource = 'example'\nconfidence = 'low'",
    /// )?;
    /// let charring: CharringRate = toml::from_str(
    ///     "activation_energy_kj_mol = 120\nanchor_c = 250\nanchor_rate_per_s = 0.01\n\
    ///      source = 'example'\nconfidence = 'low'",
    /// )?;
    /// let rates = Browning::new(&browning, &charring);
    /// // 100 s at 150 °C with k Δt = 1 on a dry surface: half browned [-], and hardly charred.
    /// let (browned, charred) = rates.advance((0.0, 0.0), ZERO_C + 150.0, 0.0, 1.0, 100.0);
    /// assert!((browned - 0.5).abs() < 1e-9 && charred < 0.01);
    /// # Ok::<(), toml::de::Error>(())
    /// ```
    pub fn advance(&self, state: (f64, f64), temperature: f64, activity: f64, solids: f64, dt: f64) -> (f64, f64) {
        let brown = self.rate.at(temperature) * self.activity_factor.at(activity) * dt;
        let browning = 1.0 - (1.0 - state.0) / (1.0 + brown);
        let char = self.char_rate.at(temperature) * solids * browning * dt;
        (browning, 1.0 - (1.0 - state.1) / (1.0 + char))
    }
}
