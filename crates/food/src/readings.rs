//! Readings of a piece: core, faces, colour, texture, shares of doneness.

use saute_heat::{Cut, CutPoint, Layout};
use serde::{Deserialize, Serialize};

use crate::ZERO_C;
use crate::change::colour::{Appearance, Lab};
use crate::change::doneness::{MOST_CLASSES, Measure, Scale, Shares};
use crate::description::{Effects, MOST_CHANGES, PerChange};
use crate::model::FoodModel;
use crate::state::FoodState;

/// Returns the changes at a point, each read from its node field [-].
pub fn changed_at(state: &FoodState, read: impl Fn(&[f64]) -> f64) -> PerChange {
    let mut changed = [0.0; MOST_CHANGES];
    changed.iter_mut().zip(&state.changed).for_each(|(c, field)| *c = read(field));
    changed
}

/// Area means and area shares of a face.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct FaceReading {
    /// Mean temperature [K].
    pub temperature: f64,
    /// Mean colour.
    pub lab: Lab,
    /// Area with browning above 0.5 [%].
    pub browned_pct: f64,
    /// Area browned where the metal reaches it [%]: on ridges, of the bars; else the same as what is browned of the whole.
    pub crust_pct: f64,
    /// Area with charring above 0.2 [%].
    pub charred_pct: f64,
    /// Mean browning [-].
    pub browning: f64,
    /// Mean water relative to the raw water [-].
    pub moisture: f64,
}

impl FoodModel {
    /// Core temperature [K]: at the rest shape's centroid, or in the middle of the thickest section of a curved body.
    pub fn core_temperature(&self, state: &FoodState) -> f64 {
        self.at_core(&state.temperature)
    }

    /// Returns true while the core is colder than the beginning of freezing.
    pub fn core_is_ice(&self, state: &FoodState) -> bool {
        let freezing = self.description.freezing.as_ref();
        freezing.is_some_and(|ice| self.core_temperature(state) < ZERO_C + ice.begins_c)
    }

    /// Area-mean temperature of the lower face [K].
    ///
    /// `up` is the world's upward direction in the body frame; the opposite direction gives the upper face.
    pub fn face_temperature(&self, state: &FoodState, up: [f64; 3]) -> f64 {
        let (mut sum, mut area) = (0.0, 0.0);
        for patch in self.patches_below(up).map(|i| &self.shape.patches[i]) {
            sum += patch.area * state.temperature[patch.node as usize];
            area += patch.area;
        }
        sum / area
    }

    /// Mean browning of the lower face where the metal reaches it [-], with `up` as in [`Self::face_temperature`].
    pub fn face_browning(&self, state: &FoodState, up: [f64; 3]) -> f64 {
        let whole: f64 = self.patches_below(up).map(|i| self.shape.patches[i].area).sum();
        let below = self.patches_below(up).map(|i| &self.shape.patches[i]);
        below.fold(0.0, |sum, patch| sum + patch.area / whole * state.crust(patch.node as usize).0)
    }

    /// Returns area means and shares of the lower face, with `up` as in [`Self::face_temperature`].
    pub fn face_reading(&self, state: &FoodState, up: [f64; 3]) -> FaceReading {
        let mut reading = FaceReading::default();
        let whole: f64 = self.patches_below(up).map(|i| self.shape.patches[i].area).sum();
        for patch in self.patches_below(up).map(|i| &self.shape.patches[i]) {
            let (node, share) = (patch.node as usize, patch.area / whole);
            let colour = self.node_colour(state, node).0;
            (0..3).for_each(|k| reading.lab.0[k] += share * colour[k]);
            reading.temperature += share * state.temperature[node];
            reading.browning += share * state.browning[node];
            reading.moisture += share * state.water[node] / self.tissue.initial_water[node];
            let (open, (browning, charring)) = (state.open[node], state.crust(node));
            let crust = 100.0 * share * f64::from(u8::from(browning > 0.5));
            reading.crust_pct += crust;
            reading.browned_pct += open * crust;
            reading.charred_pct += 100.0 * share * open * f64::from(u8::from(charring > 0.2));
        }
        // Rounding may carry the sum of the shares above 100.
        reading.crust_pct = reading.crust_pct.min(100.0);
        reading.browned_pct = reading.browned_pct.min(100.0);
        reading.charred_pct = reading.charred_pct.min(100.0);
        reading
    }

    /// Returns the state that determines the colour of a node.
    pub fn appearance(&self, state: &FoodState, node: usize) -> Appearance {
        Appearance {
            changed: changed_at(state, |field| field[node]),
            browning: state.browning[node],
            charring: state.charring[node],
            tissue: self.tissue.second[node],
        }
    }

