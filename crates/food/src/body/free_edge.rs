//! The side of a slice: layers that contract more than the plate draw back from it, the others bulge.

use saute_heat::{Layout, SweptMesh};

use crate::body::shrink::Rest;
use crate::model::FoodModel;
use crate::state::FoodState;

/// Decay of a self-equilibrated stress from the free edge of a strip, in half thicknesses [-]: the real part of the first
/// root of sin 2λ = −2λ, symmetric stress (Horgan and Knowles 1983 `[@horgan-1983]`).
const DECAY: f64 = 2.1061;

/// Places along the side at which the contraction of a level is read [-] (chosen: its mean is read for every picture).
const PLACES: usize = 12;

impl FoodModel {
    /// How far each level of a slice protrudes at its side beyond the mean outline, from the bottom [m]; negative where it
    /// draws back, empty for other bodies.
    ///
    /// Inside a slice all levels contract by the stiffness-weighted mean. Towards the side this constraint decays over
    /// the length h/2λ, so a level with the free contraction c protrudes by (c̄ − c)·h/2λ. It is drawn; heat and contact
    /// see a vertical side.
    pub fn edge_shifts(&self, state: &FoodState) -> Vec<f64> {
        let Layout::Upright(mesh) = self.shape.mesh.layout() else { return Vec::new() };
        if state.stretch.lateral == 1.0 {
            return vec![0.0; mesh.levels.len()];
        }
        let reach = 0.5 * self.thickness(state) / DECAY;
        let mean = -libm::log(state.stretch.lateral);
        let rest = Rest::of(self);
        (0..mesh.levels.len()).map(|level| (mean - self.edge_contraction(mesh, state, &rest, level)) * reach).collect()
    }

    /// Mean free contraction of the nodes along the side of a level, logarithmic [-].
    fn edge_contraction(&self, mesh: &SweptMesh, state: &FoodState, rest: &Rest, level: usize) -> f64 {
        let at = |[i, _]: &[u32; 2]| {
            let node = mesh.node(level, *i as usize);
            self.free_contraction(state, node, rest.relative_volume(self, state, node))
        };
        let boundary = &mesh.section.boundary;
        let step = (boundary.len() / PLACES).max(1);
        let (sum, count) = boundary.iter().step_by(step).map(at).fold((0.0, 0), |(sum, n), c| (sum + c, n + 1));
        sum / f64::from(count)
    }
}
