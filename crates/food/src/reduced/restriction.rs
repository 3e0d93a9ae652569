//! The state of a slice on its coarse mesh.

use crate::model::FoodModel;
use crate::reduced::Reduction;
use crate::state::{FoodState, Stretch};

impl Reduction {
    /// Returns a state of the full mesh on the coarse one: heat, water, juice and fat are conserved; what has happened to
    /// the flesh (changes, browning, lethality) is the mean by volume. Its ticks begin at 0.
    pub fn restricted(&self, fine: &FoodModel, state: &FoodState) -> FoodState {
        let columns = &self.columns;
        let volumes = fine.mesh().volumes();
        let mean = |field: &Vec<f64>| columns.means(field, volumes);
        let mut coarse = FoodState {
            temperature: mean(&state.temperature),
            enthalpy: columns.sums(&state.enthalpy),
            water: columns.sums(&state.water),
            juice: columns.sums(&state.juice),
            rising: columns.sums(&state.rising),
            fat: columns.sums(&state.fat),
            peak: mean(&state.peak),
            changed: state.changed.iter().map(mean).collect(),
            browning: mean(&state.browning),
            charring: mean(&state.charring),
            lethality: mean(&state.lethality),
            oiled: mean(&state.oiled),
            open: mean(&state.open),
            stretch: Stretch { axial: mean(&state.stretch.axial), ..state.stretch },
            evaporated: state.evaporated,
            dripped: state.dripped,
            rendered: state.rendered,
            ticks: 0,
            healthy: state.healthy,
        };
        let model = self.model();
        for node in 0..coarse.temperature.len() {
            let masses = model.masses(&coarse, node);
            coarse.temperature[node] =
                model.properties().temperature(&masses, coarse.enthalpy[node], coarse.temperature[node]).0;
        }
        coarse
    }
}
