//! The wet cloth: heat flux by a boiling curve, limited by a finite mass of water.

use saute_food::water::latent_heat;
use serde::{Deserialize, Serialize};

use crate::data::room::ClothData;
use crate::{celsius, kelvin};

/// A cloth with its remaining water.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Cloth {
    /// Water [kg].
    pub water: f64,
    /// Temperature of the water [K].
    pub temperature: f64,
    /// Remaining time of contact with the pan [s].
    pub remaining_s: f64,
}

/// Specific heat of water [J/(kg·K)] (standard tables).
const WATER_SPECIFIC_HEAT: f64 = 4186.0;

impl Cloth {
    /// A fresh wet cloth at room temperature [K].
    pub fn fresh(data: &ClothData, room: f64, for_s: f64) -> Self {
        Self { water: data.water_g * 1e-3, temperature: room, remaining_s: for_s }
    }

    /// Heat flux from a base at `base` [K] into the wet cloth by the boiling curve [W/m²].
    pub fn flux(&self, data: &ClothData, base: f64) -> f64 {
        if self.water <= 0.0 || base <= self.temperature {
            return 0.0;
        }
        let c = celsius(base);
        let xs = &data.base_c;
        let upper = xs.partition_point(|&x| x < c).clamp(1, xs.len() - 1);
        let share = ((c - xs[upper - 1]) / (xs[upper] - xs[upper - 1])).clamp(0.0, 1.0);
        let flux = data.flux_kw_m2[upper - 1] + share * (data.flux_kw_m2[upper] - data.flux_kw_m2[upper - 1]);
        1e3 * flux * data.contact_share
    }

    /// Absorbs heat [J], which warms the water and evaporates the rest, or only evaporates if `boiling`. Returns the mass
    /// of vapour [kg].
    pub fn absorb(&mut self, heat: f64, boiling: bool) -> f64 {
        if self.water <= 0.0 {
            return 0.0;
        }
        let warm = if boiling {
            0.0
        } else {
            heat.min((kelvin(100.0) - self.temperature).max(0.0) * self.water * WATER_SPECIFIC_HEAT)
        };
        self.temperature += warm / (self.water * WATER_SPECIFIC_HEAT);
        let mass = ((heat - warm) / latent_heat(kelvin(100.0))).min(self.water);
        self.water -= mass;
        mass
    }
}
