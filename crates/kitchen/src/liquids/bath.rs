//! Liquids as media: heat transfer from water and oil to food that is in them, and mixing of a pool of water.

use saute_food::table::{Table, interpolate};
use saute_food::{ZERO_C, sourced_table};
use serde::{Deserialize, Serialize};

use crate::liquids::water_film::{WATER_DENSITY, WATER_SPECIFIC_HEAT, WaterFilm};
use crate::{celsius, kelvin};

sourced_table! {
    /// Heat transfer from a liquid to food in it.
    BathData {
        /// Temperatures of the water at which its properties are given, ascending [°C].
        #[schemars(inner(range(min = 0.0, max = 120.0)), extend("examples" = [[20.0, 95.0]]))]
        water_c: Vec<f64>,
        /// Rayleigh number over temperature difference and cubed length, g β/(ν α), at those [1/(m³·K)].
        #[schemars(inner(range(min = 1.0, max = 1e15)), extend("examples" = [[1.42e10, 1.345e11]]))]
        rayleigh_per_m3k: Vec<f64>,
        /// Thermal conductivity of water at those [W/(m·K)].
        #[schemars(inner(range(min = 0.01, max = 10.0)), extend("examples" = [[0.60, 0.68]]))]
        conductivity_w_mk: Vec<f64>,
        /// Least coefficient in water [W/(m²·K)].
        #[schemars(range(min = 0.0, max = 1e5), example = 600.0)]
        least_w_m2k: f64,
        /// Largest coefficient in water that does not boil [W/(m²·K)].
        #[schemars(range(min = 0.0, max = 1e5), example = 1500.0)]
        most_w_m2k: f64,
        /// Coefficient in boiling water [W/(m²·K)].
        #[schemars(range(min = 0.0, max = 1e5), example = 2000.0)]
        boiling_w_m2k: f64,
        /// Temperature of the water from which it boils [°C].
        #[schemars(range(min = 0.0, max = 100.0), example = 98.0)]
        boiling_from_c: f64,
        /// Time constant with which a pool of water mixes [s].
        #[schemars(range(min = 1e-3, max = 1e4), example = 3.0)]
        mixing_s: f64,
        /// Time constant with which a pool of oil mixes [s].
        #[schemars(range(min = 1e-3, max = 1e4), example = 10.0)]
        oil_mixing_s: f64,
        /// Coefficient in oil without bubbles [W/(m²·K)].
        #[schemars(range(min = 0.0, max = 1e5), example = 200.0)]
        oil_quiet_w_m2k: f64,
        /// What boiling of the food's water adds to that at most [W/(m²·K)].
        #[schemars(range(min = 0.0, max = 1e5), example = 800.0)]
        oil_boiling_w_m2k: f64,
        /// Vapour flux from the food at which it adds all of that [g/(m²·s)].
        #[schemars(range(min = 1e-3, max = 1e3), example = 10.0)]
        oil_boiling_g_m2s: f64,
    }
}

/// Heat transfer coefficients of liquids at food.
#[derive(Clone, Debug)]
pub struct BathModel {
    rayleigh: Table,
    conductivity: Table,
    data: BathData,
}

/// Water that is deeper than a puddle: the part of the film that food can stand in.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Pool {
    /// Mass [kg]; 0 without a pool.
    pub mass: f64,
    /// Mean temperature [K].
    pub temperature: f64,
}

impl BathModel {
    /// Tabulates the properties of water.
    pub fn new(data: &BathData) -> Self {
        let of = |values: &[f64]| {
            let (celsius_at, values) = (data.water_c.clone(), values.to_vec());
            Table::new(kelvin(0.0), kelvin(100.0), 1.0, move |t| interpolate(&celsius_at, &values, celsius(t)))
        };
        Self { rayleigh: of(&data.rayleigh_per_m3k), conductivity: of(&data.conductivity_w_mk), data: data.clone() }
    }

    /// Coefficient from water to a face [W/(m²·K)]; both temperatures in [K], half the thickness of the piece in [m].
    ///
    /// Nu = 0.54 Ra^¼, within the limits of the data; boiling water has its own coefficient.
    pub fn water(&self, water: f64, face: f64, half: f64) -> f64 {
        let data = &self.data;
        if celsius(water) >= data.boiling_from_c {
            return data.boiling_w_m2k;
        }
        let rayleigh = self.rayleigh.at(water) * libm::fabs(water - face) * half * half * half;
        let natural = 0.54 * libm::sqrt(libm::sqrt(rayleigh)) * self.conductivity.at(water) / half;
        natural.clamp(data.least_w_m2k, data.most_w_m2k)
    }

    /// Coefficient from oil to a face from which vapour flows [kg/(m²·s)] [W/(m²·K)].
    pub fn oil(&self, vapour: f64) -> f64 {
        let boiling = (1e3 * vapour / self.data.oil_boiling_g_m2s).clamp(0.0, 1.0);
        self.data.oil_quiet_w_m2k + self.data.oil_boiling_w_m2k * boiling
    }

    /// Time constant with which a pool of oil mixes [s].
    pub fn oil_mixing_s(&self) -> f64 {
        self.data.oil_mixing_s
    }

    /// Finds the pool among the water at all nodes, mixes it for `dt` [s] and returns it. `least` is the depth from which
    /// water is a pool [m].
    pub fn mix(&self, water: &mut WaterFilm, areas: &[f64], least: f64, dt: f64) -> Pool {
        let (mut mass, mut heat) = (0.0, 0.0);
        for (m, h) in deep(water, areas, least) {
            mass += *m;
            heat += *h;
        }
        if mass <= 0.0 {
            return Pool::default();
        }
        let mean = heat / mass;
        let share = 1.0 - libm::exp(-dt / self.data.mixing_s);
        deep(water, areas, least).for_each(|(m, h)| *h += share * (mean * *m - *h));
        Pool { mass, temperature: ZERO_C + mean / WATER_SPECIFIC_HEAT }
    }

    /// Takes heat [J] from the pool, from each node in proportion to its water; returns what it could not take because the
    /// water has left the pan since.
    pub fn draw(water: &mut WaterFilm, areas: &[f64], least: f64, heat: f64) -> f64 {
        let mass: f64 = deep(water, areas, least).map(|(m, _)| *m).sum();
        if mass <= 0.0 {
            return heat;
        }
        deep(water, areas, least).for_each(|(m, h)| *h -= heat * *m / mass);
        0.0
    }
}

/// Mass and enthalpy of the water at each node where it is deeper than `least` [m].
fn deep<'a>(
    water: &'a mut WaterFilm,
    areas: &'a [f64],
    least: f64,
) -> impl Iterator<Item = (&'a mut f64, &'a mut f64)> {
    let nodes = water.mass.iter_mut().zip(&mut water.enthalpy).zip(areas);
    nodes.filter(move |((mass, _), area)| **mass > WATER_DENSITY * least * **area).map(|(node, _)| node)
}
