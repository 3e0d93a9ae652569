//! The state of a piece of food: everything that heating changes.

use crate::ZERO_C;
use crate::model::FoodModel;
use serde::{Deserialize, Serialize};

/// Stretch ratios of the present shape relative to the rest shape.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Stretch {
    /// Stretch ratio across the fibres, uniform over the piece [-].
    pub lateral: f64,
    /// Stretch ratio along the fibres at each node [-].
    pub axial: Vec<f64>,
    /// Height of the middle of the bottom face above the plane of its rim [m]; negative if the top face is hollow, 0 in bodies
    /// other than slices.
    pub dome: f64,
    /// Logarithmic strain through the thickness that presses have left [-].
    pub flattened: f64,
    /// Height of the waves of a thin slice from trough to crest [m].
    #[serde(default)]
    pub waves: f64,
    /// Share to which a limp piece of uneven height has sunk onto its upper face, as it lies on it turned over [-].
    #[serde(default)]
    pub draped: f64,
}

/// Node fields of a piece, its stretch ratios and the masses that have left it.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct FoodState {
    /// Temperature [K].
    pub temperature: Vec<f64>,
    /// Enthalpy of the node's masses above 0 °C [J].
    pub enthalpy: Vec<f64>,
    /// Water [kg].
    pub water: Vec<f64>,
    /// Free juice, a part of the water [kg].
    pub juice: Vec<f64>,
    /// Part of the free juice that moves towards the upper end of the fibres [kg].
    pub rising: Vec<f64>,
    /// Fat [kg].
    pub fat: Vec<f64>,
    /// Peak temperature so far [K].
    pub peak: Vec<f64>,
    /// Shares of the first-order changes, in the order of the kinetics [-].
    pub changed: Vec<Vec<f64>>,
    /// Browning [-].
    pub browning: Vec<f64>,
    /// Charring [-].
    pub charring: Vec<f64>,
    /// Log₁₀ reduction of pathogens [-].
    pub lethality: Vec<f64>,
    /// Share of the face at each node that oil covers [-].
    pub oiled: Vec<f64>,
    /// Share of the face at each node that has come to brown: 1, but that of the tops where ridges carry the face [-].
    pub open: Vec<f64>,
    /// Contraction and bending.
    pub stretch: Stretch,
    /// Water that has evaporated [kg].
    pub evaporated: f64,
    /// Juice that has run off [kg].
    pub dripped: f64,
    /// Fat that has run off [kg].
    pub rendered: f64,
    /// Number of ticks since the start [-].
    pub ticks: u64,
    /// False after a non-finite value; the piece no longer changes then.
    pub healthy: bool,
}

impl FoodState {
    /// Returns the raw state at a uniform temperature [K], with moist faces.
    pub fn raw(model: &FoodModel, temperature: f64) -> Self {
        let n = model.shape.mesh.node_count();
        let zeros = || vec![0.0; n];
        let mut raw = Self {
            temperature: vec![temperature; n],
            enthalpy: zeros(),
            water: model.tissue.initial_water.clone(),
            juice: zeros(),
            rising: zeros(),
            fat: model.tissue.initial_fat.clone(),
            peak: vec![temperature; n],
            changed: vec![zeros(); model.response.rates.count()],
            browning: zeros(),
            charring: zeros(),
            lethality: zeros(),
            oiled: zeros(),
            open: vec![1.0; n],
            stretch: Stretch { lateral: 1.0, axial: vec![1.0; n], dome: 0.0, waves: 0.0, flattened: 0.0, draped: 0.0 },
            evaporated: 0.0,
            dripped: 0.0,
            rendered: 0.0,
            ticks: 0,
            healthy: true,
        };
        for i in 0..n {
            let film = model.tissue.raw_film[i];
            raw.water[i] += film;
            raw.juice[i] = film;
            raw.rising[i] = model.rising_film(i) * film;
            raw.enthalpy[i] = model.properties.enthalpy(&model.masses(&raw, i), temperature).0;
        }
        raw
    }

    /// Copies another state of the same piece without allocating.
    pub fn copy_from(&mut self, other: &Self) {
        let Self { temperature, enthalpy, water, juice, fat, peak, changed, browning, charring, .. } = self;
        temperature.clone_from(&other.temperature);
        enthalpy.clone_from(&other.enthalpy);
        water.clone_from(&other.water);
        juice.clone_from(&other.juice);
        self.rising.clone_from(&other.rising);
        fat.clone_from(&other.fat);
        peak.clone_from(&other.peak);
        changed.iter_mut().zip(&other.changed).for_each(|(to, from)| to.clone_from(from));
        browning.clone_from(&other.browning);
        charring.clone_from(&other.charring);
        self.lethality.clone_from(&other.lethality);
        self.oiled.clone_from(&other.oiled);
        self.open.clone_from(&other.open);
        self.stretch.axial.clone_from(&other.stretch.axial);
        self.set_scalars(other.scalars());
        (self.ticks, self.healthy) = (other.ticks, other.healthy);
    }

    /// Copies what conduction, exchange and boiling change from another state of the same piece, without allocating.
    pub(crate) fn copy_heat_from(&mut self, other: &Self) {
        self.temperature.clone_from(&other.temperature);
        self.enthalpy.clone_from(&other.enthalpy);
        self.water.clone_from(&other.water);
        (self.evaporated, self.ticks) = (other.evaporated, other.ticks);
    }

