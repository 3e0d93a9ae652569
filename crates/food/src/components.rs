//! Thermal properties from composition (Choi & Okos 1986).

use schemars::JsonSchema;
use serde::Deserialize;

use crate::ZERO_C;
use crate::description::{Composition, Confidence, FatMelting};

/// Polynomials a + bT + cT² in T [°C] of one component.
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

/// The six components of food.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "saute components")]
pub struct Components {
    /// Where the numbers come from.
    pub source: String,
    /// How well they are known.
    pub confidence: Confidence,
    /// Water above 0 °C.
    pub water: Component,
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

/// Hottest temperature at which the polynomials hold [°C]; they are held constant beyond.
const VALID_TO_C: f64 = 150.0;
/// Coldest [°C].
const VALID_FROM_C: f64 = -40.0;

fn polynomial(c: &[f64; 3], celsius: f64) -> f64 {
    let t = celsius.clamp(VALID_FROM_C, VALID_TO_C);
    c[0] + c[1] * t + c[2] * t * t
}

/// Enthalpy, conductivity and density of three pseudo-components (water, lean solids, fat) against temperature.
#[derive(Clone, Debug)]
pub struct Properties {
    rows: Vec<Row>,
}

/// Properties at one temperature; index 0 water, 1 lean solids, 2 fat.
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

impl Properties {
    /// Tabulates every kelvin from −40 to 450 °C; enthalpies are zero at 0 °C [J/kg].
    pub fn new(components: &Components, lean: &Composition, melting: &FatMelting) -> Self {
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
        Self { rows }
    }

    #[inline]
    fn cell(&self, temperature: f64) -> (&Row, &Row, f64) {
        // Beyond both ends the last cell's line goes on, so that enthalpy stays invertible.
        let position = temperature - ZERO_C - f64::from(COLDEST);
        let index = (position.max(0.0) as usize).min(self.rows.len() - 2);
        (&self.rows[index], &self.rows[index + 1], position - index as f64)
    }

    /// Enthalpy above 0 °C [J] and heat capacity [J/K] of the given masses.
    #[inline]
    pub fn enthalpy(&self, masses: &Masses, temperature: f64) -> (f64, f64) {
        let (low, high, share) = self.cell(temperature);
        let (mut enthalpy, mut capacity) = (0.0, 0.0);
        for (mass, (from, to)) in masses.iter().zip(low.enthalpy.iter().zip(&high.enthalpy)) {
            let slope = to - from;
            enthalpy += mass * (from + share * slope);
            capacity += mass * slope;
        }
        (enthalpy, capacity)
    }

    /// Specific enthalpy of liquid water above 0 °C [J/kg].
    #[inline]
    pub fn water_enthalpy(&self, temperature: f64) -> f64 {
        let (low, high, share) = self.cell(temperature);
        low.enthalpy[0] + share * (high.enthalpy[0] - low.enthalpy[0])
    }

    /// Specific enthalpy of fat above 0 °C, heat of melting included [J/kg].
    #[inline]
    pub fn fat_enthalpy(&self, temperature: f64) -> f64 {
        let (low, high, share) = self.cell(temperature);
        low.enthalpy[2] + share * (high.enthalpy[2] - low.enthalpy[2])
    }

    /// Temperature at which the given masses hold `enthalpy` [K], by Newton's rule from `guess`; exact on the table.
    #[inline]
    pub fn temperature(&self, masses: &Masses, enthalpy: f64, guess: f64) -> f64 {
        let mut t = guess;
        for _ in 0..20 {
            let (h, c) = self.enthalpy(masses, t);
            let change = (enthalpy - h) / c;
            t += change;
            if libm::fabs(change) < 1e-10 {
                break;
            }
        }
        t
    }

    /// Thermal conductivity by Maxwell–Eucken, water continuous, solids and fat dispersed [W/(m·K)].
    pub fn conductivity(&self, masses: &Masses, temperature: f64) -> f64 {
        let (low, high, share) = self.cell(temperature);
        let volume = |k: usize| {
            masses[k] * (low.inverse_density[k] + share * (high.inverse_density[k] - low.inverse_density[k]))
        };
        let conductivity = |k: usize| low.conductivity[k] + share * (high.conductivity[k] - low.conductivity[k]);
        let dispersed = volume(1) + volume(2);
        let inside = (volume(1) * conductivity(1) + volume(2) * conductivity(2)) / dispersed;
        let fraction = dispersed / (dispersed + volume(0));
        let around = conductivity(0);
        around * (2.0 * around + inside - 2.0 * fraction * (around - inside))
            / (2.0 * around + inside + fraction * (around - inside))
    }

    /// Volume of the given masses [m³].
    pub fn volume(&self, masses: &Masses, temperature: f64) -> f64 {
        let (low, high, share) = self.cell(temperature);
        (0..3)
            .map(|k| masses[k] * (low.inverse_density[k] + share * (high.inverse_density[k] - low.inverse_density[k])))
            .sum()
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

/// Sums cp (and the heat of melting) from kelvin to kelvin by the midpoint rule, then shifts to zero at 0 °C.
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
