//! The film of juice that lies on the faces of raw food.

use saute_heat::Layout;

use crate::model::FoodModel;
use crate::paper_2013::Rules;
use crate::state::FoodState;

/// Film on a raw face, relative to the largest that stays on it [-] (chosen: 40 g/m² on meat, moist without beads; filter papers take 21 to
/// 133 g/m² off pork, Torres Filho 2017 [@torres-filho-2017]).
const RAW_FILM: f64 = 0.8;

impl FoodState {
    /// Lays a film of free juice on the faces of raw food, with water from the whole piece: its mass stays.
    ///
    /// A piece by the rules of 2013 has none.
    pub(crate) fn wet_faces(&mut self, model: &FoodModel) {
        if model.rules == Rules::Paper2013 {
            return;
        }
        let largest = model.kinetics.water_holding.film_kg_m2;
        let water: f64 = self.water.iter().sum();
        let films = || model.water.outlets.iter().map(|&(node, area)| (node as usize, RAW_FILM * largest * area));
        let flesh = 1.0 - films().map(|(_, film)| film).sum::<f64>() / water;
        self.water.iter_mut().for_each(|water| *water *= flesh);
        for (node, film) in films() {
            self.water[node] += film;
            self.juice[node] += film;
            self.rising[node] += model.rising_film(node) * film;
        }
    }
}

impl FoodModel {
    /// Share of the film on a node's face that counts as rising juice [-]: it stays on the face that it is on.
    fn rising_film(&self, node: usize) -> f64 {
        match self.shape.mesh.layout() {
            Layout::Upright(mesh) if node >= mesh.nodes_per_level() => 1.0,
            Layout::Upright(_) => 0.0,
            // On a skin that runs along the fibres as much flows one way as the other.
            _ => 0.5,
        }
    }
}
