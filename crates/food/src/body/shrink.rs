//! Shrinkage: contraction and bending of a piece as it loses water and fat.

use libm::{exp, log};
use saute_heat::{Layout, SweptMesh};

use crate::description::Effects;
use crate::model::FoodModel;
use crate::state::{FoodState, Stretch};
use crate::{GRAVITY, ZERO_C};

/// Poisson's ratio of meat [-] (nearly incompressible: 0.5).
pub(super) const POISSON: f64 = 0.5;
/// Temperature of the rest volumes [K] (chosen: room temperature).
const REST: f64 = ZERO_C + 20.0;

/// Sums over a laminated plate, by level from the bottom.
#[derive(Default)]
struct Plate {
    /// Stiffness per width E·h [N/m].
    stiffness: f64,
    /// First moments of stiffness and of stiffness × contraction about the bottom.
    height: f64,
    contraction: f64,
    /// Second moments.
    height_squared: f64,
    contraction_height: f64,
}

impl Plate {
    fn add(&mut self, modulus: f64, thickness: f64, z: f64, contraction: f64) {
        let weight = modulus * thickness;
        self.stiffness += weight;
        self.height += weight * z;
        self.contraction += weight * contraction;
        self.height_squared += weight * (z * z + thickness * thickness / 12.0);
        self.contraction_height += weight * z * contraction;
    }

    /// Mean contraction of the plate [-], free curvature [1/m] and bending rigidity E·I per width [N·m].
    fn bend(&self) -> (f64, f64, f64) {
        let (middle, mean) = (self.height / self.stiffness, self.contraction / self.stiffness);
        let rigidity = self.height_squared - self.stiffness * middle * middle;
        (mean, (self.contraction_height - self.stiffness * middle * mean) / rigidity, rigidity)
    }
}

impl FoodModel {
    /// Updates the stretch ratios from water, fat and changes.
    ///
    /// The volume of a node is its rest volume less the lost water and fat, down to the least volume of the tissue; water
    /// lost beyond that leaves pores. The kinetics divide the contraction between the directions across and along the
    /// fibres. A slice is a laminated plate: across the fibres it takes the stiffness-weighted mean of its levels, and the
    /// thickness takes up the rest, so that volumes are kept. Differences between levels bend the plate. Its own weight
    /// counteracts (simply supported disc, relaxed modulus): w = (5+ν)/(64(1+ν)) p a⁴/D.
    pub fn shrink(&self, state: &mut FoodState) {
        match self.shape.mesh.layout() {
            Layout::Upright(mesh) => self.shrink_as_a_plate(mesh, state),
            Layout::Along(..) => self.shrink_freely(state),
            Layout::Cells(_) => {
                let rest = Rest::of(self);
                self.shrink_evenly(state, |state, node| rest.relative_volume(self, state, node));
            }
        }
    }

    /// Contracts a body along stations by the stiffness-weighted mean of its nodes, without bending; the difference between
    /// belly and back is [`FoodModel::curl`].
    fn shrink_freely(&self, state: &mut FoodState) {
        let rest = Rest::of(self);
        let (mut modulus, mut contraction) = (0.0, 0.0);
        for (node, size) in self.shape.mesh.volumes().iter().enumerate() {
            let volume = rest.relative_volume(self, state, node);
            state.stretch.axial[node] = volume;
            let e = size * self.node_modulus_kpa(state, node);
            modulus += e;
            contraction += e * self.free_contraction(state, node, volume);
        }
        state.stretch.contract_across(contraction / modulus);
    }

    fn shrink_as_a_plate(&self, mesh: &SweptMesh, state: &mut FoodState) {
        let n = mesh.nodes_per_level();
        let rest = Rest::of(self);
        let mut plate = Plate::default();
        let mut columns = vec![[0.0; 2]; if self.shape.waves.is_some() { n } else { 0 }];
        for (level, height) in mesh.layer_heights().iter().enumerate() {
            let (mut modulus, mut contraction) = (0.0, 0.0);
            for (i, area) in mesh.section.areas.iter().enumerate() {
                let node = level * n + i;
                let volume = rest.relative_volume(self, state, node);
                state.stretch.axial[node] = volume;
                let e = area * self.node_modulus_kpa(state, node);
                modulus += e;
                let free = self.free_contraction(state, node, volume);
                contraction += e * free;
                if let Some(column) = columns.get_mut(i) {
                    *column = [column[0] + height * e, column[1] + height * e * free];
                }
            }
            let (z, mean) = (mesh.levels[level], contraction / modulus);
            plate.add(1e3 * modulus / mesh.section.area(), *height, z, mean);
        }
        let (mean, curvature, rigidity) = plate.bend();
        state.stretch.contract_across(mean);
        let weight = GRAVITY * state.mass(self) / mesh.section.area();
        let stiff = self.kinetics.texture.relaxed_share * rigidity / (1.0 - POISSON * POISSON);
        state.stretch.dome = self.dome(curvature, weight, stiff);
        if let Some(waves) = &self.shape.waves {
            // As it dries it sets in its waves, which then sink no more.
            let now = waves.height(spread(&columns), self.thickness(state), stiff, weight);
            state.stretch.waves = state.stretch.waves.max(now);
        }
    }

