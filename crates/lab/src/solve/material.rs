//! Thermal properties of a plain body.

use saute_food::components::Properties;
use saute_heat::conduction::product::Constants;

/// Heat capacity and conductivity, constant or of a food, and water that can boil.
#[derive(Clone, Debug)]
pub struct Material {
    /// Heat capacity and conductivity.
    pub solid: Solid,
    /// Water that boils, if any.
    pub boiling: Option<Boiling>,
}

/// Source of heat capacity and conductivity.
#[derive(Clone, Debug)]
pub enum Solid {
    /// Constants.
    Constant(Constants),
    /// Raw lean tissue of a food at the temperature of the node, with the mass of its density at 20 °C.
    Food {
        /// Its id in the library.
        id: String,
        /// Tables of its components.
        properties: Box<Properties>,
        /// Water, lean solids and fat in a cubic metre [kg/m³].
        masses: [f64; 3],
    },
}

/// Water that boils.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Boiling {
    /// Concentration [kg/m³]; `None` where evaporated water is replaced.
    pub water: Option<f64>,
    /// Boiling point [K].
    pub at: f64,
    /// Latent heat of evaporation [J/kg].
    pub latent: f64,
    /// Thermal conductivity of the dry material [W/(m·K)].
    pub crust_conductivity: f64,
}

impl Material {
    /// Returns the thermal conductivity at a temperature [K], with the share `dried` of the water evaporated [W/(m·K)].
    ///
    /// The dry and the wet layer of a partly dried control volume are in series: 1/k = d/k_dry + (1 − d)/k_wet.
    pub fn conductivity(&self, temperature: f64, dried: f64) -> f64 {
        let wet = match &self.solid {
            Solid::Constant(c) => c.conductivity,
            Solid::Food { properties, masses, .. } => properties.conductivity(masses, temperature),
        };
        self.boiling.map_or(wet, |b| 1.0 / (dried / b.crust_conductivity + (1.0 - dried) / wet))
    }

    /// Returns the volumetric heat capacity at a temperature [K] [J/(m³·K)].
    pub fn capacity(&self, temperature: f64) -> f64 {
        match &self.solid {
            Solid::Constant(c) => c.capacity,
            Solid::Food { properties, masses, .. } => properties.enthalpy(masses, temperature).1,
        }
    }

    /// Returns the constant properties; `None` if they depend on temperature or water.
    pub fn constants(&self) -> Option<Constants> {
        match (&self.solid, &self.boiling) {
            (Solid::Constant(c), None) => Some(*c),
            _ => None,
        }
    }
}