    /// Returns true if what conduction, exchange and boiling change is finite.
    pub(crate) fn has_finite_heat(&self) -> bool {
        [&self.temperature, &self.enthalpy, &self.water].into_iter().all(|field| all_finite(field))
    }

    /// Returns true if every value is finite.
    pub(crate) fn is_finite(&self) -> bool {
        let Self { juice, rising, fat, peak, changed, browning, charring, lethality, stretch, .. } = self;
        let fields = [juice, rising, fat, peak, browning, charring, lethality, &stretch.axial];
        self.has_finite_heat()
            && fields.into_iter().chain(changed).all(|f| all_finite(f))
            && all_finite(&self.scalars())
    }

    /// Returns what belongs to no node: lateral stretch, dome, waves, flattening and draping; masses evaporated, dripped and rendered.
    pub(crate) fn scalars(&self) -> [f64; 8] {
        let Stretch { lateral, dome, waves, flattened, draped, .. } = self.stretch;
        [lateral, dome, waves, flattened, draped, self.evaporated, self.dripped, self.rendered]
    }

    /// Sets what belongs to no node, in the order of [`Self::scalars`].
    pub(crate) fn set_scalars(&mut self, scalars: [f64; 8]) {
        let Stretch { lateral, dome, waves, flattened, draped, .. } = &mut self.stretch;
        [*lateral, *dome, *waves, *flattened, *draped, self.evaporated, self.dripped, self.rendered] = scalars;
    }

    /// Browning and charring of the part of a node's face that has come to brown [-].
    pub fn crust(&self, node: usize) -> (f64, f64) {
        (self.browning[node] / self.open[node], self.charring[node] / self.open[node])
    }

    /// Returns true if it has a value for each node and change of a model.
    pub fn fits(&self, model: &FoodModel) -> bool {
        let n = model.shape.mesh.node_count();
        self.changed.len() == model.response.rates.count() && self.fields().iter().all(|field| field.len() == n)
    }

    /// Returns all node fields.
    pub(crate) fn fields(&self) -> Vec<&Vec<f64>> {
        let Self { temperature, enthalpy, water, juice, rising, fat, peak, changed, .. } = self;
        let Self { browning, charring, lethality, oiled, open, stretch, .. } = self;
        let heat = [temperature, enthalpy, water, juice, rising, fat, peak];
        heat.into_iter().chain(changed).chain([browning, charring, lethality, oiled, open, &stretch.axial]).collect()
    }

    /// Returns all node fields, in the order of [`Self::fields`].
    pub(crate) fn fields_mut(&mut self) -> Vec<&mut Vec<f64>> {
        let Self { temperature, enthalpy, water, juice, rising, fat, peak, changed, .. } = self;
        let heat = [temperature, enthalpy, water, juice, rising, fat, peak];
        let surface = [&mut self.browning, &mut self.charring, &mut self.lethality, &mut self.oiled, &mut self.open];
        heat.into_iter().chain(changed).chain(surface).chain([&mut self.stretch.axial]).collect()
    }

    /// Mass of the piece [kg]: the sum over its nodes.
    pub fn mass(&self, model: &FoodModel) -> f64 {
        [&self.water, &model.tissue.lean_solids, &self.fat].iter().map(|m| m.iter().sum::<f64>()).sum()
    }

    /// Mass of the piece [kg], from the raw mass and the losses: cheap, and equal to [`Self::mass`] up to rounding.
    pub fn mass_left(&self, model: &FoodModel) -> f64 {
        model.tissue.raw_mass - self.evaporated - self.dripped - self.rendered
    }

    /// Enthalpy of the piece above 0 °C [J].
    pub fn total_enthalpy(&self) -> f64 {
        self.enthalpy.iter().sum()
    }

    /// Returns the lowest and the highest node temperature [K].
    pub fn range(&self) -> (f64, f64) {
        let low = self.temperature.iter().copied().fold(f64::INFINITY, f64::min);
        let high = self.temperature.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        (low, high)
    }

    /// Temperature of a node [°C].
    pub fn celsius(&self, node: usize) -> f64 {
        self.temperature[node] - ZERO_C
    }
}

/// Returns true if all values of a field are finite. A sum with any other value is not; sixteen sums at a time, which the
/// compiler turns into vector instructions. Where a sum of large values overflows, each value is looked at.
pub(crate) fn all_finite(field: &[f64]) -> bool {
    let (blocks, rest) = field.as_chunks::<16>();
    let mut sums = [0.0; 16];
    for block in blocks {
        sums.iter_mut().zip(block).for_each(|(sum, v)| *sum += v);
    }
    let all = sums.iter().chain(rest).sum::<f64>();
    all.is_finite() || field.iter().all(|v| v.is_finite())
}

#[cfg(test)]
mod tests {
    use super::all_finite;

    #[test]
    fn one_value_that_is_not_finite_is_found_wherever_it_stands() {
        for length in [0, 1, 15, 16, 17, 80] {
            let field: Vec<f64> = (0..length).map(|i| f64::from(i) - 3.0).collect();
            assert!(all_finite(&field));
            for at in 0..field.len() {
                for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                    let mut spoilt = field.clone();
                    spoilt[at] = value;
                    assert!(!all_finite(&spoilt), "{value} at {at} of {length}");
                }
            }
        }
        assert!(all_finite(&[f64::MAX, -f64::MAX, f64::MIN_POSITIVE, 1.0, f64::MAX, f64::MAX, -0.0, 0.0].repeat(5)));
    }
}
