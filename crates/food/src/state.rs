//! What changes in a piece of food.

use crate::ZERO_C;
use crate::model::FoodModel;

/// A big face of a piece, named in its rest frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Level 0 of the mesh.
    Bottom,
    /// The last level.
    Top,
}

impl Side {
    /// The other side.
    pub fn opposite(self) -> Self {
        match self {
            Self::Bottom => Self::Top,
            Self::Top => Self::Bottom,
        }
    }
}

/// Fields on the nodes of a piece and what has left it.
#[derive(Clone, Debug, PartialEq)]
pub struct FoodState {
    /// Temperature [K].
    pub temperature: Vec<f64>,
    /// Enthalpy above 0 °C of what the node holds [J].
    pub enthalpy: Vec<f64>,
    /// Water [kg].
    pub water: Vec<f64>,
    /// Highest temperature so far [K].
    pub peak: Vec<f64>,
    /// Denatured shares of myosin, collagen, actin, myoglobin [-].
    pub denatured: [Vec<f64>; 4],
    /// Browning [-].
    pub browning: Vec<f64>,
    /// Charring [-].
    pub charring: Vec<f64>,
    /// Log₁₀ reduction of pathogens [-].
    pub lethality: Vec<f64>,
    /// Which face lies below.
    pub down: Side,
    /// Water that left as vapour [kg].
    pub evaporated: f64,
    /// Juice that ran off [kg].
    pub dripped: f64,
    /// Ticks since the start.
    pub ticks: u64,
    /// False after a non-finite value: the piece no longer changes.
    pub healthy: bool,
}

impl FoodState {
    /// The raw piece at one temperature [K].
    pub fn raw(model: &FoodModel, temperature: f64) -> Self {
        let n = model.mesh.node_count();
        let enthalpy = (0..n)
            .map(|i| model.properties.enthalpy(&model.masses(i, model.initial_water[i]), temperature).0)
            .collect();
        let zeros = || vec![0.0; n];
        Self {
            temperature: vec![temperature; n],
            enthalpy,
            water: model.initial_water.clone(),
            peak: vec![temperature; n],
            denatured: [zeros(), zeros(), zeros(), zeros()],
            browning: zeros(),
            charring: zeros(),
            lethality: zeros(),
            down: Side::Bottom,
            evaporated: 0.0,
            dripped: 0.0,
            ticks: 0,
            healthy: true,
        }
    }

    /// Mass [kg].
    pub fn mass(&self, model: &FoodModel) -> f64 {
        self.water.iter().sum::<f64>() + model.dry_mass
    }

    /// Enthalpy above 0 °C [J].
    pub fn total_enthalpy(&self) -> f64 {
        self.enthalpy.iter().sum()
    }

    /// Hottest and coldest node [K].
    pub fn range(&self) -> (f64, f64) {
        let low = self.temperature.iter().copied().fold(f64::INFINITY, f64::min);
        let high = self.temperature.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        (low, high)
    }

    /// Temperature of a node in °C.
    pub fn celsius(&self, node: usize) -> f64 {
        self.temperature[node] - ZERO_C
    }
}
