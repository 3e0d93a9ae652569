//! Promise: a piece of food keeps its energy and water in balance, obeys the maximum principle and stays wet at 100 °C.

use saute_food::{FreeAir, ZERO_C};

use crate::run::{DT, Run, UP, kitchen_air, lean};

#[test]
fn energy_and_water_balance_while_searing_and_flipping() {
    let mut run = Run::new(lean(), 5.0);
    let (heat_before, water_before) = (run.state.total_enthalpy(), run.state.water.iter().sum::<f64>());
    for _ in 0..4 {
        run.fry(60.0, 220.0, 500.0, kitchen_air());
        run.flip();
    }
    let p = &run.passed;
    let stored = run.state.total_enthalpy() - heat_before;
    let gross = p.contact + p.air.abs() + p.evaporation;
    let residual = p.contact - p.air - p.evaporation - p.runoff_enthalpy - stored;
    assert!(residual.abs() < 1e-3 * gross, "{residual} J of {gross} J");
    let water = run.state.water.iter().sum::<f64>() + p.evaporated + p.drip;
    assert!((water - water_before).abs() < 1e-3 * water_before);
    assert!((run.state.evaporated - p.evaporated).abs() < 1e-12 && (run.state.dripped - p.drip).abs() < 1e-12);
    assert!(run.state.water.iter().all(|&w| w >= 0.0));
}

/// With evaporation the wet-bulb temperature is the lower bound: about 16 °C at 23 °C and 50 % humidity.
#[test]
fn no_node_leaves_the_range_of_its_surroundings() {
    let mut run = Run::new(lean(), 20.0);
    for _ in 0..30 {
        run.fry(10.0, 240.0, 800.0, kitchen_air());
        let (low, high) = run.state.range();
        assert!(low > ZERO_C + 14.0 && high < ZERO_C + 240.0, "{low} {high}");
    }
}

#[test]
fn without_evaporation_no_node_leaves_its_neighbours_range() {
    let still = FreeAir { mass_transfer: 0.0, ..kitchen_air() };
    let mut run = Run::new(lean(), 5.0);
    run.fry(60.0, 95.0, 2000.0, still);
    let (low, high) = run.state.range();
    assert!(low >= ZERO_C + 5.0 - 1e-6 && high <= ZERO_C + 95.0 + 1e-6, "{low} {high}");
}

/// Cernela et al. 2015: a wet surface never exceeds 100 °C on a plate at 160–260 °C.
#[test]
fn a_wet_surface_stays_at_100_whatever_the_plate() {
    for plate in [160.0, 200.0, 260.0] {
        let mut run = Run::new(lean(), 20.0);
        for _ in 0..8 {
            run.fry(1.0, plate, 500.0, kitchen_air());
            let wet = |i: &usize| run.state.water[*i] > 0.5 * run.model.initial_water()[*i];
            let hottest = run
                .model
                .patches_below(UP)
                .map(|p| run.model.patches()[p].node as usize)
                .filter(wet)
                .map(|i| run.state.celsius(i))
                .fold(0.0, f64::max);
            assert!(hottest <= 101.0, "{plate} °C plate: {hottest}");
        }
    }
}

/// 25 mm from 5 °C on a 180 °C plate, one flip at 240 s, falling conductance: about 620 s to a 50 °C core
/// (one-dimensional reference computation without juice and air losses); here with both, and with edges.
#[test]
fn the_centre_of_a_flipped_steak_takes_as_long_as_the_reference_computation_says() {
    let mut run = Run::new(lean(), 5.0);
    run.fry(240.0, 180.0, 340.0, kitchen_air());
    run.flip();
    let mut t = 240.0;
    while run.core() < 50.0 && t < 1200.0 {
        run.fry(1.0, 180.0, 340.0, kitchen_air());
        t += 1.0;
    }
    assert!((550.0..720.0).contains(&t), "{t} s");
}

/// This is true for the best contact too: the surface has no separate time step.
#[test]
fn halving_the_tick_changes_nothing_that_matters() {
    let cook = |dt: f64| {
        let mut run = Run { dt, ..Run::new(lean(), 5.0) };
        run.fry(150.0, 230.0, 1800.0, kitchen_air());
        run.flip();
        run.fry(150.0, 230.0, 1800.0, kitchen_air());
        let face = run.model.face_temperature(&run.state, run.up);
        (run.core(), 1e3 * run.state.mass(run.model), face)
    };
    let (coarse, fine) = (cook(DT), cook(0.5 * DT));
    assert!((coarse.0 - fine.0).abs() < 0.05, "core {coarse:?} {fine:?}");
    assert!((coarse.1 - fine.1).abs() < 0.1, "mass {coarse:?} {fine:?}");
    assert!((coarse.2 - fine.2).abs() < 1.0, "surface {coarse:?} {fine:?}");
}

#[test]
fn a_non_finite_piece_returns_to_its_state_before_the_tick_and_is_frozen() {
    let mut run = Run::new(lean(), 20.0);
    // Two ticks after a refresh: a state of the refresh would be older than the last tick.
    run.fry(10.2, 180.0, 400.0, kitchen_air());
    let before = run.state.clone();
    run.state.enthalpy[7] = f64::NAN;
    run.fry(2.0, 180.0, 400.0, kitchen_air());
    assert!(!run.state.healthy);
    assert!(run.state == saute_food::FoodState { healthy: false, ..before });
}

#[test]
fn the_same_run_gives_the_same_bits() {
    let cook = || {
        let mut run = Run::new(lean(), 5.0);
        run.fry(90.0, 220.0, 500.0, kitchen_air());
        run.state
    };
    assert!(cook() == cook());
}
