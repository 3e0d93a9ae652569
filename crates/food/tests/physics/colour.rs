//! Promise: the inside of beef has the colour that was measured at 60 °C, and what is estimated at other temperatures.

use saute_food::change::inside_of_beef::INSIDE_OF_BEEF;
use saute_food::{Lab, ZERO_C};

use crate::run::{Run, kitchen_air, lean};

/// Colours of the middle when a steak, turned each minute, reaches the temperatures there.
fn inside() -> Vec<Lab> {
    let mut run = Run::new(lean(), 5.0);
    let mesh = lean().mesh();
    let beside = |node: usize| -> f64 {
        mesh.position(node).iter().zip([0.0, 0.0, 0.0125]).map(|(x, middle)| (x - middle) * (x - middle)).sum()
    };
    let middle = (0..mesh.node_count()).min_by(|a, b| beside(*a).total_cmp(&beside(*b))).expect("nodes");
    let mut colours = Vec::new();
    for minute in 0..40 {
        for _ in 0..60 {
            run.fry(1.0, 170.0, 400.0, kitchen_air());
            let reached = run.state.temperature[middle] - ZERO_C;
            if INSIDE_OF_BEEF.get(colours.len()).is_some_and(|row| reached >= row[0]) {
                colours.push(lean().node_colour(&run.state, middle));
            }
        }
        assert!(minute < 39, "80 °C within 40 min");
        if colours.len() == INSIDE_OF_BEEF.len() {
            break;
        }
        run.flip();
    }
    colours
}

#[test]
fn the_inside_of_beef_has_the_colour_of_its_temperature() {
    let inside = inside();
    let far: Vec<String> = inside
        .iter()
        .zip(INSIDE_OF_BEEF)
        .map(|(got, [celsius, l, a, b])| (celsius, got, got.difference(Lab([l, a, b]))))
        .filter(|(_, _, difference)| *difference > 4.0)
        .map(|(celsius, got, difference)| format!("{celsius} °C: {got:?}, ΔE {difference:.1}"))
        .collect();
    assert!(far.is_empty(), "{}", far.join("\n"));
    // Redness falls all the way.
    assert!(inside.windows(2).all(|w| w[1].0[1] < w[0].0[1]), "{inside:?}");
}
