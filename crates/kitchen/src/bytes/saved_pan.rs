//! Checks that the state of a pan that was stored is one of its model.

use crate::liquids::Liquids;
use crate::pan::food_load::FoodLoad;
use crate::pan::pan_model::{PanModel, PanState};

/// Returns true if a state of a pan has a value for each node of its model.
pub(super) fn fits(state: &PanState, load: &FoodLoad, model: &PanModel) -> bool {
    let (all, floor) = (model.section.points.len(), model.floor_nodes);
    let of_floor = [&state.glass, &state.ring_shares];
    let of_all = [&state.temperature, &state.peak, &load.heat, &load.covered, &load.steam];
    of_floor.iter().all(|field| field.len() == floor)
        && of_all.iter().all(|field| field.len() == all)
        && liquids_fit(&state.liquids, all, model.liquids.oils.len())
}

fn liquids_fit(liquids: &Liquids, nodes: usize, oils: usize) -> bool {
    let Liquids { oil, water, fond, butter, film, .. } = liquids;
    let [dried, dissolved] = [&fond.dried, &fond.dissolved];
    let fields = [&oil.mass, &oil.capacity, &water.mass, &water.enthalpy, film, &fond.share];
    let solids = [dried, dissolved].into_iter().flat_map(|s| [&s.mass, &s.browned, &s.charred]);
    let fats = oil.fats.iter().all(|fat| fat.kind < oils && fat.mass.len() == nodes);
    let lump = butter.lump.iter().flat_map(|lump| &lump.footprint).all(|(node, _)| *node < nodes);
    fats && lump && fields.into_iter().chain(solids).all(|field| field.len() == nodes)
}
