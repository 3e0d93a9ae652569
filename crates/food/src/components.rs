//! Thermal properties from composition (Choi & Okos 1986 `[@choi-okos-1986]`).

use std::array::from_fn;

use schemars::JsonSchema;
use serde::Deserialize;

use crate::ZERO_C;
use crate::description::{Composition, Confidence, FatMelting, Freezing};

/// Properties of one component as polynomials a + bT + cT² of the temperature T [°C] (Choi & Okos 1986
/// `[@choi-okos-1986]`).
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Component {
    /// Thermal conductivity [W/(m·K)].
    #[schemars(inner(range(min = -1e6, max = 1e6)))]
    pub conductivity_w_mk: [f64; 3],
    /// Specific heat [J/(kg·K)].
    #[schemars(inner(range(min = -1e6, max = 1e6)))]
    pub specific_heat_j_kgk: [f64; 3],
    /// Density [kg/m³].
    #[schemars(inner(range(min = -1e6, max = 1e6)))]
    pub density_kg_m3: [f64; 3],
}

/// The six components of food: water, protein, fat, carbohydrate, fibre, ash.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "saute components")]
pub struct Components {
    /// Source of the numbers.
    pub source: String,
    /// Confidence in the numbers.
    pub confidence: Confidence,
    /// Liquid water.
    pub water: Component,
    /// Ice.
    pub ice: Component,
    /// Latent heat of melting of ice at 0 °C [J/kg].
    #[schemars(range(min = 0.0, max = 1e6))]
    pub melting_j_kg: f64,
    /// Protein.
    pub protein: Component,
    /// Fat.
    pub fat: Component,
    /// Carbohydrate.
    pub carbohydrate: Component,
    /// Fibre.
    pub fibre: Component,
    /// Ash.
    pub ash: Component,
}

/// Upper end of the polynomials' validity [°C]; they are constant beyond.
const VALID_TO_C: f64 = 150.0;
/// Lower end of the polynomials' validity [°C]; they are constant beyond.
const VALID_FROM_C: f64 = -40.0;

pub(crate) fn polynomial(c: &[f64; 3], celsius: f64) -> f64 {
    let t = celsius.clamp(VALID_FROM_C, VALID_TO_C);
    c[0] + c[1] * t + c[2] * t * t
}

/// Tables of enthalpy [J/kg], conductivity [W/(m·K)] and density [kg/m³] of water, lean solids and fat.
///
/// The solids are one pseudo-component with the composition of the lean tissue. Valid from −40 to 150 °C; the properties are
/// constant beyond. Source: Choi & Okos 1986 `[@choi-okos-1986]`.
#[derive(Clone, Debug)]
pub struct Properties {
    heat: Vec<HeatCell>,
    bulk: Vec<BulkCell>,
}

/// Enthalpy between two rows [J/kg]: values at the colder row and their rise to the hotter one, in the order water, lean
/// solids, fat.
#[derive(Clone, Copy, Debug)]
struct HeatCell {
    from: [f64; 3],
    rise: [f64; 3],
}

/// Heat capacity of some masses [J/K] within a cell of the table.
#[derive(Clone, Copy, Debug)]
struct Held {
    index: usize,
    capacity: f64,
}

impl Default for Held {
    /// In no cell yet.
    fn default() -> Self {
        Self { index: usize::MAX, capacity: 0.0 }
    }
}

/// Conductivity [W/(m·K)] and inverse density [m³/kg] between two rows, in the same way.
#[derive(Clone, Copy, Debug)]
struct BulkCell {
    conductivity: [f64; 3],
    conductivity_rise: [f64; 3],
    inverse_density: [f64; 3],
    inverse_density_rise: [f64; 3],
}

/// Properties at one temperature, in the order water, lean solids, fat.
#[derive(Clone, Copy, Debug, Default)]
struct Row {
    enthalpy: [f64; 3],
    conductivity: [f64; 3],
    inverse_density: [f64; 3],
}

/// Masses of water, lean solids and fat [kg].
pub type Masses = [f64; 3];

