//! Promise: a piece shrinks by the volume that it loses, in the directions of free muscle; it bends against gravity.

use saute_food::{FoodModel, FoodState, ZERO_C};

use crate::run::{FLIPPED, Run, UP, kitchen_air, lean, model, swept_mesh};

/// A raw piece without the film of juice on its faces, which is outside the flesh.
fn dabbed(model: &FoodModel, celsius: f64) -> FoodState {
    let mut state = FoodState::raw(model, ZERO_C + celsius);
    state.water.copy_from_slice(model.initial_water());
    state
}

/// A uniformly cooked piece with the given shares of myosin, collagen, actin and myoglobin changed and of the raw water left.
fn uniform(changed: [f64; 4], water: f64) -> (f64, f64, f64) {
    let steak = lean();
    let mut state = dabbed(steak, 60.0);
    for (name, share) in ["myosin", "collagen", "actin", "myoglobin"].iter().zip(changed) {
        let place = steak.kinetics().names().into_iter().position(|own| own == *name).expect("change");
        state.changed[place].fill(share);
    }
    state.water.iter_mut().for_each(|w| *w *= water);
    steak.shrink(&mut state);
    (state.stretch.lateral, steak.thickness(&state) / swept_mesh(steak).thickness(), steak.relative_volume(&state))
}

#[test]
fn the_raw_piece_keeps_its_shape() {
    let (across, along, volume) = uniform([0.0; 4], 1.0);
    assert!((across - 1.0).abs() < 1e-12 && (along - 1.0).abs() < 1e-12 && (volume - 1.0).abs() < 1e-12);
}

/// Free beef muscle (Food Res. Int. 2016, 89:739): cross-section −20 to −24 % at 50–65 °C (myosin, collagen), length
/// along the fibres −25 % when fully cooked; a steak's fibres run through its thickness.
#[test]
fn fully_cooked_muscle_contracts_to_the_measured_maxima_and_no_further() {
    // The water that the largest contractions leave room for: 0.78 · 0.75 = 0.585 of the volume.
    let (across, along, volume) = uniform([1.0, 1.0, 1.0, 1.0], 0.40);
    assert!((0.76..=0.80).contains(&(across * across)), "cross-section {}", across * across);
    assert!((along - 0.75).abs() < 0.01, "thickness {along}");
    let (dry_across, dry_along, dry) = uniform([1.0, 1.0, 1.0, 1.0], 0.05);
    assert!((dry - volume).abs() < 1e-9 && (dry_across - across).abs() < 1e-9 && (dry_along - along).abs() < 1e-9);
}

/// At 50–65 °C the cross-section contracts, the fibres do not.
#[test]
fn myosin_and_collagen_contract_the_cross_section_alone() {
    let (across, along, volume) = uniform([1.0, 1.0, 0.0, 0.2], 0.80);
    assert!(across < 0.93 && (along - 1.0).abs() < 1e-9 && (across * across * along / volume - 1.0).abs() < 1e-9);
}

/// The lost volume equals the lost water and fat, node by node, as long as nothing dries out.
#[test]
fn the_volume_lost_is_that_of_water_and_fat() {
    let mut run = Run::new(lean(), 5.0);
    for _ in 0..6 {
        run.fry(60.0, 150.0, 300.0, kitchen_air());
        run.flip();
    }
    let (model, state) = (run.model, &run.state);
    let volume: f64 = model.mesh().volumes().iter().sum();
    // The film of juice on a face is outside the flesh.
    let lost_water = model.initial_water().iter().zip(&state.water).map(|(raw, now)| (raw - now).max(0.0));
    let water = lost_water.sum::<f64>() / 998.0;
    let fat = state.rendered / 917.0;
    let lost = (1.0 - model.relative_volume(state)) * volume;
    // A dried crust keeps pores: a little less than all of the lost volume.
    assert!(lost < 1.01 * (water + fat) && lost > 0.85 * (water + fat), "{lost} of {}", water + fat);
    let thinner =
        model.thickness(state) * state.stretch.lateral * state.stretch.lateral / swept_mesh(model).thickness();
    assert!((thinner / model.relative_volume(state) - 1.0).abs() < 0.02, "{thinner}");
}

