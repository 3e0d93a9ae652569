//! Forecast of the carry-over: the core's peak temperature if a piece is taken out now.

use saute_food::FoodModel;
use saute_food::FoodState;
use saute_heat::conduction::axis::{Axis, End};
use saute_heat::conduction::product::{Constants, ProductOperator};
use saute_heat::conduction::super_step::SuperStep;
use saute_heat::conduction::tensor::TensorBody;
use saute_heat::{Boundary, Layout};

use crate::data::room::Room;

/// Heat loss of a resting face: convection, radiation and some evaporation [W/(m²·K)] (chosen: mean of board and air).
const REST_LOSS: f64 = 28.0;
/// Horizon of the forecast [s] (chosen: the core of a 60 mm piece peaks within half an hour).
const HORIZON_S: f64 = 1800.0;
/// Time for which the core may fall at first, and what it falls below its peak when the forecast ends [s, K] (chosen: heat from the faces
/// needs half a minute to come to the core).
const SETTLES_S: f64 = 30.0;
const FALLEN_K: f64 = 0.3;
/// Time step, of the longest stable one [-] (chosen: about that of the step before, 0.35 Δx²·c/λ).
const OF_STABLE: f64 = 0.7;

/// Expected peak of the core temperature [K] if the piece rests from now on, and the time until then [s].
///
/// One-dimensional conduction through the thickness with Robin boundaries, starting from the mean profile of the inner
/// half of the section. Losses through the edges are neglected, which biases the peak high. The error against the full
/// model is below 3 K.
pub fn foreseen_peak(model: &FoodModel, state: &FoodState, room: &Room) -> (f64, f64) {
    let (levels, mut profile) = mean_profile(model, state);
    let middle = levels.len() / 2;
    let operator = resting_column(model, state, room, levels, profile[middle]);
    let dt = OF_STABLE * operator.stable_step();
    let mut step = SuperStep::new(profile.len());
    let (mut best, mut when, mut time) = (profile[middle], 0.0, 0.0);
    while time < HORIZON_S && (time < SETTLES_S || profile[middle] > best - FALLEN_K) {
        step.euler(&mut profile, dt, &operator);
        time += dt;
        if profile[middle] > best {
            (best, when) = (profile[middle], time);
        }
    }
    (best, when)
}

/// Conduction along the line through the core, whose ends lose heat to the room, with the properties of the whole at a temperature [K].
fn resting_column(
    model: &FoodModel,
    state: &FoodState,
    room: &Room,
    levels: Vec<f64>,
    temperature: f64,
) -> ProductOperator {
    let masses = masses_per_volume(model, state);
    let conductivity = model.properties().conductivity(&masses, temperature);
    let capacity = model.properties().enthalpy(&masses, temperature).1;
    let rests = Boundary::convective(REST_LOSS, room.temperature());
    let column = TensorBody::new(vec![Axis::straight(levels)]);
    let faces = [(0, End::Low, rests), (0, End::High, rests)];
    ProductOperator::new(&column, &[Constants { conductivity, capacity }], &faces)
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
    let height = inner.iter().map(|&i| mesh.path.column(i) * mesh.section.areas[i]).sum::<f64>() / area;
    (mesh.levels.iter().map(|level| level * height).collect(), profile)
}

fn masses_per_volume(model: &FoodModel, state: &FoodState) -> [f64; 3] {
    let volume: f64 = model.mesh().volumes().iter().sum();
    [state.water.as_slice(), model.lean_solids(), &state.fat].map(|m| m.iter().sum::<f64>() / volume)
}