    /// Logarithmic contraction across the fibres of a free node at its relative volume [-].
    pub(super) fn free_contraction(&self, state: &FoodState, node: usize, volume: f64) -> f64 {
        if volume == 1.0 {
            return 0.0;
        }
        let sum = |effects: &Effects| -> f64 { effects.of(&state.changed).map(|(x, c)| x[node] * c).sum() };
        let [across, along] = &self.response.contraction;
        let (a, b) = (-log(1.0 - sum(across)), -log(1.0 - sum(along)));
        let share = if 2.0 * a + b > 1e-9 { a / (2.0 * a + b) } else { 1.0 / 3.0 };
        -log(volume) * share
    }

    /// Height of the dome of a free curvature [1/m] that remains against a weight per area [N/m²], given the relaxed rigidity per width
    /// [N·m] [m].
    fn dome(&self, curvature: f64, weight: f64, stiff: f64) -> f64 {
        let (length, width) = (self.shape.size[0], self.shape.size[1]);
        let radius_squared = 0.125 * (length * length + width * width);
        let sag = (5.0 + POISSON) / (64.0 * (1.0 + POISSON)) * weight * radius_squared * radius_squared / stiff;
        let free = -0.5 * curvature * radius_squared;
        if free.abs() > sag { free - sag * free.signum() } else { 0.0 }
    }

    /// Present volume relative to the rest volume [-].
    pub fn relative_volume(&self, state: &FoodState) -> f64 {
        let rest = Rest::of(self);
        let volume = self.shape.mesh.volumes();
        let now: f64 = volume.iter().enumerate().map(|(i, v)| v * rest.relative_volume(self, state, i)).sum();
        now / volume.iter().sum::<f64>()
    }
}

/// Root of the mean square by which the columns of a slice would contract differently, as their elastic energies weigh it [-];
/// stiffness and stiffness × contraction of each.
fn spread(columns: &[[f64; 2]]) -> f64 {
    let [stiffness, moment] = columns.iter().fold([0.0; 2], |sum, column| [sum[0] + column[0], sum[1] + column[1]]);
    let mean = moment / stiffness;
    let one = |[stiff, moment]: &[f64; 2]| stiff * (moment / stiff - mean) * (moment / stiff - mean);
    libm::sqrt(columns.iter().map(one).sum::<f64>() / stiffness)
}

impl Stretch {
    /// Sets the lateral stretch from a logarithmic contraction; `axial` contains relative volumes and becomes the axial stretch.
    /// What presses have taken from the thickness widens both other directions.
    fn contract_across(&mut self, contraction: f64) {
        self.lateral = exp(0.5 * self.flattened - contraction);
        let area_stretch = self.lateral * self.lateral;
        self.axial.iter_mut().for_each(|a| *a /= area_stretch);
    }
}

/// Specific volumes of water and fat, and the least volume of a node.
pub(super) struct Rest {
    water: f64,
    fat: f64,
    least: f64,
}

impl Rest {
    pub(super) fn of(model: &FoodModel) -> Self {
        Self {
            water: model.properties.volume(&[1.0, 0.0, 0.0], REST),
            fat: model.properties.volume(&[0.0, 0.0, 1.0], REST),
            least: model.kinetics.shrinkage.least_volume,
        }
    }

    pub(super) fn relative_volume(&self, model: &FoodModel, state: &FoodState, node: usize) -> f64 {
        let lost = self.water * (model.tissue.initial_water[node] - state.water[node])
            + self.fat * (model.tissue.initial_fat[node] - state.fat[node]);
        // A film of juice on a face does not swell the flesh.
        (1.0 - lost / model.shape.mesh.volumes()[node]).clamp(self.least, 1.0)
    }
}
