//! What a lab body is made of.

use saute_food::components::Properties;
use saute_heat::product::Constants;

/// Heat capacity and conductivity, constant or a food's own, and water that may boil.
#[derive(Clone, Debug)]
pub struct Material {
    /// What it is.
    pub solid: Solid,
    /// Its water, where that boils.
    pub boiling: Option<Boiling>,
}

/// What conducts and stores heat.
#[derive(Clone, Debug)]
pub enum Solid {
    /// Constants.
    Constant(Constants),
    /// A food's raw lean tissue at the node's temperature, its mass fixed by its density at 20 °C.
    Food {
        /// Its id in the library.
        id: String,
        /// Tables of its components.
        properties: Box<Properties>,
        /// Water, lean solids and fat in a cubic metre [kg/m³].
        masses: [f64; 3],
    },
}

/// Water that boils away.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Boiling {
    /// How much there is [kg/m³]; none where it is made up for without end.
    pub water: Option<f64>,
    /// Boiling point [K].
    pub at: f64,
    /// Latent heat [J/kg].
    pub latent: f64,
    /// Thermal conductivity of what has dried [W/(m·K)].
    pub crust_conductivity: f64,
}

impl Material {
    /// Thermal conductivity at a temperature [K] where `dried` of the water has gone [W/(m·K)].
    ///
    /// A cell that has dried in part conducts as its dry and wet layers in a row.
    pub fn conductivity(&self, temperature: f64, dried: f64) -> f64 {
        let wet = match &self.solid {
            Solid::Constant(c) => c.conductivity,
            Solid::Food { properties, masses, .. } => properties.conductivity(masses, temperature),
        };
        self.boiling.map_or(wet, |b| 1.0 / (dried / b.crust_conductivity + (1.0 - dried) / wet))
    }

    /// Volumetric heat capacity [J/(m³·K)].
    pub fn capacity(&self, temperature: f64) -> f64 {
        match &self.solid {
            Solid::Constant(c) => c.capacity,
            Solid::Food { properties, masses, .. } => properties.enthalpy(masses, temperature).1,
        }
    }

    /// Its constants, if nothing ever changes them.
    pub fn constants(&self) -> Option<Constants> {
        match (&self.solid, &self.boiling) {
            (Solid::Constant(c), None) => Some(*c),
            _ => None,
        }
    }
}
