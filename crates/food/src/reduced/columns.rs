//! How the columns of a slice are handed out to those of a coarser section.

use saute_heat::{Located, SweptMesh};

/// Rounds of balancing [-] (chosen: the volumes of the columns are then right to a millionth).
const ROUNDS: usize = 60;

/// The coarse columns to which each full one goes, with its shares: their sum is 1.
#[derive(Clone, Debug)]
pub(super) struct Columns {
    shares: Vec<Located>,
    count: usize,
}

impl Columns {
    /// Hands out the columns of a mesh to those of a coarser one: by linear interpolation, then balanced so that each
    /// coarse column gets its volume (iterative proportional fitting; the volumes of both meshes have the same sum).
    pub(super) fn between(fine: &SweptMesh, coarse: &SweptMesh) -> Self {
        let shares = fine.section.points.iter().map(|p| coarse.locate_or_nearest(*p)).collect();
        let mut columns = Self { shares, count: coarse.nodes_per_level() };
        let (given, wanted) = (volumes(fine), volumes(coarse));
        (0..ROUNDS).for_each(|_| columns.balance(&given, &wanted));
        columns
    }

    fn balance(&mut self, given: &[f64], wanted: &[f64]) {
        let got = self.sums(given);
        for share in &mut self.shares {
            for (node, weight) in share.nodes.into_iter().zip(&mut share.weights) {
                let node = node as usize;
                // Rounding makes shares outside the section slightly negative.
                *weight = weight.max(0.0) * if got[node] > 0.0 { wanted[node] / got[node] } else { 1.0 };
            }
            let sum: f64 = share.weights.iter().sum();
            share.weights.iter_mut().for_each(|weight| *weight /= sum);
        }
    }

    /// Sums of a field of the full mesh, level by level, in the unit of the field.
    pub(super) fn sums(&self, field: &[f64]) -> Vec<f64> {
        let levels = field.len() / self.shares.len();
        let mut sums = vec![0.0; levels * self.count];
        for (from, to) in field.chunks(self.shares.len()).zip(sums.chunks_mut(self.count)) {
            for (value, share) in from.iter().zip(&self.shares) {
                (0..3).for_each(|k| to[share.nodes[k] as usize] += share.weights[k] * value);
            }
        }
        sums
    }

    /// Means of a field of the full mesh, level by level, given the weight of each of its nodes; in the unit of the field.
    pub(super) fn means(&self, field: &[f64], weights: &[f64]) -> Vec<f64> {
        let weighted: Vec<f64> = field.iter().zip(weights).map(|(value, weight)| value * weight).collect();
        let whole = self.sums(&weights[..field.len()]);
        self.sums(&weighted).iter().zip(whole).map(|(sum, whole)| if whole > 0.0 { sum / whole } else { 0.0 }).collect()
    }
}

/// Volume of each column over the mean height of the slice [m²].
fn volumes(mesh: &SweptMesh) -> Vec<f64> {
    mesh.section.areas.iter().enumerate().map(|(i, area)| area * mesh.path.column(i)).collect()
}