const COLDEST: i32 = -40;
const HOTTEST: i32 = 450;
const LAST_CELL: u32 = (HOTTEST - COLDEST - 1) as u32;
/// Change of a temperature below which Newton's method ends [K] (chosen: the last bits of 300 K).
const SETTLED_K: f64 = 1e-10;
/// Most rounds of Newton's method [-] (chosen: two, as a rule; where the capacity leaps it may take more), and those that are made of
/// several nodes at a time.
const MOST_ROUNDS: usize = 20;
const SIDE_BY_SIDE: usize = 2;

impl Properties {
    /// Tabulates the properties every kelvin from −40 to 450 °C; enthalpies are zero at 0 °C. Without `freezing` the water
    /// stays liquid.
    pub fn new(components: &Components, lean: &Composition, melting: &FatMelting, freezing: Option<&Freezing>) -> Self {
        let solids = [
            (&components.protein, lean.protein),
            (&components.carbohydrate, lean.carbohydrate),
            (&components.fibre, lean.fibre),
            (&components.ash, lean.ash),
        ];
        let total = lean.lean_solids();
        let mut rows: Vec<Row> =
            (COLDEST..=HOTTEST).map(|c| properties_at(f64::from(c), components, &solids, total)).collect();
        integrate_enthalpy(&mut rows, components, &solids, total, melting);
        if let Some(freezing) = freezing {
            freeze(&mut rows, components, freezing);
        }
        let heat = rows.windows(2).map(|pair| HeatCell::between(&pair[0], &pair[1])).collect();
        let bulk = rows.windows(2).map(|pair| BulkCell::between(&pair[0], &pair[1])).collect();
        Self { heat, bulk }
    }

    /// Returns the cell of a temperature and the relative position in it [-].
    #[inline]
    fn place(&self, temperature: f64) -> (usize, f64) {
        // Beyond both ends the table is extrapolated linearly, so that enthalpy stays invertible.
        let position = temperature - ZERO_C - f64::from(COLDEST);
        let index = (position as u32).min(LAST_CELL);
        (index as usize, position - f64::from(index))
    }

    /// Returns enthalpy above 0 °C [J] and heat capacity [J/K] of the given masses.
    #[inline]
    pub fn enthalpy(&self, masses: &Masses, temperature: f64) -> (f64, f64) {
        let (index, share) = self.place(temperature);
        let cell = &self.heat[index];
        (cell.enthalpy(masses, share), cell.capacity(masses))
    }

    /// Specific enthalpy of liquid water above 0 °C [J/kg], also where the water of the food is ice.
    #[inline]
    pub fn water_enthalpy(&self, temperature: f64) -> f64 {
        if temperature < ZERO_C {
            return (temperature - ZERO_C) * self.heat[(-COLDEST) as usize].rise[0];
        }
        let (index, share) = self.place(temperature);
        self.heat[index].from[0] + share * self.heat[index].rise[0]
    }

    /// Specific enthalpy of fat above 0 °C, heat of melting included [J/kg].
    #[inline]
    pub fn fat_enthalpy(&self, temperature: f64) -> f64 {
        let (index, share) = self.place(temperature);
        self.heat[index].from[2] + share * self.heat[index].rise[2]
    }

    /// Returns the temperature at which the given masses hold `enthalpy` [K], and their heat capacity there [J/K].
    ///
    /// Newton's method from `guess` [K]; exact on the piecewise linear table.
    #[inline]
    pub fn temperature(&self, masses: &Masses, enthalpy: f64, guess: f64) -> (f64, f64) {
        if enthalpy < 0.0 {
            return self.cold_temperature(masses, enthalpy);
        }
        self.newton(masses, enthalpy, guess, MOST_ROUNDS)
    }

    fn newton(&self, masses: &Masses, enthalpy: f64, guess: f64, most_rounds: usize) -> (f64, f64) {
        let (mut t, mut held) = (guess, Held::default());
        for _ in 0..most_rounds {
            let change = self.missing(masses, enthalpy, t, &mut held) / held.capacity;
            t += change;
            if libm::fabs(change) < SETTLED_K {
                break;
            }
        }
        self.hold(masses, self.place(t).0, &mut held);
        (t, held.capacity)
    }

