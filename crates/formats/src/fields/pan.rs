//! The pan as a grid of triangles, with what lies on it.

use saute_kitchen::dynamics::Pose;
use saute_kitchen::{Kitchen, celsius};

use crate::fields::in_kitchen;
use crate::vtk::{Array, CellKind, Cells, Grid};

/// Returns the upper surface of the pan, where a pose puts the centre of its floor: temperatures of metal and glass, and the
/// liquids and solids on it.
pub fn pan(kitchen: &Kitchen, pose: &Pose) -> Grid {
    let (model, state) = (kitchen.pan_model(), kitchen.pan_state());
    let mut cells = Cells::default();
    model.section.triangles.iter().for_each(|t| cells.push(CellKind::Triangle, t.map(|corner| corner as usize)));
    Grid {
        points: in_kitchen(model.liquids.bed.places.iter().copied(), pose),
        cells,
        of_points: temperatures(kitchen).into_iter().chain(contents(kitchen)).collect(),
        of_cells: Vec::new(),
        time_s: kitchen.time_s(),
        notes: vec![
            ("pan", model.description.name.clone()),
            ("lid", if state.lid.is_some() { "on" } else { "off" }.to_owned()),
            ("program", concat!("saute ", env!("CARGO_PKG_VERSION")).to_owned()),
        ],
    }
}

fn temperatures(kitchen: &Kitchen) -> Vec<Array> {
    let state = kitchen.pan_state();
    let in_celsius = |field: &[f64]| field.iter().map(|t| celsius(*t)).collect::<Vec<f64>>();
    // There is no glass under the wall.
    let glass = in_celsius(&state.glass).into_iter().chain(std::iter::repeat(f64::NAN)).take(state.temperature.len());
    vec![
        Array::reals("temperature_c", "°C", in_celsius(&state.temperature)),
        Array::reals("temperature_k", "K", state.temperature.clone()),
        Array::reals("peak_c", "°C", in_celsius(&state.peak)),
        Array::reals("glass_c", "°C", glass.collect()),
    ]
}

fn contents(kitchen: &Kitchen) -> Vec<Array> {
    let (bed, liquids) = (&kitchen.pan_model().liquids.bed, &kitchen.pan_state().liquids);
    let dried = &liquids.fond.dried;
    let per_mass = |amounts: &[f64]| {
        let share = |(amount, mass): (&f64, &f64)| if *mass > 0.0 { amount / mass } else { 0.0 };
        amounts.iter().zip(&dried.mass).map(share).collect::<Vec<f64>>()
    };
    vec![
        Array::reals("area_m2", "m²", bed.areas.clone()),
        Array::reals("oil_kg", "kg", liquids.oil.mass.clone()),
        Array::reals("oil_film_m", "m", liquids.film.clone()),
        Array::reals("water_kg", "kg", liquids.water.mass.clone()),
        Array::reals("fond_kg_m2", "kg/m²", dried.mass.clone()),
        Array::reals("fond_browning", "", per_mass(&dried.browned)),
        Array::reals("fond_charring", "", per_mass(&dried.charred)),
    ]
}
