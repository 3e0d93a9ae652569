//! What a lab body is made of.

use saute_food::components::Properties;

/// Heat capacity and conductivity, constant or a food's own.
#[derive(Clone, Debug)]
pub enum Material {
    /// Constants.
    Constant {
        /// Thermal conductivity [W/(m·K)].
        conductivity: f64,
        /// Volumetric heat capacity [J/(m³·K)].
        capacity: f64,
    },
    /// A food's raw lean tissue at the node's temperature, its mass fixed by its density at 20 °C.
    Food {
        /// Tables of its components.
        properties: Box<Properties>,
        /// Water, lean solids and fat in a cubic metre [kg/m³].
        masses: [f64; 3],
    },
}

impl Material {
    /// Thermal conductivity [W/(m·K)].
    pub fn conductivity(&self, temperature: f64) -> f64 {
        match self {
            Self::Constant { conductivity, .. } => *conductivity,
            Self::Food { properties, masses } => properties.conductivity(masses, temperature),
        }
    }

    /// Volumetric heat capacity [J/(m³·K)].
    pub fn capacity(&self, temperature: f64) -> f64 {
        match self {
            Self::Constant { capacity, .. } => *capacity,
            Self::Food { properties, masses } => properties.enthalpy(masses, temperature).1,
        }
    }

    /// Whether properties change with temperature.
    pub fn varies(&self) -> bool {
        matches!(self, Self::Food { .. })
    }
}
