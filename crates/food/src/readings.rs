//! What is read off a piece: core, faces, shares of doneness, colour.

use saute_heat::Cut;

use crate::colour::{Appearance, Lab};
use crate::description::{MOST_CHANGES, PerChange};
use crate::model::FoodModel;
use crate::state::{FoodState, Side};

/// Doneness by the highest temperature a point has reached (the classes of the 2013 paper).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Class {
    /// Below 50 °C.
    Raw,
    /// 50–60 °C.
    Rare,
    /// 60–70 °C.
    Medium,
    /// Above 70 °C.
    WellDone,
}

impl Class {
    /// All classes, in order.
    pub const ALL: [Self; 4] = [Self::Raw, Self::Rare, Self::Medium, Self::WellDone];

    /// Class of a peak temperature [K].
    pub fn of(peak: f64) -> Self {
        match peak - crate::ZERO_C {
            c if c < 50.0 => Self::Raw,
            c if c < 60.0 => Self::Rare,
            c if c <= 70.0 => Self::Medium,
            _ => Self::WellDone,
        }
    }
}

/// Shares of raw, rare, medium, well-done; they sum to 100 [%].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shares(pub [f64; 4]);

impl Shares {
    fn from_weights(mut sums: [f64; 4]) -> Self {
        let total: f64 = sums.iter().sum();
        if total > 0.0 {
            sums.iter_mut().for_each(|s| *s *= 100.0 / total);
        }
        Self(sums)
    }
}

/// Upper bounds of raw, rare and medium [K].
const BOUNDS: [f64; 3] = [crate::ZERO_C + 50.0, crate::ZERO_C + 60.0, crate::ZERO_C + 70.0];

/// Adds a stretch of weight `weight` along which the peak runs linearly from `a` to `b` [K]: each class gets the part
/// of the stretch that lies in it, so that shares do not jump from node to node.
fn add_stretch(sums: &mut [f64; 4], a: f64, b: f64, weight: f64) {
    let (low, high) = (a.min(b), a.max(b));
    let below = |bound: f64| {
        if high > low { ((bound - low) / (high - low)).clamp(0.0, 1.0) } else { f64::from(u8::from(low < bound)) }
    };
    let mut so_far = 0.0;
    for (sum, bound) in sums.iter_mut().zip(BOUNDS) {
        let up_to = below(bound);
        *sum += weight * (up_to - so_far);
        so_far = up_to;
    }
    sums[3] += weight * (1.0 - so_far);
}

/// The changes at a point, each read off its field.
pub fn changed_at(state: &FoodState, read: impl Fn(&[f64]) -> f64) -> PerChange {
    let mut changed = [0.0; MOST_CHANGES];
    changed.iter_mut().zip(&state.changed).for_each(|(c, field)| *c = read(field));
    changed
}

/// Area means and area shares of one face.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FaceReading {
    /// Mean temperature [K].
    pub temperature: f64,
    /// Mean colour.
    pub lab: Lab,
    /// Area with browning above 0.5 [%].
    pub browned_pct: f64,
    /// Area with charring above 0.2 [%].
    pub charred_pct: f64,
    /// Mean browning [-].
    pub browning: f64,
    /// Mean water over the raw water [-].
    pub moisture: f64,
}

impl FoodModel {
    /// Core temperature: at the rest shape's centroid [K].
    pub fn core_temperature(&self, state: &FoodState) -> f64 {
        self.at_core(&state.temperature)
    }

    /// Nodes of a face, in the order of the section's nodes.
    pub fn face(&self, side: Side) -> std::ops::Range<usize> {
        let n = self.mesh.nodes_per_level();
        match side {
            Side::Bottom => 0..n,
            Side::Top => self.mesh.node_count() - n..self.mesh.node_count(),
        }
    }

    /// Area-mean temperature of a face [K].
    pub fn face_temperature(&self, state: &FoodState, side: Side) -> f64 {
        let areas = &self.mesh.section.areas;
        let sum: f64 = areas.iter().zip(&state.temperature[self.face(side)]).map(|(a, t)| a * t).sum();
        sum / self.mesh.section.area()
    }

    /// Everything that is read off a face.
    pub fn face_reading(&self, state: &FoodState, side: Side) -> FaceReading {
        let mut reading = FaceReading::default();
        let whole = self.mesh.section.area();
        for (node, area) in self.face(side).zip(&self.mesh.section.areas) {
            let share = area / whole;
            let colour = self.node_colour(state, node).0;
            (0..3).for_each(|k| reading.lab.0[k] += share * colour[k]);
            reading.temperature += share * state.temperature[node];
            reading.browning += share * state.browning[node];
            reading.moisture += share * state.water[node] / self.initial_water[node];
            reading.browned_pct += 100.0 * share * f64::from(u8::from(state.browning[node] > 0.5));
            reading.charred_pct += 100.0 * share * f64::from(u8::from(state.charring[node] > 0.2));
        }
        // The shares of the whole add up to 100 but for rounding.
        reading.browned_pct = reading.browned_pct.min(100.0);
        reading.charred_pct = reading.charred_pct.min(100.0);
        reading
    }

