//! A poured piece in another shape: the same food, spread otherwise.

use saute_heat::{Layout, Located, SweptMesh};

use crate::model::FoodModel;
use crate::state::{FoodState, Stretch};

impl FoodModel {
    /// Returns the state of a poured piece that has run from the shape of `before` into this one.
    ///
    /// A place takes what was as far out in the same direction, layer by layer. The masses of water and fat and the enthalpy are those of
    /// before to rounding: fields are scaled to their old sums, and what is missing of the enthalpy is handed out by heat capacity. Juice,
    /// a part of the water, stays within it at every node. What has happened to the food (changes, browning, lethality, peaks) keeps its mean
    /// over the volume: nothing un-cooks. Its ticks go on.
    pub fn repoured(&self, before: &Self, state: &FoodState) -> FoodState {
        let (Layout::Upright(new), Layout::Upright(old)) = (self.shape.mesh.layout(), before.shape.mesh.layout())
        else {
            return state.clone();
        };
        let sources = self.sources(before, new, old);
        let read = |field: &[f64]| read(field, &sources, old.nodes_per_level(), new.levels.len());
        let relative = |field: &[f64], to: &[f64]| -> Vec<f64> {
            let share: Vec<f64> = field.iter().zip(to).map(|(v, of)| if *of > 0.0 { v / of } else { 0.0 }).collect();
            read(&share)
        };
        let spread = |field: &[f64], raw: [&Vec<f64>; 2]| {
            let shares = relative(field, raw[0]);
            scaled(shares.iter().zip(raw[1]).map(|(share, raw)| share * raw).collect(), field.iter().sum())
        };
        let volumes = [before.shape.mesh.volumes(), self.shape.mesh.volumes()];
        let share = |field: &Vec<f64>| share_kept(read(field), volumes[1], mean(field, volumes[0]));
        let scaled_mean = |field: &Vec<f64>| mean_kept(read(field), volumes[1], mean(field, volumes[0]));
        let (old_tissue, tissue) = (&before.tissue, &self.tissue);
        let water = [&old_tissue.initial_water, &tissue.initial_water];
        let mut poured = FoodState {
            temperature: read(&state.temperature),
            enthalpy: Vec::new(),
            water: spread(&state.water, water),
            juice: spread(&state.juice, water),
            rising: spread(&state.rising, water),
            fat: spread(&state.fat, [&old_tissue.initial_fat, &tissue.initial_fat]),
            peak: scaled_mean(&state.peak),
            changed: state.changed.iter().map(share).collect(),
            browning: scaled_mean(&state.browning),
            charring: scaled_mean(&state.charring),
            lethality: scaled_mean(&state.lethality),
            oiled: read(&state.oiled),
            open: read(&state.open),
            stretch: Stretch { axial: read(&state.stretch.axial), ..state.stretch },
            ..*state
        };
        // Juice is a part of the water, and what rises of the juice.
        for (part, whole) in poured.juice.iter_mut().zip(&poured.water) {
            *part = part.min(*whole);
        }
        for (part, whole) in poured.rising.iter_mut().zip(&poured.juice) {
            *part = part.min(*whole);
        }
        self.warm(&mut poured, state.total_enthalpy());
        poured
    }

    /// Where each column of this shape finds its state in the other one.
    fn sources(&self, before: &Self, new: &SweptMesh, old: &SweptMesh) -> Vec<Located> {
        let pools = self.shape.pool.as_ref().zip(before.shape.pool.as_ref());
        let source = |p: &[f64; 2]| {
            let place = pools.map_or(*p, |(to, from)| to.place_in(from, *p));
            old.locate_or_nearest(place)
        };
        new.section.points.iter().map(source).collect()
    }

    /// Gives every node the enthalpy of its temperature, and all of them together the stated sum [J].
    fn warm(&self, state: &mut FoodState, total: f64) {
        let nodes = 0..state.temperature.len();
        let heats: Vec<(f64, f64)> =
            nodes.map(|i| self.properties.enthalpy(&self.masses(state, i), state.temperature[i])).collect();
        let [sum, capacity] = heats.iter().fold([0.0; 2], |[h, c], heat| [h + heat.0, c + heat.1]);
        let missing = (total - sum) / capacity;
        state.enthalpy = heats.iter().map(|(heat, capacity)| heat + missing * capacity).collect();
        for i in 0..state.temperature.len() {
            let masses = self.masses(state, i);
            state.temperature[i] = self.properties.temperature(&masses, state.enthalpy[i], state.temperature[i]).0;
        }
    }
}

/// A field of nodes at the sources of the new columns, level by level.
fn read(field: &[f64], sources: &[Located], per_level: usize, levels: usize) -> Vec<f64> {
    let at = |level: usize, found: &Located| -> f64 {
        (0..3).map(|k| found.weights[k] * field[level * per_level + found.nodes[k] as usize]).sum()
    };
    (0..levels).flat_map(|level| sources.iter().map(move |found| at(level, found))).collect()
}

/// A field scaled to a sum.
fn scaled(mut field: Vec<f64>, sum: f64) -> Vec<f64> {
    let now: f64 = field.iter().sum();
    if now > 0.0 {
        field.iter_mut().for_each(|v| *v *= sum / now);
    }
    field
}

/// Mean of a field over the volumes of its nodes, in its unit.
fn mean(field: &[f64], volumes: &[f64]) -> f64 {
    field.iter().zip(volumes).map(|(v, volume)| v * volume).sum::<f64>() / volumes.iter().sum::<f64>()
}

/// A field scaled to a mean over the volume.
fn mean_kept(mut field: Vec<f64>, volumes: &[f64], kept: f64) -> Vec<f64> {
    let now = mean(&field, volumes);
    if now > 0.0 {
        field.iter_mut().for_each(|v| *v *= kept / now);
    }
    field
}

/// Shares with a mean over the volume, none beyond 1: where too little has changed, what is left shrinks.
fn share_kept(field: Vec<f64>, volumes: &[f64], kept: f64) -> Vec<f64> {
    let field: Vec<f64> = field.into_iter().map(|x| x.clamp(0.0, 1.0)).collect();
    if mean(&field, volumes) >= kept {
        return mean_kept(field, volumes, kept);
    }
    let left = field.into_iter().map(|x| 1.0 - x).collect();
    mean_kept(left, volumes, 1.0 - kept).into_iter().map(|x| (1.0 - x).clamp(0.0, 1.0)).collect()
}