/// The heated face contracts first: the middle of a small, stiff piece rises off the pan, and a flip shows the same bend
/// from the other side. The weight of a large slice holds it flat.
#[test]
fn a_small_piece_domes_and_a_large_one_lies_flat() {
    let small = model("beef-lean", 1.6, [0.045, 0.045, 0.02]);
    let bend = |piece| {
        let mut run = Run::new(piece, 5.0);
        run.fry(150.0, 160.0, 400.0, kitchen_air());
        (run.state.stretch.dome, run.model.dome_gap(&run.state, [0.0, 0.0], UP), run.state)
    };
    let (dome, gap, state) = bend(&small);
    assert!(dome > 0.05e-3 && (gap - dome).abs() < 1e-12, "{dome}");
    assert!(small.dome_gap(&state, [0.0, 0.0], FLIPPED) == 0.0 && small.dome_gap(&state, [0.02, 0.0], FLIPPED) > 0.0);
    let large = model("beef-lean", 1.6, [0.16, 0.12, 0.02]);
    assert_eq!(bend(&large).0, 0.0);
}

/// Only the releasable share of molten fat leaves, from hot flesh near a face.
#[test]
fn fat_renders_from_hot_faces_into_the_pan() {
    let steak = model("beef-marbled", 1.6, [0.12, 0.08, 0.025]);
    let mut run = Run::new(&steak, 5.0);
    run.fry(30.0, 40.0, 500.0, kitchen_air());
    assert_eq!(run.state.rendered, 0.0);
    run.fry(300.0, 200.0, 400.0, kitchen_air());
    let raw: f64 = steak.initial_fat().iter().sum();
    let now: f64 = run.state.fat.iter().sum();
    assert!((raw - now - run.passed.rendered).abs() < 1e-12 && run.state.rendered == run.passed.rendered);
    assert!((0.01..0.25).contains(&(run.passed.rendered / raw)), "{}", run.passed.rendered / raw);
    let middle = swept_mesh(&steak).node(swept_mesh(&steak).levels.len() / 2, 0);
    assert!(run.state.fat[middle] > 0.99 * steak.initial_fat()[middle]);
}

/// Shrimp curl as myosin, then actin denatures; a steak does not.
#[test]
fn shrimp_curl_as_they_cook() {
    let shrimp = model("shrimp", 1.6, [0.065, 0.016, 0.016]);
    let mut run = Run::new(&shrimp, 5.0);
    let mut curls = vec![shrimp.curl(&run.state)];
    for _ in 0..4 {
        run.fry(40.0, 180.0, 400.0, kitchen_air());
        curls.push(shrimp.curl(&run.state));
    }
    assert!(curls[0] == 0.0 && curls.windows(2).all(|w| w[1] >= w[0]), "{curls:?}");
    assert!(curls[4].to_degrees() > 5.0, "{curls:?}");
    // All changed: 10 % over 16 mm along 65 mm.
    run.state.changed.iter_mut().for_each(|field| field.fill(1.0));
    assert!((shrimp.curl(&run.state) - 0.1 * 65.0 / 16.0).abs() < 1e-9);
    assert_eq!(lean().curl(&FoodState::raw(lean(), ZERO_C + 60.0)), 0.0);
}

/// Done faces draw back from the side and the raw middle protrudes; where all is cooked alike, the side is straight.
#[test]
fn the_side_bulges_where_it_contracts_less_than_the_faces() {
    let steak = lean();
    let mut state = dabbed(steak, 5.0);
    steak.shrink(&mut state);
    assert!(steak.edge_shifts(&state).iter().all(|shift| *shift == 0.0));
    let levels = swept_mesh(steak).levels.len();
    let n = state.water.len() / levels;
    for level in [0, 1, 2, 3, levels - 4, levels - 3, levels - 2, levels - 1] {
        let nodes = level * n..(level + 1) * n;
        state.changed.iter_mut().for_each(|change| change[nodes.clone()].fill(1.0));
        state.water[nodes].iter_mut().for_each(|w| *w *= 0.6);
    }
    steak.shrink(&mut state);
    let shifts = steak.edge_shifts(&state);
    // A cooked level contracts by ln √0.78 to ln √0.82, over 5 mm.
    let step = shifts[levels / 2] - shifts[0];
    assert!(shifts[0] < 0.0 && shifts[levels - 1] < 0.0 && (0.45e-3..0.65e-3).contains(&step), "{shifts:?}");
    state.changed.iter_mut().for_each(|change| change.fill(1.0));
    state.water.iter_mut().zip(steak.initial_water()).for_each(|(w, raw)| *w = 0.6 * raw);
    steak.shrink(&mut state);
    assert!(steak.edge_shifts(&state).iter().all(|shift| shift.abs() < 1e-9));
}
