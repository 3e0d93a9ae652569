//! Forecast of the carry-over: the core's peak temperature if a piece is taken out now.

use saute_food::FoodModel;
use saute_food::FoodState;
use saute_heat::Layout;

use crate::data::room::Room;

/// Heat loss of a resting face: convection, radiation and some evaporation [W/(m²·K)] (chosen: mean of board and air).
const REST_LOSS: f64 = 28.0;
/// Horizon of the forecast [s] (chosen: the core of a 60 mm piece peaks within half an hour).
const HORIZON_S: f64 = 1800.0;

/// Expected peak of the core temperature [K] if the piece rests from now on, and the time until then [s].
///
/// One-dimensional conduction through the thickness with Robin boundaries, starting from the mean profile of the inner
/// half of the section. Losses through the edges are neglected, which biases the peak high. The error against the full
/// model is below 3 K.
///
/// The explicit step is written out here and not taken from [`saute_heat::conduction`]: its operators multiply by
/// precomputed conductances, which would round differently and change the forecast that people read and files hold.
pub fn foreseen_peak(model: &FoodModel, state: &FoodState, room: &Room) -> (f64, f64) {
    let (levels, mut profile) = mean_profile(model, state);
    let heights = heights(&levels);
    let middle = levels.len() / 2;
    let masses = masses_per_volume(model, state);
    let conductivity = model.properties().conductivity(&masses, profile[middle]);
    let capacity = model.properties().enthalpy(&masses, profile[middle]).1;
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

/// Points on the line through the core of a body on a cell mesh [-] (chosen: a millimetre apart).
const ACROSS: usize = 15;

/// Heights on the line through the core [m] and temperatures there, capped at boiling [K]. For a swept mesh each
/// temperature is the area mean of a level over the inner half of the section.
fn mean_profile(model: &FoodModel, state: &FoodState) -> (Vec<f64>, Vec<f64>) {
    let boiling = crate::kelvin(100.0);
    let Layout::Upright(mesh) = model.mesh().layout() else {
        let share = |i: usize| 2.0 * i as f64 / (ACROSS - 1) as f64 - 1.0;
        let height = |i: usize| 0.5 * (1.0 + share(i)) * model.size()[2];
        let across = (0..ACROSS).map(|i| model.above_core(&state.temperature, share(i)).min(boiling));
        return ((0..ACROSS).map(height).collect(), across.collect());
    };
    let (n, [length, width, _]) = (mesh.nodes_per_level(), model.size());
    let reach = 0.25 * (length * length + width * width) * 0.25;
    let inner: Vec<usize> = (0..n)
        .filter(|&i| {
            let [x, y] = mesh.section.points[i];
            x * x + y * y < reach
        })
        .collect();
    let area: f64 = inner.iter().map(|&i| mesh.section.areas[i]).sum();
    let mut profile: Vec<f64> = (0..mesh.levels.len())
        .map(|level| {
            inner.iter().map(|&i| state.temperature[level * n + i] * mesh.section.areas[i]).sum::<f64>() / area
        })
        .map(|t: f64| t.min(boiling))
        .collect();
    profile[mesh.levels.len() / 2] = model.core_temperature(state);
    (mesh.levels.clone(), profile)
}

/// Height of the control volume of each point on a line [m].
fn heights(levels: &[f64]) -> Vec<f64> {
    let last = levels.len() - 1;
    (0..=last).map(|i| 0.5 * (levels[(i + 1).min(last)] - levels[i.saturating_sub(1)])).collect()
}

fn masses_per_volume(model: &FoodModel, state: &FoodState) -> [f64; 3] {
    let volume: f64 = model.mesh().volumes().iter().sum();
    [state.water.as_slice(), model.lean_solids(), &state.fat].map(|m| m.iter().sum::<f64>() / volume)
}
