//! How a body of cells changes: its juice moves outwards, it contracts, and its doneness is read.

use saute_heat::CellMesh;
use saute_heat::vector::{Vec3, scale};

use crate::body::solid::Solid;
use crate::change::doneness::{MOST_CLASSES, Scale, Shares};
use crate::model::FoodModel;
use crate::state::FoodState;
use crate::water::juice::Runoff;

impl FoodModel {
    /// Moves free juice outwards. Outer nodes come first, so that no juice moves by two nodes in one step.
    pub(crate) fn drain_cells(&self, state: &mut FoodState, reach: f64, runoff: &mut Runoff) {
        for &(from, to, distance) in &self.water.outwards {
            let share = 1.0 - 1.0 / (1.0 + reach / distance);
            let (nodes, mass) = ([from as usize, to as usize], share * state.juice[from as usize]);
            if mass > 0.0 {
                self.flow(state, nodes, mass, false, runoff);
            }
        }
    }

    /// Contracts the body isotropically to the sum of its nodes' volumes. Where a node has lost more or less than the mean,
    /// its breadth follows the flesh around it and its axial stretch takes up the difference.
    pub(crate) fn shrink_evenly(&self, state: &mut FoodState, relative_volume: impl Fn(&FoodState, usize) -> f64) {
        let volume = self.shape.mesh.volumes();
        let mut left = 0.0;
        for (node, rest) in volume.iter().enumerate() {
            state.stretch.axial[node] = relative_volume(state, node);
            left += rest * state.stretch.axial[node];
        }
        let lateral = libm::cbrt(left / volume.iter().sum::<f64>());
        state.stretch.lateral = lateral;
        state.stretch.axial.iter_mut().for_each(|a| *a /= lateral * lateral);
    }

    /// Present positions: rest positions scaled about the centre [m].
    pub(crate) fn cell_positions(&self, cells: &CellMesh, state: &FoodState, positions: &mut [[f64; 3]]) {
        positions.iter_mut().zip(&cells.positions).for_each(|(p, rest)| *p = scale(*rest, state.stretch.lateral));
    }

    /// Shares of doneness by volume [%], of a field that the scale measures.
    pub(crate) fn cell_volume_shares(&self, field: &[f64], scale: &Scale) -> Shares {
        let mut sums = [0.0; MOST_CLASSES];
        for (value, volume) in field.iter().zip(self.shape.mesh.volumes()) {
            scale.add_stretch(&mut sums, *value, *value, *volume);
        }
        Shares::from_weights(sums)
    }

    /// Shares of doneness of the middle cut by area [%], of a field that the scale measures.
    pub(crate) fn cell_cut_shares(&self, field: &[f64], scale: &Scale) -> Shares {
        let mut sums = [0.0; MOST_CLASSES];
        for &(node, area) in &self.shape.middle_cut {
            let value = field[node as usize];
            scale.add_stretch(&mut sums, value, value, area);
        }
        Shares::from_weights(sums)
    }

    /// The surface in its present shape.
    pub(crate) fn cell_solid(&self, cells: &CellMesh, state: &FoodState) -> Solid {
        let present = |p: &Vec3| scale(*p, state.stretch.lateral);
        Solid::Surface {
            points: cells.surface.vertices.iter().map(present).collect(),
            triangles: cells.surface.triangles.clone(),
        }
    }
}
