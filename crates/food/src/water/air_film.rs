//! Heat and vapour between a free face and the air.

use crate::advance::present_area;
use crate::body::patch::Patch;
use crate::model::FoodModel;
use crate::state::FoodState;
use crate::water::vapour::latent_heat;

/// Stefan–Boltzmann constant [W/(m²·K⁴)] (CODATA 2018).
const STEFAN_BOLTZMANN: f64 = 5.670_374e-8;
/// Evaporation into air is reckoned at no higher surface temperature: beyond, water boils [K].
pub(crate) const HOTTEST_WET: f64 = 373.15;

/// Air around free faces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeAir {
    /// Temperature of air and walls [K].
    pub temperature: f64,
    /// Convective heat transfer coefficient [W/(m²·K)].
    pub convection: f64,
    /// Share of radiation that is not screened [-] (a foil screens most).
    pub radiation: f64,
    /// Vapour density of the far air [kg/m³].
    pub vapour_density: f64,
    /// Mass transfer coefficient of vapour, by the Lewis analogy [m/s].
    pub mass_transfer: f64,
}

/// A free patch's exchange with air, linear in its temperature.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct AirFilm {
    /// Convection and radiation [W/K].
    pub(crate) heat: f64,
    /// Mass transfer coefficient times area [m³/s].
    pub(crate) transfer: f64,
    /// Vapour density at the surface [kg/m³] at `temperature` [K], and its slope [kg/(m³·K)].
    pub(crate) density: f64,
    pub(crate) slope: f64,
    pub(crate) temperature: f64,
    /// Latent heat, and enthalpy of the vapour above liquid water at 0 °C [J/kg].
    pub(crate) latent: f64,
    pub(crate) vapour_enthalpy: f64,
}

impl AirFilm {
    pub(crate) fn of(model: &FoodModel, state: &FoodState, patch: &Patch, air: &FreeAir) -> Self {
        let node = patch.node as usize;
        let t = state.temperature[node];
        let area = present_area(patch, state);
        let radiation = radiation_coefficient(model.description.surface.emissivity, t, air.temperature) * air.radiation;
        let surface = t.min(HOTTEST_WET);
        let activity = model.water.isotherm.activity(state.water[node] / model.tissue.lean_solids[node]);
        let latent = latent_heat(t);
        Self {
            heat: (air.convection + radiation) * area,
            transfer: air.mass_transfer * area,
            density: activity * model.water.vapour.at(surface),
            slope: activity * (model.water.vapour.at(surface + 0.5) - model.water.vapour.at(surface - 0.5)),
            temperature: surface,
            latent,
            vapour_enthalpy: model.properties.water_enthalpy(t) + latent,
        }
    }
}

/// Radiative heat transfer coefficient ε σ (T² + T₀²)(T + T₀) [W/(m²·K)].
#[inline]
pub fn radiation_coefficient(emissivity: f64, temperature: f64, walls: f64) -> f64 {
    emissivity * STEFAN_BOLTZMANN * (temperature * temperature + walls * walls) * (temperature + walls)
}
