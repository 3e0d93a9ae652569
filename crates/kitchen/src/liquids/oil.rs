//! Kinds of oil and fat: how they flow, smoke and burn.

use saute_food::sourced_table;
use saute_food::table::{Table, interpolate};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::kelvin;

sourced_table! {
    /// How it flows and stores heat.
    OilFluid {
        /// Density at 20 °C [kg/m³].
        #[schemars(range(min = 700.0, max = 1100.0), example = 920.0)]
        density_kg_m3: f64,
        /// How the density changes with temperature [kg/(m³·K)].
        #[schemars(range(min = -1.0, max = 0.0), example = -0.66)]
        density_per_k: f64,
        /// Specific heat, mean over cooking temperatures [J/(kg·K)].
        #[schemars(range(min = 1000.0, max = 4000.0), example = 2250.0)]
        specific_heat_j_kgk: f64,
        /// Temperatures at which the viscosity is given, ascending [°C].
        #[schemars(inner(range(min = -100.0, max = 600.0)), extend("examples" = [[20.0, 180.0]]))]
        viscosity_c: Vec<f64>,
        /// Dynamic viscosity at those [mPa·s].
        #[schemars(inner(range(min = 0.01, max = 1e6)), extend("examples" = [[65.0, 2.9]]))]
        viscosity_mpa_s: Vec<f64>,
    }
}

sourced_table! {
    /// What too much heat does to it.
    OilHeat {
        /// Smoke point [°C].
        #[schemars(range(min = 80.0, max = 400.0), example = 220.0)]
        smoke_c: f64,
        /// Flash point: its vapour can be lit [°C].
        #[schemars(range(min = 80.0, max = 500.0), example = 315.0)]
        flash_c: f64,
        /// Fire point: it goes on burning [°C].
        #[schemars(range(min = 80.0, max = 600.0), example = 345.0)]
        fire_c: f64,
    }
}

sourced_table! {
    /// What it looks like.
    OilLook {
        /// sRGB, 0–255.
        #[schemars(extend("examples" = [[190, 172, 40]]))]
        colour_srgb: [u8; 3],
    }
}

sourced_table! {
    /// A first-order change of the milk solids.
    SolidsChange {
        /// Activation energy [kJ/mol].
        #[schemars(range(min = 1.0, max = 1000.0), example = 105.0)]
        activation_energy_kj_mol: f64,
        /// Temperature at which the rate is given [°C].
        #[schemars(range(min = 0.0, max = 400.0), example = 140.0)]
        anchor_c: f64,
        /// Rate there [1/s].
        #[schemars(range(min = 1e-9, max = 10.0), example = 6.0e-3)]
        anchor_rate_per_s: f64,
    }
}

sourced_table! {
    /// Water and milk solids of butter, and how it melts.
    Emulsion {
        /// Water [-].
        #[schemars(range(min = 0.0, max = 0.6), example = 0.16)]
        water: f64,
        /// Milk solids [-].
        #[schemars(range(min = 0.0, max = 0.3), example = 0.03)]
        solids: f64,
        /// Melting point [°C].
        #[schemars(range(min = 0.0, max = 80.0), example = 34.0)]
        melting_c: f64,
        /// Latent heat of fusion of the whole [J/kg].
        #[schemars(range(min = 1e3, max = 3e5), example = 65.0e3)]
        latent_j_kg: f64,
        /// Conductance between a melting piece and the pan [W/(m²·K)].
        #[schemars(range(min = 1.0, max = 1e4), example = 800.0)]
        conductance_w_m2k: f64,
        /// Thickness of a piece [mm].
        #[schemars(range(min = 1.0, max = 100.0), example = 8.0)]
        lump_mm: f64,
        /// Browning of the milk solids.
        browning: SolidsChange,
        /// Charring of what is browned.
        charring: SolidsChange,
    }
}

/// A kind of oil as its file describes it.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "saute oil")]
pub struct OilDescription {
    /// Name for people.
    #[schemars(example = &"My oil")]
    pub name: String,
    /// How it flows.
    pub fluid: OilFluid,
    /// What heat does to it.
    pub heat: OilHeat,
    /// Look.
    pub look: OilLook,
    /// Water and milk solids; absent in pure fat.
    pub emulsion: Option<Emulsion>,
}

/// A kind of oil, ready for computation.
#[derive(Clone, Debug)]
pub struct Oil {
    /// Name in recipes.
    pub id: String,
    /// The content of its file.
    pub description: OilDescription,
    /// Specific heat [J/(kg·K)].
    pub specific_heat: f64,
    /// One over the dynamic viscosity against temperature [1/(Pa·s)].
    fluidity: Table,
}

impl Oil {
    /// Tabulates the viscosity, its logarithm linear between the given temperatures.
    pub fn new(id: &str, description: &OilDescription) -> Self {
        let fluid = &description.fluid;
        let logs: Vec<f64> = fluid.viscosity_mpa_s.iter().map(|v| libm::log(1e-3 * v)).collect();
        let at = |t: f64| libm::exp(-interpolate(&fluid.viscosity_c, &logs, crate::celsius(t)));
        Self {
            id: id.to_owned(),
            specific_heat: fluid.specific_heat_j_kgk,
            fluidity: Table::new(kelvin(0.0), kelvin(400.0), 1.0, at),
            description: description.clone(),
        }
    }

    /// Density [kg/m³].
    pub fn density(&self, temperature: f64) -> f64 {
        let fluid = &self.description.fluid;
        fluid.density_kg_m3 + fluid.density_per_k * (temperature - kelvin(20.0))
    }

    /// One over the dynamic viscosity [1/(Pa·s)].
    pub fn fluidity(&self, temperature: f64) -> f64 {
        self.fluidity.at(temperature)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Standard tables: 60–70 mPa·s at 20 °C, 12 at 80, 5 at 130, 2.5–3 at 180; 920 kg/m³ at 20 °C.
    #[test]
    fn canola_flows_as_in_the_tables() {
        let library = crate::Library::embedded().expect("embedded data");
        let oil = Oil::new("canola", &library.oils["canola"]);
        let viscosity = |c: f64| 1e3 / oil.fluidity(kelvin(c));
        assert!((60.0..70.0).contains(&viscosity(20.0)) && (viscosity(80.0) - 12.0).abs() < 0.1);
        assert!((viscosity(130.0) - 5.0).abs() < 0.1 && (2.5..3.0).contains(&viscosity(180.0)));
        assert!((12.0..32.0).contains(&viscosity(60.0)));
        assert!((oil.density(kelvin(20.0)) - 920.0).abs() < 1e-9 && oil.density(kelvin(180.0)) < 830.0);
    }
}