    /// Enthalpy that is missing at a temperature [J]; refreshes the heat capacity there.
    #[inline]
    fn missing(&self, masses: &Masses, enthalpy: f64, t: f64, held: &mut Held) -> f64 {
        let (index, share) = self.place(t);
        self.hold(masses, index, held);
        enthalpy - self.heat[index].enthalpy(masses, share)
    }

    /// Refreshes the heat capacity, which is constant within a cell.
    #[inline]
    fn hold(&self, masses: &Masses, index: usize, held: &mut Held) {
        if index != held.index {
            *held = Held { index, capacity: self.heat[index].capacity(masses) };
        }
    }

    /// [`Self::temperature`] of several nodes, to the last bit: [K] and [J/K].
    ///
    /// Nearly all settle in two rounds. Those are made side by side, as a division takes longer than all else.
    #[inline]
    pub fn temperatures<const N: usize>(
        &self,
        masses: &[Masses; N],
        enthalpy: &[f64; N],
        guess: &[f64; N],
    ) -> ([f64; N], [f64; N]) {
        let (mut t, mut settled, mut held) = (*guess, [false; N], [Held::default(); N]);
        for _ in 0..SIDE_BY_SIDE {
            let missing: [f64; N] = from_fn(|k| self.missing(&masses[k], enthalpy[k], t[k], &mut held[k]));
            let change: [f64; N] = from_fn(|k| missing[k] / held[k].capacity);
            for k in 0..N {
                t[k] = if settled[k] { t[k] } else { t[k] + change[k] };
                settled[k] |= libm::fabs(change[k]) < SETTLED_K;
            }
        }
        (0..N).for_each(|k| self.hold(&masses[k], self.place(t[k]).0, &mut held[k]));
        let mut capacity = held.map(|held| held.capacity);
        if settled.contains(&false) || enthalpy.iter().any(|h| *h < 0.0) {
            for k in (0..N).filter(|k| !settled[*k] || enthalpy[*k] < 0.0) {
                (t[k], capacity[k]) = if enthalpy[k] < 0.0 {
                    self.cold_temperature(&masses[k], enthalpy[k])
                } else {
                    self.newton(&masses[k], enthalpy[k], t[k], MOST_ROUNDS - SIDE_BY_SIDE)
                };
            }
        }
        (t, capacity)
    }

    /// [`Self::temperature`] below 0 °C, where ice makes the capacity leap: by bisection over the rows.
    fn cold_temperature(&self, masses: &Masses, enthalpy: f64) -> (f64, f64) {
        let cold = &self.heat[..(-COLDEST) as usize];
        let index = cold.partition_point(|cell| cell.enthalpy(masses, 0.0) <= enthalpy).saturating_sub(1);
        let (cell, capacity) = (&cold[index], cold[index].capacity(masses));
        let share = (enthalpy - cell.enthalpy(masses, 0.0)) / capacity;
        (ZERO_C + f64::from(COLDEST) + index as f64 + share, capacity)
    }

    /// Thermal conductivity of the given masses [W/(m·K)].
    ///
    /// Maxwell–Eucken model with water as the continuous phase, and solids and fat dispersed in it.
    #[inline]
    pub fn conductivity(&self, masses: &Masses, temperature: f64) -> f64 {
        let (index, share) = self.place(temperature);
        let cell = &self.bulk[index];
        let volume = |k: usize| masses[k] * (cell.inverse_density[k] + share * cell.inverse_density_rise[k]);
        let conductivity = |k: usize| cell.conductivity[k] + share * cell.conductivity_rise[k];
        let dispersed = volume(1) + volume(2);
        let inside = (volume(1) * conductivity(1) + volume(2) * conductivity(2)) / dispersed;
        let fraction = dispersed / (dispersed + volume(0));
        let around = conductivity(0);
        around * (2.0 * around + inside - 2.0 * fraction * (around - inside))
            / (2.0 * around + inside + fraction * (around - inside))
    }

    /// Volume of the given masses [m³].
    pub fn volume(&self, masses: &Masses, temperature: f64) -> f64 {
        let (index, share) = self.place(temperature);
        let cell = &self.bulk[index];
        (0..3).map(|k| masses[k] * (cell.inverse_density[k] + share * cell.inverse_density_rise[k])).sum()
    }
}

