//! Promise: a film of juice is only on wet faces; it beads on the cold face before the turn.

use saute_food::ZERO_C;

use crate::run::{Run, kitchen_air, lean};

/// There is no film on raw meat beyond its own, and none on a face that has boiled dry. Contraction of the hot flesh drives juice through the
/// cold level: it beads on the upper face.
#[test]
fn juice_stands_on_wet_faces_alone_and_beads_on_the_cold_one() {
    let mut run = Run::new(lean(), 5.0);
    assert!(lean().juice_films(&run.state).iter().all(|film| *film == 0.0));
    run.fry(900.0, 105.0, 400.0, kitchen_air());
    let films = lean().juice_films(&run.state);
    let wettest = (0..films.len()).max_by(|a, b| films[*a].total_cmp(&films[*b])).expect("nodes");
    assert!(films[wettest] > 0.2, "{}", films[wettest]);
    for (node, film) in films.iter().enumerate().filter(|(_, film)| **film > 0.02) {
        let held = run.state.water[node] / lean().initial_water()[node];
        assert!(held > 0.45, "{film} with {held}");
    }
    let peak = run.state.peak[wettest] - ZERO_C;
    assert!(peak < 60.0 && lean().mesh().position(wettest)[2] > 0.02, "beads at {peak} °C");
    run.fry(150.0, 230.0, 500.0, kitchen_air());
    let films = lean().juice_films(&run.state);
    let dry = (0..films.len()).filter(|&node| run.state.water[node] < 0.3 * lean().initial_water()[node]);
    let dry: Vec<f64> = dry.map(|node| films[node]).collect();
    assert!(dry.len() > 20 && dry.iter().all(|film| *film == 0.0), "{}", dry.len());
}

/// Raw faces are moist: the film is a part of the piece's mass beside its flesh, its juice lies on the faces alone, and does not run off.
#[test]
fn a_raw_piece_has_a_film_on_its_faces_and_its_own_mass() {
    let (model, state) = (lean(), saute_food::FoodState::raw(lean(), ZERO_C + 5.0));
    assert!((state.mass(model) / model.raw_mass() - 1.0).abs() < 1e-12);
    let [length, width, _] = model.size();
    let film: f64 = state.juice.iter().sum();
    // Two faces of an oval, 36 g/m².
    let oval = 2.0 * 0.036 * length * width;
    assert!((0.8 * oval..oval).contains(&film), "{film} kg on two faces within {length} x {width} m");
    for (node, juice) in state.juice.iter().enumerate() {
        let height = model.mesh().position(node)[2];
        assert!(*juice == 0.0 || !(1e-3..0.024).contains(&height), "{juice} kg at {height} m");
    }
    let mut run = Run::new(model, 5.0);
    run.fry(60.0, 5.0, 0.0, kitchen_air());
    assert_eq!(run.state.dripped, 0.0);
}
