//! The film of juice that lies on the faces of raw food.

use saute_heat::Layout;

use crate::ZERO_C;
use crate::model::FoodModel;
use crate::paper_2013::Rules;

/// Film on a raw face, relative to the largest that stays on it [-] (chosen: 36 g/m² on meat, moist without beads; filter papers take 21 to
/// 133 g/m² off pork, Torres Filho 2017 `[@torres-filho-2017]`).
const RAW_FILM: f64 = 0.72;

/// Film on a skin all round, over that on level faces [-] (chosen: from its sides it runs down).
const ON_A_SKIN: f64 = 0.5;
/// Peak temperatures between which a face stops being raw [K] (chosen: flesh clouds from 47 °C on and has set at 65 °C).
const SETS: [f64; 2] = [ZERO_C + 47.0, ZERO_C + 65.0];

impl FoodModel {
    /// Adds the film of juice on the faces to the raw piece, beside the water of its flesh: 36 g/m². A piece by the rules of 2013 has none.
    pub(crate) fn wet_faces(&mut self) {
        let mut film = vec![0.0; self.shape.mesh.node_count()];
        if self.rules == Rules::Full {
            let (most, share) = (self.kinetics.water_holding.film_kg_m2, self.raw_film_left(0.0));
            self.water.outlets.iter().for_each(|&(node, area)| film[node as usize] = share * most * area);
        }
        self.tissue.raw_mass += film.iter().sum::<f64>();
        self.tissue.raw_film = film;
    }

    /// Film that belongs to a face of raw food, relative to the largest, by its peak temperature [K] [-]: none to one that has set, and to
    /// what is poured, which is liquid all through.
    pub(crate) fn raw_film_left(&self, peak: f64) -> f64 {
        let set = ((peak - SETS[0]) / (SETS[1] - SETS[0])).clamp(0.0, 1.0);
        let level = if let Layout::Upright(_) = self.shape.mesh.layout() { 1.0 } else { ON_A_SKIN };
        let has_film = self.rules == Rules::Full && self.shape.pool.is_none();
        if has_film { level * RAW_FILM * (1.0 - set) } else { 0.0 }
    }

    /// Share of the film on a node's face that counts as rising juice [-]: it stays on the face that it is on.
    pub(crate) fn rising_film(&self, node: usize) -> f64 {
        match self.shape.mesh.layout() {
            Layout::Upright(mesh) if node >= mesh.nodes_per_level() => 1.0,
            Layout::Upright(_) => 0.0,
            // On a skin that runs along the fibres as much flows one way as the other.
            _ => 0.5,
        }
    }
}