/// Difference of a property between two rows.
fn rise(from: [f64; 3], to: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|k| to[k] - from[k])
}

impl BulkCell {
    fn between(low: &Row, high: &Row) -> Self {
        Self {
            conductivity: low.conductivity,
            conductivity_rise: rise(low.conductivity, high.conductivity),
            inverse_density: low.inverse_density,
            inverse_density_rise: rise(low.inverse_density, high.inverse_density),
        }
    }
}

impl HeatCell {
    fn between(low: &Row, high: &Row) -> Self {
        Self { from: low.enthalpy, rise: rise(low.enthalpy, high.enthalpy) }
    }

    /// Enthalpy above 0 °C of the given masses at a relative position in the cell [J].
    #[inline]
    fn enthalpy(&self, masses: &Masses, share: f64) -> f64 {
        let own = |k: usize| masses[k] * (self.from[k] + share * self.rise[k]);
        own(0) + own(1) + own(2)
    }

    /// Heat capacity of the given masses [J/K].
    #[inline]
    fn capacity(&self, masses: &Masses) -> f64 {
        masses[0] * self.rise[0] + masses[1] * self.rise[1] + masses[2] * self.rise[2]
    }
}

fn properties_at(celsius: f64, components: &Components, solids: &[(&Component, f64); 4], total: f64) -> Row {
    let inverse_density = solids.iter().map(|(c, x)| x / polynomial(&c.density_kg_m3, celsius)).sum::<f64>();
    let weighted = |f: fn(&Component) -> &[f64; 3]| {
        let sum: f64 =
            solids.iter().map(|(c, x)| x / polynomial(&c.density_kg_m3, celsius) * polynomial(f(c), celsius)).sum();
        sum / inverse_density
    };
    Row {
        enthalpy: [0.0; 3],
        conductivity: [
            polynomial(&components.water.conductivity_w_mk, celsius),
            weighted(|c| &c.conductivity_w_mk),
            polynomial(&components.fat.conductivity_w_mk, celsius),
        ],
        inverse_density: [
            1.0 / polynomial(&components.water.density_kg_m3, celsius),
            inverse_density / total,
            1.0 / polynomial(&components.fat.density_kg_m3, celsius),
        ],
    }
}

/// Freezes the water of the rows below 0 °C.
fn freeze(rows: &mut [Row], components: &Components, freezing: &Freezing) {
    for (row, celsius) in rows.iter_mut().zip((COLDEST..0).map(f64::from)) {
        row.enthalpy[0] += freezing.enthalpy_of_ice(components, celsius);
        row.conductivity[0] = freezing.conductivity_of_ice(components, celsius);
        row.inverse_density[0] = freezing.volume_of_ice(components, celsius);
    }
}

/// Integrates the specific heat and the heat of melting from kelvin to kelvin by the midpoint rule; zero at 0 °C.
fn integrate_enthalpy(
    rows: &mut [Row],
    components: &Components,
    solids: &[(&Component, f64); 4],
    total: f64,
    melting: &FatMelting,
) {
    let molten = |c: f64| melting.latent_j_kg / (1.0 + libm::exp(-(c - melting.middle_c) / melting.width_k));
    for i in 1..rows.len() {
        let (from, to) = (f64::from(COLDEST + i as i32 - 1), f64::from(COLDEST + i as i32));
        let middle = 0.5 * (from + to);
        let heat = |c: &Component| polynomial(&c.specific_heat_j_kgk, middle);
        let lean = solids.iter().map(|(c, x)| x * heat(c)).sum::<f64>() / total;
        let before = rows[i - 1].enthalpy;
        rows[i].enthalpy = [
            before[0] + heat(&components.water),
            before[1] + lean,
            before[2] + heat(&components.fat) + molten(to) - molten(from),
        ];
    }
    let zero = rows[(-COLDEST) as usize].enthalpy;
    rows.iter_mut().for_each(|row| (0..3).for_each(|k| row.enthalpy[k] -= zero[k]));
}
