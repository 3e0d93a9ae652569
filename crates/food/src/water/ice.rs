//! Ice: the share of a food's water that is frozen, and what its melting takes.

use crate::components::{Components, polynomial};
use crate::description::Freezing;

impl Freezing {
    /// Share of the water that is frozen at a temperature [°C] [-].
    ///
    /// φ = (1 − b) (1 − T_f/T) below the temperature T_f at which freezing begins: as water freezes, the rest contains more
    /// and more solutes (Raoult). The share b is bound to the solids and never freezes. Valid from −40 °C. The properties are
    /// tabulated every kelvin, so that freezing there begins at the whole degree above T_f.
    /// Source: Schwartzberg 1976 `[@schwartzberg-1976]`.
    ///
    /// ```
    /// use saute_food::description::Freezing;
    ///
    /// let beef: Freezing = toml::from_str(
    ///     "begins_c = -1.0\nbound_share = 0.08\nsource = 'example'\nconfidence = 'low'",
    /// )?;
    /// // Lean beef: about three quarters at −5 °C, nine tenths at the most.
    /// assert!((beef.frozen_share(-5.0) - 0.736).abs() < 1e-9);
    /// assert!(beef.frozen_share(-0.5) == 0.0 && beef.frozen_share(-40.0) < 0.92);
    /// # Ok::<(), toml::de::Error>(())
    /// ```
    pub fn frozen_share(&self, celsius: f64) -> f64 {
        if celsius < self.begins_c { (1.0 - self.bound_share) * (1.0 - self.begins_c / celsius) } else { 0.0 }
    }

    /// Enthalpy of partly frozen water less that of liquid water, both above 0 °C [J/kg]: −φ (L + ∫ (c_water − c_ice) dT).
    pub(crate) fn enthalpy_of_ice(&self, components: &Components, celsius: f64) -> f64 {
        let share = self.frozen_share(celsius);
        if share > 0.0 { -share * melting_heat(components, celsius) } else { 0.0 }
    }

    /// Conductivity of partly frozen water, the geometric mean of water and ice by their shares [W/(m·K)].
    pub(crate) fn conductivity_of_ice(&self, components: &Components, celsius: f64) -> f64 {
        let [water, ice] = [&components.water, &components.ice].map(|c| polynomial(&c.conductivity_w_mk, celsius));
        water * libm::pow(ice / water, self.frozen_share(celsius))
    }

    /// Specific volume of partly frozen water [m³/kg].
    pub(crate) fn volume_of_ice(&self, components: &Components, celsius: f64) -> f64 {
        let [water, ice] = [&components.water, &components.ice].map(|c| 1.0 / polynomial(&c.density_kg_m3, celsius));
        water + self.frozen_share(celsius) * (ice - water)
    }
}

/// Heat of melting at a temperature below 0 °C [J/kg]: L₀ + ∫₀ᵀ (c_water − c_ice) dT.
fn melting_heat(components: &Components, celsius: f64) -> f64 {
    let integral = |c: &[f64; 3]| celsius * (c[0] + celsius * (c[1] / 2.0 + celsius * c[2] / 3.0));
    let [water, ice] = [&components.water, &components.ice].map(|c| integral(&c.specific_heat_j_kgk));
    components.melting_j_kg + water - ice
}
