//! Exchange of heat and vapour between a face and the air (Robin boundary).

use crate::advance::present_area;
use crate::body::patch::Patch;
use crate::model::FoodModel;
use crate::state::FoodState;
use crate::water::vapour::latent_heat;

/// Stefan–Boltzmann constant [W/(m²·K⁴)] (CODATA 2018 `[@codata-2018]`).
const STEFAN_BOLTZMANN: f64 = 5.670_374e-8;
/// Highest surface temperature of evaporation into air [K]; water boils beyond.
pub(crate) const HOTTEST_WET: f64 = 373.15;
/// Share of the evaporation that a closed film of oil prevents [-] (estimate, low confidence: oil beads on a wet face).
const OIL_HINDERS: f64 = 0.8;

/// Air and walls around the faces without contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeAir {
    /// Temperature of the air [K].
    pub temperature: f64,
    /// Temperature of the walls, which exchange radiation with the face [K].
    pub walls: f64,
    /// Convective heat transfer coefficient [W/(m²·K)].
    pub convection: f64,
    /// Share of the radiation that is not screened, as by a foil [-].
    pub radiation: f64,
    /// Vapour density of the air away from the surface [kg/m³].
    pub vapour_density: f64,
    /// Mass transfer coefficient of vapour, by the Lewis analogy [m/s].
    pub mass_transfer: f64,
}

/// Exchange of a patch with the air, linearised in the surface temperature.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct AirFilm {
    /// Convection and radiation [W/K].
    pub(crate) heat: f64,
    /// Share of radiation in that [-].
    pub(crate) radiant: f64,
    /// Mass transfer coefficient times area [m³/s].
    pub(crate) transfer: f64,
    /// Vapour density at the surface [kg/m³] at `temperature` [K], and its slope [kg/(m³·K)].
    pub(crate) density: f64,
    pub(crate) slope: f64,
    pub(crate) temperature: f64,
    /// Latent heat, and enthalpy of the vapour above liquid water at 0 °C [J/kg].
    pub(crate) latent: f64,
    pub(crate) vapour_enthalpy: f64,
    /// Present area of the patch [m²].
    pub(crate) area: f64,
}

impl AirFilm {
    pub(crate) fn of(model: &FoodModel, state: &FoodState, patch: &Patch, air: &FreeAir) -> Self {
        let node = patch.node as usize;
        let t = state.temperature[node];
        let area = present_area(patch, state);
        let radiation = radiation_coefficient(model.description.surface.emissivity, t, air.walls) * air.radiation;
        let coefficient = air.convection + radiation;
        let surface = t.min(HOTTEST_WET);
        let activity = model.water.isotherm.activity(state.water[node] / model.tissue.lean_solids[node]);
        let latent = latent_heat(t);
        Self {
            heat: coefficient * area,
            radiant: share_of(radiation, coefficient),
            transfer: air.mass_transfer * (1.0 - OIL_HINDERS * state.oiled[node]) * area,
            density: activity * model.water.vapour.at(surface),
            slope: activity * (model.water.vapour.at(surface + 0.5) - model.water.vapour.at(surface - 0.5)),
            temperature: surface,
            latent,
            vapour_enthalpy: model.properties.water_enthalpy(t) + latent,
            area,
        }
    }
}

/// Share of a coefficient in the whole [-]; 0 of nothing.
fn share_of(part: f64, whole: f64) -> f64 {
    if whole > 0.0 { part / whole } else { 0.0 }
}

/// Radiative heat transfer coefficient ε σ (T² + T₀²)(T + T₀) [W/(m²·K)].
#[inline]
pub fn radiation_coefficient(emissivity: f64, temperature: f64, walls: f64) -> f64 {
    emissivity * STEFAN_BOLTZMANN * (temperature * temperature + walls * walls) * (temperature + walls)
}
