//! The fond that is seen at a place of the pan.

use saute_heat::Located;

use crate::liquids::fond::FondReading;
use crate::pan::pan_model::PanState;

impl PanState {
    /// Fond at a place on the pan's mesh.
    pub fn fond(&self, at: &Located) -> FondReading {
        let fond = &self.liquids.fond;
        let mean = |field: &[f64]| (0..3).map(|k| at.weights[k] * field[at.nodes[k] as usize]).sum::<f64>();
        let mass = mean(&fond.dried.mass);
        let extent = |field: &[f64]| if mass > 0.0 { mean(field) / mass } else { 0.0 };
        FondReading {
            mass_kg_m2: mass,
            browning: extent(&fond.dried.browned),
            charring: extent(&fond.dried.charred),
            share: mean(&fond.share),
        }
    }
}