    /// What colours a node.
    pub fn appearance(&self, state: &FoodState, node: usize) -> Appearance {
        Appearance {
            changed: changed_at(state, |field| field[node]),
            browning: state.browning[node],
            charring: state.charring[node],
        }
    }

    /// Mean colour of a node's lean and fat.
    pub fn node_colour(&self, state: &FoodState, node: usize) -> Lab {
        let (lean, fat) = self.colours(self.appearance(state, node));
        lean.lerp(fat, self.adipose[node])
    }

    /// Volume mean of a node field.
    pub fn volume_mean(&self, field: &[f64]) -> f64 {
        let volume = &self.mesh.graph.volume;
        field.iter().zip(volume).map(|(f, v)| f * v).sum::<f64>() / volume.iter().sum::<f64>()
    }

    /// Log₁₀ reduction of pathogens at the core and at the least heated point of the surface [-].
    pub fn log_reduction(&self, state: &FoodState) -> (f64, f64) {
        let surface = self.patches.iter().filter(|p| p.area > 0.0);
        let least = surface.map(|p| state.lethality[p.node as usize]).fold(f64::INFINITY, f64::min);
        (self.at_core(&state.lethality), least)
    }

    /// A value plus what the changes of a node contribute.
    fn with_changes(&self, base: f64, contributions: &PerChange, state: &FoodState, node: usize) -> f64 {
        state.changed.iter().zip(contributions).fold(base, |sum, (x, c)| sum + c * x[node])
    }

    /// Elastic modulus of a node [kPa].
    pub fn node_modulus_kpa(&self, state: &FoodState, node: usize) -> f64 {
        self.with_changes(self.kinetics.texture.raw_kpa, &self.modulus, state, node)
    }

    /// Volume mean of a value that depends on a node.
    fn mean_of(&self, value: impl Fn(usize) -> f64) -> f64 {
        let volume = &self.mesh.graph.volume;
        let sum: f64 = volume.iter().enumerate().map(|(node, v)| v * value(node)).sum();
        sum / volume.iter().sum::<f64>()
    }

    /// Volume mean of the elastic modulus: raw plus each change's share of its contribution [kPa].
    pub fn elastic_modulus_kpa(&self, state: &FoodState) -> f64 {
        self.mean_of(|node| self.node_modulus_kpa(state, node))
    }

    /// Volume mean of the hardness on biting over that of the raw food [-].
    pub fn hardness_index(&self, state: &FoodState) -> f64 {
        self.mean_of(|node| self.with_changes(1.0, &self.hardness, state, node))
    }

    /// Volume mean of the juiciness: water left over raw water, times one plus the changes' contributions [%].
    pub fn juiciness_pct(&self, state: &FoodState) -> f64 {
        let left = |node: usize| (state.water[node] / self.initial_water[node]).min(1.0);
        100.0 * self.mean_of(|node| left(node) * self.with_changes(1.0, &self.juiciness, state, node))
    }

    /// Doneness by volume.
    pub fn volume_shares(&self, state: &FoodState) -> Shares {
        let mut sums = [0.0; 4];
        let n = self.mesh.nodes_per_level();
        for (level, height) in self.mesh.levels.windows(2).map(|w| w[1] - w[0]).enumerate() {
            let (lower, upper) = state.peak[level * n..(level + 2) * n].split_at(n);
            for (i, area) in self.mesh.section.areas.iter().enumerate() {
                add_stretch(&mut sums, lower[i], upper[i], area * height);
            }
        }
        Shares::from_weights(sums)
    }

    /// The cut across the longest axis at distance `x` from the centroid along it [m].
    pub fn cut_across(&self, x: f64) -> Cut {
        let direction = if self.size[0] >= self.size[1] { [0.0, 1.0] } else { [-1.0, 0.0] };
        let point = if self.size[0] >= self.size[1] { [x, 0.0] } else { [0.0, x] };
        Cut::new(&self.mesh.section, point, direction)
    }

    /// Doneness of a cut by area.
    pub fn cut_shares(&self, state: &FoodState, cut: &Cut) -> Shares {
        let mut sums = [0.0; 4];
        let n = self.mesh.nodes_per_level();
        let lengths = cut.lengths();
        for (level, height) in self.mesh.levels.windows(2).map(|w| w[1] - w[0]).enumerate() {
            let (lower, upper) = state.peak[level * n..(level + 2) * n].split_at(n);
            for (i, length) in lengths.iter().enumerate() {
                add_stretch(&mut sums, cut.sample(i, lower), cut.sample(i, upper), length * height);
            }
        }
        Shares::from_weights(sums)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_linear_stretch_is_shared_out_at_the_bounds() {
        let mut sums = [0.0; 4];
        add_stretch(&mut sums, crate::ZERO_C + 80.0, crate::ZERO_C + 40.0, 4.0);
        let expected = [1.0, 1.0, 1.0, 1.0];
        assert!(sums.iter().zip(expected).all(|(s, e)| (s - e).abs() < 1e-9), "{sums:?}");
        let mut even = [0.0; 4];
        add_stretch(&mut even, crate::ZERO_C + 55.0, crate::ZERO_C + 55.0, 2.0);
        assert_eq!(even, [0.0, 2.0, 0.0, 0.0]);
    }
}