    /// Mean colour of the lean flesh and the fat of a node: of a face on ridges, of the bars and of what is between them.
    pub fn node_colour(&self, state: &FoodState, node: usize) -> Lab {
        let (mut seen, open) = (self.appearance(state, node), state.open[node]);
        (seen.browning, seen.charring) = state.crust(node);
        let bars = self.colour_of(seen, node);
        if open == 1.0 {
            return bars;
        }
        (seen.browning, seen.charring) = (0.0, 0.0);
        self.colour_of(seen, node).lerp(bars, open)
    }

    /// Colour of a node's lean flesh and fat in a state.
    fn colour_of(&self, seen: Appearance, node: usize) -> Lab {
        let (lean, fat) = self.colours(seen);
        lean.lerp(fat, self.tissue.adipose[node])
    }

    /// Volume mean of a node field, in the unit of the field.
    pub fn volume_mean(&self, field: &[f64]) -> f64 {
        let volume = self.shape.mesh.volumes();
        field.iter().zip(volume).map(|(f, v)| f * v).sum::<f64>() / volume.iter().sum::<f64>()
    }

    /// Returns the log₁₀ reduction of pathogens at the core and at the least heated point of the original surface [-].
    pub fn log_reduction(&self, state: &FoodState) -> (f64, f64) {
        let surface = self.shape.patches[..self.fresh_faces().start].iter().filter(|p| p.area > 0.0);
        let least = surface.map(|p| state.lethality[p.node as usize]).fold(f64::INFINITY, f64::min);
        (self.at_core(&state.lethality), least)
    }

    /// A base value plus the contributions of the changes of a node.
    fn with_changes(&self, base: f64, contributions: &Effects, state: &FoodState, node: usize) -> f64 {
        contributions.of(&state.changed).fold(base, |sum, (x, c)| sum + c * x[node])
    }

    /// Elastic modulus of a node [kPa].
    pub fn node_modulus_kpa(&self, state: &FoodState, node: usize) -> f64 {
        self.with_changes(self.kinetics.texture.raw_kpa, &self.response.modulus, state, node)
    }

    /// Volume mean of a value of each node.
    fn mean_of(&self, value: impl Fn(usize) -> f64) -> f64 {
        let volume = self.shape.mesh.volumes();
        let sum: f64 = volume.iter().enumerate().map(|(node, v)| v * value(node)).sum();
        sum / volume.iter().sum::<f64>()
    }

    /// Volume mean of the elastic modulus [kPa]: the raw modulus plus the contributions of the changes.
    pub fn elastic_modulus_kpa(&self, state: &FoodState) -> f64 {
        self.mean_of(|node| self.node_modulus_kpa(state, node))
    }

    /// Volume mean of the hardness on biting relative to the raw food [-].
    pub fn hardness_index(&self, state: &FoodState) -> f64 {
        self.mean_of(|node| self.with_changes(1.0, &self.response.hardness, state, node))
    }

    /// Volume mean of the juiciness [%]: the remaining share of the raw water, times 1 plus the contributions of the changes.
    pub fn juiciness_pct(&self, state: &FoodState) -> f64 {
        let left = |node: usize| (state.water[node] / self.tissue.initial_water[node]).min(1.0);
        100.0 * self.mean_of(|node| left(node) * self.with_changes(1.0, &self.response.juiciness, state, node))
    }

    /// Angle of the curl [rad]: difference of contraction over the depth, times the length.
    pub fn curl(&self, state: &FoodState) -> f64 {
        if self.response.curl.is_empty() {
            return 0.0;
        }
        let difference = self.mean_of(|node| self.with_changes(0.0, &self.response.curl, state, node));
        // A body on its side curls across its width, a slice through its thickness.
        difference * self.shape.size[0] / if self.shape.is_slice() { self.shape.size[2] } else { self.shape.size[1] }
    }

