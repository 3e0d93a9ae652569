//! Promise: a film of juice is only on wet faces; it beads on the cold face before the turn.

use saute_food::ZERO_C;

use crate::run::{Run, kitchen_air, lean};

/// There is no film on raw meat and none on a face that has boiled dry. Contraction of the hot flesh drives juice through the
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
