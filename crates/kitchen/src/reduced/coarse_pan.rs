//! The pan on a coarse mesh, with its state.

use std::sync::Arc;

use saute_heat::{Coarsening, MeshError};

use crate::kitchen::Fixed;
use crate::liquids::Liquids;
use crate::liquids::fond::Solids;
use crate::pan::pan_model::{PanModel, PanState};

/// The fixed part of a kitchen with a coarse pan, and the way of states to it.
#[derive(Clone, Debug)]
pub(super) struct CoarsePan {
    /// The kitchen's own, by which it is known.
    fine: Arc<Fixed>,
    pub(super) fixed: Arc<Fixed>,
    nodes: Coarsening,
}

impl CoarsePan {
    pub(super) fn of(fine: &Arc<Fixed>) -> Result<Self, MeshError> {
        let pan = fine.pan.coarser(&fine.hob)?;
        let of = |pan: &PanModel| (pan.section.points.clone(), pan.section.areas.clone());
        let (points, areas) = of(&fine.pan);
        // What lies on the floor stays there.
        let meets = |i: usize, node: usize| (i < fine.pan.floor_nodes) == (node < pan.floor_nodes);
        let nodes = Coarsening::between((&points, &areas), (&pan.section, &pan.section.areas), meets);
        let fixed = Arc::new(Fixed { pan, ..fine.as_ref().clone() });
        Ok(Self { fine: Arc::clone(fine), fixed, nodes })
    }

    /// Returns true if it is that of a kitchen with this fixed part.
    pub(super) fn is_of(&self, fine: &Arc<Fixed>) -> bool {
        Arc::ptr_eq(&self.fine, fine)
    }

    /// Returns a state of the pan on the coarse mesh: heat, oil and water are conserved.
    pub(super) fn restricted(&self, state: &PanState) -> PanState {
        let (fine, floor) = (&self.fine.pan, self.fixed.pan.floor_nodes);
        let with_oil = fine.capacity.iter().zip(&state.liquids.oil.capacity).map(|(metal, oil)| metal + oil);
        let capacity: Vec<f64> = with_oil.collect();
        // Floor nodes come first, and only they meet those of the coarse floor.
        let on_floor = |field: &[f64], weights: Option<&[f64]>| {
            let mut whole = field.to_vec();
            whole.resize(fine.section.points.len(), 0.0);
            let mut found = weights.map_or_else(|| self.nodes.sums(&whole), |w| self.nodes.means(&whole, w));
            found.truncate(floor);
            found
        };
        PanState {
            temperature: self.nodes.means(&state.temperature, &capacity),
            peak: self.nodes.means(&state.peak, &capacity),
            glass: on_floor(&state.glass, Some(&fine.section.areas)),
            ring_shares: on_floor(&state.ring_shares, None),
            liquids: self.liquids(&state.liquids),
            ..state.clone()
        }
    }

    fn liquids(&self, liquids: &Liquids) -> Liquids {
        let sums = |field: &mut Vec<f64>| *field = self.nodes.sums(field);
        let areas = &self.fine.pan.liquids.bed.areas;
        let mut coarse = liquids.clone();
        let Liquids { oil, water, fond, film, butter, .. } = &mut coarse;
        oil.fats.iter_mut().for_each(|fat| sums(&mut fat.mass));
        [&mut oil.mass, &mut oil.capacity, &mut water.mass, &mut water.enthalpy].into_iter().for_each(sums);
        let Solids { mass, browned, charred } = &mut fond.dissolved;
        [mass, browned, charred].into_iter().for_each(sums);
        let means = |field: &mut Vec<f64>| *field = self.nodes.means(field, areas);
        let Solids { mass, browned, charred } = &mut fond.dried;
        [mass, browned, charred, &mut fond.share, film].into_iter().for_each(means);
        if let Some(lump) = &mut butter.lump {
            let mut below = vec![0.0; areas.len()];
            lump.footprint.iter().for_each(|(node, area)| below[*node] += area);
            let below = self.nodes.sums(&below).into_iter().enumerate();
            lump.footprint = below.filter(|(_, area)| *area > 0.0).collect();
        }
        coarse
    }
}