    /// Share of a change at each node [-]; none if the kinetics do not contain it.
    pub fn changed<'a>(&self, state: &'a FoodState, name: &str) -> Option<&'a [f64]> {
        let place = self.kinetics.change.iter().position(|c| c.name == name)?;
        state.changed.get(place).map(Vec::as_slice)
    }

    /// Field of the nodes that a scale measures [K or -]: the highest temperature so far, or the share of its change. Of a
    /// change that the kinetics do not contain the field is empty.
    pub fn measured<'a>(&self, state: &'a FoodState, scale: &Scale) -> &'a [f64] {
        match scale.measure() {
            Measure::Peak => &state.peak,
            Measure::Share => self.changed(state, &scale.for_change).unwrap_or(&[]),
        }
    }

    /// Share of a change by which a scale calls a piece [-]: at the core, or the mean over the second tissue where the scale is about it.
    pub fn core_share(&self, field: &[f64], scale: &Scale) -> f64 {
        if !scale.of_second {
            return self.at_core(field);
        }
        let weights = self.shape.mesh.volumes().iter().zip(&self.tissue.second);
        let (sum, weight) = field
            .iter()
            .zip(weights)
            .fold((0.0, 0.0), |(sum, all), (x, (volume, second))| (sum + x * volume * second, all + volume * second));
        if weight > 0.0 { sum / weight } else { 0.0 }
    }

    /// Shares of doneness by volume [%].
    pub fn volume_shares(&self, state: &FoodState, scale: &Scale) -> Shares {
        let field = self.measured(state, scale);
        if field.is_empty() {
            return Shares::default();
        }
        let Some(mesh) = self.shape.mesh.swept() else { return self.cell_volume_shares(field, scale) };
        let mut sums = [0.0; MOST_CLASSES];
        let n = mesh.nodes_per_level();
        for level in 0..mesh.levels.len() - 1 {
            let (lower, upper) = field[level * n..(level + 2) * n].split_at(n);
            for i in 0..n {
                let counts = self.counted(scale, [mesh.node(level, i), mesh.node(level + 1, i)]);
                scale.add_stretch(&mut sums, lower[i], upper[i], counts * mesh.between(level, i));
            }
        }
        Shares::from_weights(sums)
    }

    /// Share of the stretch between two nodes that counts on a scale [-].
    fn counted(&self, scale: &Scale, ends: [usize; 2]) -> f64 {
        let second = |node: usize| self.tissue.second[node];
        if scale.of_second { 0.5 * (second(ends[0]) + second(ends[1])) } else { 1.0 }
    }

    /// Returns the cut that shows the inside: of a slice across its longest axis, at the distance `x` from the centroid [m].
    ///
    /// A body along stations is cut in its middle plane, whatever `x` is. The cut of a body of cells is empty.
    pub fn cut_across(&self, x: f64) -> Cut {
        let along_x = self.shape.size[0] >= self.shape.size[1];
        match self.shape.mesh.layout() {
            Layout::Upright(mesh) if along_x => Cut::new(&mesh.section, [x, 0.0], [0.0, 1.0]),
            Layout::Upright(mesh) => Cut::new(&mesh.section, [0.0, x], [-1.0, 0.0]),
            Layout::Along(mesh, _) => Cut::new(&mesh.section, [0.0, 0.0], [1.0, 0.0]),
            Layout::Cells(_) => Cut::default(),
        }
    }

    /// Shares of doneness of a cut by area, or of the middle cut of a body of cells [%].
    pub fn cut_shares(&self, state: &FoodState, cut: &Cut, scale: &Scale) -> Shares {
        let field = self.measured(state, scale);
        if field.is_empty() {
            return Shares::default();
        }
        let Some(mesh) = self.shape.mesh.swept() else { return self.cell_cut_shares(field, scale) };
        let mut sums = [0.0; MOST_CLASSES];
        let n = mesh.nodes_per_level();
        let lengths = cut.lengths();
        for (level, height) in mesh.levels.windows(2).map(|w| w[1] - w[0]).enumerate() {
            let (lower, upper) = field[level * n..(level + 2) * n].split_at(n);
            let (below, above) = self.tissue.second[level * n..(level + 2) * n].split_at(n);
            let wide = 0.5 * (self.cut_breadth(cut, level) + self.cut_breadth(cut, level + 1));
            for (i, length) in lengths.iter().enumerate() {
                let counts = if scale.of_second { 0.5 * (cut.sample(i, below) + cut.sample(i, above)) } else { 1.0 };
                let area = counts * wide * length * height;
                scale.add_stretch(&mut sums, cut.sample(i, lower), cut.sample(i, upper), area);
            }
        }
        Shares::from_weights(sums)
    }

    /// Breadth of the body along a cut at a level, relative to that of the section [-].
    pub fn cut_breadth(&self, cut: &Cut, level: usize) -> f64 {
        let (Some(first), Some(last)) = (cut.points.first(), cut.points.last()) else { return 1.0 };
        let Layout::Along(_, stations) = self.shape.mesh.layout() else { return 1.0 };
        let across = |level: usize, p: &CutPoint| {
            let at = |k: usize| stations[level].section.points[p.nodes[k] as usize][0];
            at(0) * (1.0 - p.share) + at(1) * p.share
        };
        (across(level, last) - across(level, first)) / (last.along - first.along)
    }
}
