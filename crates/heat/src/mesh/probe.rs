//! A point inside a mesh, with the nodes and weights that interpolate at it.

use crate::mesh::cells::Weights;

/// A point inside a mesh, as linear interpolation weights of nodes [-].
#[derive(Clone, Debug, PartialEq)]
pub enum Probe {
    /// Between two levels of a swept mesh.
    Levels {
        /// Nodes of the triangle around the point on the lower and on the upper level.
        nodes: [[u32; 3]; 2],
        /// Linear shape functions of these nodes [-].
        weights: [f64; 3],
        /// Weight of the upper level [-].
        upper: f64,
    },
    /// Inside a cell mesh.
    Cells(Weights),
}

impl Probe {
    /// Returns the value of a node field at the point, in the unit of the field.
    pub fn read(&self, field: &[f64]) -> f64 {
        match self {
            Self::Levels { nodes, weights, upper } => {
                let on = |l: usize| -> f64 { (0..3).map(|k| weights[k] * field[nodes[l][k] as usize]).sum() };
                on(0) * (1.0 - upper) + on(1) * upper
            }
            Self::Cells(weights) => weights.iter().map(|&(node, w)| w * field[node as usize]).sum(),
        }
    }
}
