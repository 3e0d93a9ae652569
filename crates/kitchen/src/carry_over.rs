//! A rough forecast of the core's peak if a piece were taken out now.

use saute_food::FoodModel;
use saute_food::FoodState;

use crate::room::Room;

/// Heat loss of a resting face: convection, radiation and some evaporation [W/(m²·K)] (chosen: mean of board and air).
const REST_LOSS: f64 = 28.0;
/// How far ahead the forecast looks [s] (chosen: the peak of a 60 mm piece comes within half an hour).
const HORIZON_S: f64 = 1800.0;

/// Expected highest core temperature if the piece rested from now on [K], and in how many seconds.
///
/// One-dimensional conduction through the thickness from the mean profile of the inner half of the section; the
/// edges are neglected, which makes it a little high. Tested against the full model within 3 K.
pub fn foreseen_peak(model: &FoodModel, state: &FoodState, room: &Room) -> (f64, f64) {
    let mut profile = mean_profile(model, state);
    let levels = &model.mesh.levels;
    let heights = model.mesh.layer_heights();
    let middle = levels.len() / 2;
    let masses = masses_per_volume(model, state);
    let conductivity = model.properties.conductivity(&masses, profile[middle]);
    let capacity = model.properties.enthalpy(&masses, profile[middle]).1;
    let dt = 0.35 * (levels[1] - levels[0]) * (levels[1] - levels[0]) * capacity / conductivity;
    let (mut best, mut when, mut time) = (profile[middle], 0.0, 0.0);
    let mut flux = vec![0.0; levels.len() + 1];
    while time < HORIZON_S && (time < 30.0 || profile[middle] > best - 0.3) {
        let last = levels.len() - 1;
        flux[0] = REST_LOSS * (room.temperature() - profile[0]);
        flux[last + 1] = REST_LOSS * (profile[last] - room.temperature());
        for i in 1..=last {
            flux[i] = conductivity * (profile[i - 1] - profile[i]) / (levels[i] - levels[i - 1]);
        }
        for (i, t) in profile.iter_mut().enumerate() {
            *t += dt * (flux[i] - flux[i + 1]) / (capacity * heights[i]);
        }
        time += dt;
        if profile[middle] > best {
            (best, when) = (profile[middle], time);
        }
    }
    (best, when)
}

/// Area-mean temperature of each level over the inner half of the section, capped at boiling [K].
fn mean_profile(model: &FoodModel, state: &FoodState) -> Vec<f64> {
    let n = model.mesh.nodes_per_level();
    let reach = 0.25 * (model.size[0] * model.size[0] + model.size[1] * model.size[1]) * 0.25;
    let inner: Vec<usize> = (0..n)
        .filter(|&i| {
            let [x, y] = model.mesh.section.points[i];
            x * x + y * y < reach
        })
        .collect();
    let area: f64 = inner.iter().map(|&i| model.mesh.section.areas[i]).sum();
    let mut profile: Vec<f64> = (0..model.mesh.levels.len())
        .map(|level| {
            inner.iter().map(|&i| state.temperature[level * n + i] * model.mesh.section.areas[i]).sum::<f64>() / area
        })
        .map(|t: f64| t.min(crate::kelvin(100.0)))
        .collect();
    profile[model.mesh.levels.len() / 2] = model.core_temperature(state);
    profile
}

fn masses_per_volume(model: &FoodModel, state: &FoodState) -> [f64; 3] {
    let volume: f64 = model.mesh.graph.volume.iter().sum();
    [&state.water, &model.lean_solids, &state.fat].map(|m| m.iter().sum::<f64>() / volume)
}
