//! Promise: a film of juice stands only on wet faces that have been hot.

use saute_food::ZERO_C;

use crate::run::{Run, kitchen_air, lean};

/// There is no film on raw, cold meat and none on a face that has boiled dry.
#[test]
fn juice_stands_on_a_face_that_has_been_hot_and_is_wet_alone() {
    let mut run = Run::new(lean(), 5.0);
    assert!(lean().juice_films(&run.state).iter().all(|film| *film == 0.0));
    run.fry(900.0, 105.0, 400.0, kitchen_air());
    let films = lean().juice_films(&run.state);
    let wettest = (0..films.len()).max_by(|a, b| films[*a].total_cmp(&films[*b])).expect("nodes");
    assert!(films[wettest] > 0.2, "{}", films[wettest]);
    for (node, film) in films.iter().enumerate().filter(|(_, film)| **film > 0.02) {
        let (peak, held) = (run.state.peak[node] - ZERO_C, run.state.water[node] / lean().initial_water()[node]);
        assert!(peak > 35.0 && held > 0.45, "{film} at {peak} °C with {held}");
    }
    run.fry(150.0, 230.0, 500.0, kitchen_air());
    let films = lean().juice_films(&run.state);
    let dry = (0..films.len()).filter(|&node| run.state.water[node] < 0.3 * lean().initial_water()[node]);
    let dry: Vec<f64> = dry.map(|node| films[node]).collect();
    assert!(dry.len() > 20 && dry.iter().all(|film| *film == 0.0), "{}", dry.len());
}
