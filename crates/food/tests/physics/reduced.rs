//! Promise: a slice carried over to its coarse mesh keeps its heat, water, juice and fat, and stays the same food.

use saute_food::{FoodModel, Reduction, ZERO_C};

use crate::run::{Run, UP, kitchen_air, model};

/// Slices of every form, natural and plain.
fn slices() -> Vec<(&'static str, FoodModel)> {
    vec![
        ("beef-lean", model("beef-lean", 1.0, [0.12, 0.08, 0.025])),
        ("beef-marbled", model("beef-marbled", 1.6, [0.11, 0.07, 0.035])),
        ("beef-patty", model("beef-patty", 1.0, [0.1, 0.1, 0.02])),
        ("carrot-coin", model("carrot-coin", 1.0, [0.03, 0.03, 0.01])),
        ("leek-ring", model("leek-ring", 1.0, [0.03, 0.03, 0.015])),
    ]
}

fn close(a: f64, b: f64, relative: f64, what: &str) {
    assert!((a - b).abs() <= relative * b.abs().max(1e-12), "{what}: {a} instead of {b}");
}

#[test]
fn heat_water_juice_and_fat_are_kept() {
    for (kind, fine) in slices() {
        let mut run = Run::new(&fine, 5.0);
        run.fry(90.0, 200.0, 400.0, kitchen_air());
        let reduction = Reduction::of(&fine).expect("builds").expect("a slice");
        let (coarse, state) = (reduction.model(), reduction.restricted(&fine, &run.state));
        assert!(state.fits(coarse) && coarse.mesh().node_count() < fine.mesh().node_count(), "{kind}");
        close(state.total_enthalpy(), run.state.total_enthalpy(), 1e-12, kind);
        close(state.mass(coarse), run.state.mass(&fine), 1e-12, kind);
        for (to, from) in
            [(&state.water, &run.state.water), (&state.juice, &run.state.juice), (&state.fat, &run.state.fat)]
        {
            close(to.iter().sum(), from.iter().sum(), 1e-12, kind);
        }
        close(coarse.mesh().volumes().iter().sum(), fine.mesh().volumes().iter().sum(), 1e-9, kind);
        close(coarse.raw_mass(), fine.raw_mass(), 1e-12, kind);
    }
}

/// What one reads of it differs by what a mean over a coarse column blurs.
#[test]
fn core_and_faces_are_those_of_the_full_mesh() {
    for (kind, fine) in slices() {
        let mut run = Run::new(&fine, 5.0);
        run.fry(90.0, 200.0, 400.0, kitchen_air());
        let reduction = Reduction::of(&fine).expect("builds").expect("a slice");
        let (coarse, state) = (reduction.model(), reduction.restricted(&fine, &run.state));
        let cores = [fine.core_temperature(&run.state), coarse.core_temperature(&state)];
        assert!((cores[0] - cores[1]).abs() < 1.5, "{kind}: {cores:?}");
        for up in [UP, UP.map(|v| -v)] {
            let faces = [fine.face_reading(&run.state, up), coarse.face_reading(&state, up)];
            assert!((faces[0].temperature - faces[1].temperature).abs() < 4.0, "{kind}: {faces:?}");
            assert!((faces[0].browning - faces[1].browning).abs() < 0.02, "{kind}: {faces:?}");
        }
        assert!(state.temperature.iter().all(|t| (ZERO_C..ZERO_C + 200.0).contains(t)), "{kind}");
    }
}

/// Each node contains the food of its own volume, so that heat spreads through it as through the food.
#[test]
fn every_coarse_node_is_as_dense_as_the_food() {
    let fine = model("beef-lean", 1.0, [0.12, 0.08, 0.025]);
    let reduction = Reduction::of(&fine).expect("builds").expect("a slice");
    let coarse = reduction.model();
    let mean = fine.raw_mass() / fine.mesh().volumes().iter().sum::<f64>();
    for (node, volume) in coarse.mesh().volumes().iter().enumerate() {
        let mass = coarse.initial_water()[node] + coarse.lean_solids()[node] + coarse.initial_fat()[node];
        close(mass / volume, mean, 0.01, &format!("node {node}"));
    }
}

#[test]
fn a_body_that_is_no_slice_keeps_its_mesh_and_a_cut_slice_stays_cut() {
    assert!(Reduction::of(&model("shrimp", 1.0, [0.08, 0.02, 0.015])).expect("builds").is_none());
    let halves = model("beef-lean", 1.0, [0.12, 0.08, 0.025]).halved(0.01).expect("is cut");
    let reduction = Reduction::of(&halves).expect("builds").expect("a slice");
    assert!(!reduction.model().fresh_faces().is_empty());
}
