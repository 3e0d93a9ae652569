//! Raw composition of every node: masses of water, lean solids and fat, and shares of the tissues.

use saute_heat::BodyMesh;

use crate::ZERO_C;
use crate::body::rest_shape::RestShape;
use crate::components::{Masses, Properties};
use crate::description::FoodDescription;
use crate::tissue::fat_cap::FatCap;
use crate::tissue::marbling_volume::MarblingVolume;
use crate::tissue::node_means::{Samples, node_means};
use crate::tissue::seam_blocks::SeamBlocks;
use crate::tissue::second_tissue::TissueField;

/// Samples of seams and of second tissues in each of the dozen pieces of a node's volume (chosen: seams are finer than nodes,
/// and a node's fat is right within 2 %; tissues change over many nodes).
const SEAM_SAMPLES: Samples = Samples::Each(256);
/// The same in a piece with its natural form (chosen: nearly as exact in a seventh of the time; a plain piece keeps its bits).
const NATURAL_SAMPLES: Samples = Samples::Single(21);
const TISSUE_SAMPLES: Samples = Samples::Each(4);

/// Raw masses of every node and the tissues that they come from.
#[derive(Clone, Debug)]
pub(crate) struct NodeTissue {
    /// Raw water of each node [kg].
    pub(crate) initial_water: Vec<f64>,
    /// Lean solids of each node [kg].
    pub(crate) lean_solids: Vec<f64>,
    /// Raw fat of each node [kg].
    pub(crate) initial_fat: Vec<f64>,
    /// Film of juice on the faces of the raw piece, beside the flesh's own water [kg].
    pub(crate) raw_film: Vec<f64>,
    /// Raw mass of the piece, with its film [kg].
    pub(crate) raw_mass: f64,
    /// Raw share of adipose tissue of each node [-].
    pub(crate) adipose: Vec<f64>,
    /// Lean solids that adipose tissue lacks, over those of lean flesh [-].
    lacking: f64,
    /// Share of the second tissue of each node [-].
    pub(crate) second: Vec<f64>,
    pub(crate) marbling: MarblingVolume,
    pub(crate) field: TissueField,
    /// Conductivity of the raw lean tissue at 20 °C [W/(m·K)].
    raw_conductivity: f64,
}

impl NodeTissue {
    /// The tissues of a piece, seeded.
    pub(crate) fn new(food: &FoodDescription, properties: &Properties, shape: &RestShape, seed: u64) -> Self {
        let cap = food.fat_cap.as_ref().filter(|_| shape.natural);
        let cap = cap.map(|cap| FatCap::new(cap, &shape.outline, shape.size, seed));
        let marbling = MarblingVolume::with_cap(food.marbling.as_ref(), cap.as_ref(), seed, &shape.mesh);
        let field = TissueField::new(food, shape.size, seed, shape.pool.as_ref());
        let adipose = Self::adipose_shares(&marbling, shape);
        let second = node_means(&shape.mesh, Some(&field).filter(|field| !field.is_plain()), TISSUE_SAMPLES);
        let lean = &food.lean;
        let mut tissue = Self {
            initial_water: Vec::new(),
            lean_solids: Vec::new(),
            initial_fat: Vec::new(),
            raw_film: Vec::new(),
            raw_mass: 0.0,
            raw_conductivity: properties.conductivity(&[lean.water, lean.lean_solids(), lean.fat], ZERO_C + 20.0),
            adipose,
            lacking: food.adipose.as_ref().map_or(0.0, |adipose| 1.0 - adipose.lean_solids() / lean.lean_solids()),
            second,
            marbling,
            field,
        };
        tissue.fill(food, properties, shape.mesh.volumes());
        if let Some(yolk) = &food.yolk {
            tissue.portion(food, properties, yolk.share, shape.mesh.volumes().iter().sum());
        }
        tissue
    }

    /// Share of adipose tissue of each node [-].
    fn adipose_shares(marbling: &MarblingVolume, shape: &RestShape) -> Vec<f64> {
        let seams = Some(marbling).filter(|marbling| marbling.holds_fat());
        if shape.natural {
            node_means(&shape.mesh, seams.map(SeamBlocks::new).as_ref(), NATURAL_SAMPLES)
        } else {
            node_means(&shape.mesh, seams, SEAM_SAMPLES)
        }
    }

    /// Gives every node the masses of its volume of lean, second and adipose tissue at 20 °C.
    fn fill(&mut self, food: &FoodDescription, properties: &Properties, volumes: &[f64]) {
        for (node, volume) in volumes.iter().enumerate() {
            let fractions = mixed(food, self.adipose[node], self.second[node]);
            let mass = volume / properties.volume(&fractions, ZERO_C + 20.0);
            self.initial_water.push(mass * fractions[0]);
            self.lean_solids.push(mass * fractions[1]);
            self.initial_fat.push(mass * fractions[2]);
        }
        let all = [&self.initial_water, &self.lean_solids, &self.initial_fat];
        self.raw_mass = all.iter().map(|m| m.iter().sum::<f64>()).sum();
    }

    /// Scales the masses of a poured piece to those of its volumes of white and yolk, whatever its shape.
    fn portion(&mut self, food: &FoodDescription, properties: &Properties, share: f64, volume: f64) {
        let parts = [1.0 - share, share].map(|part| part * volume);
        let tissues = [0.0, 1.0].map(|second| mixed(food, 0.0, second));
        let mass = |k: usize| parts[k] / properties.volume(&tissues[k], ZERO_C + 20.0);
        let whole: Masses = core::array::from_fn(|i| (0..2).map(|k| mass(k) * tissues[k][i]).sum());
        let fields = [&mut self.initial_water, &mut self.lean_solids, &mut self.initial_fat];
        for (field, whole) in fields.into_iter().zip(whole) {
            let sum: f64 = field.iter().sum();
            let scale = if sum > 0.0 { whole / sum } else { 1.0 };
            field.iter_mut().for_each(|mass| *mass *= scale);
        }
        self.raw_mass = whole.iter().sum();
    }

    /// Lean solids of a node that can char, over those of lean flesh [-].
    #[inline]
    pub(crate) fn charring_solids(&self, node: usize) -> f64 {
        1.0 - self.adipose[node] * self.lacking
    }

    /// Lowers the conductance of the edges that cross borders of sheaths, by the conductivity of the raw flesh.
    pub(crate) fn part_sheaths(&self, mesh: &mut BodyMesh) {
        let shares: Vec<f64> = (0..mesh.graph().ends.len()).map(|edge| self.sheath_share(mesh, edge)).collect();
        mesh.graph_mut().shape.iter_mut().zip(shares).for_each(|(shape, share)| *shape *= share);
    }

    /// Share of an edge's conductance that the borders of sheaths leave [-].
    pub(crate) fn sheath_share(&self, mesh: &BodyMesh, edge: usize) -> f64 {
        let ends = mesh.graph().ends[edge].map(|node| mesh.position(node as usize));
        self.field.share_across(ends, self.raw_conductivity)
    }
}

/// Mass fractions of water, lean solids and fat at shares `s` of adipose and `t` of second tissue [-].
fn mixed(food: &FoodDescription, s: f64, t: f64) -> Masses {
    let (lean, other) = (&food.lean, food.second_tissue());
    let adipose = food.adipose.as_ref().unwrap_or(lean);
    let mix = |l: f64, o: f64, a: f64| (1.0 - s) * (l + t * (o - l)) + s * a;
    [
        mix(lean.water, other.water, adipose.water),
        mix(lean.lean_solids(), other.lean_solids(), adipose.lean_solids()),
        mix(lean.fat, other.fat, adipose.fat),
    ]
}
