//! Promise: the inside of beef has the colour that was measured at 60 °C, and what is estimated at other temperatures.

use saute_food::change::inside_of_beef::INSIDE_OF_BEEF;
use saute_food::{FreeAir, Lab, ZERO_C};

use crate::run::{Run, kitchen_air, lean, model};

/// Colour of the middle of a small steak that was kept at one temperature [°C], in a bath as warm as itself.
fn kept(celsius: f64, minutes: f64) -> Lab {
    let steak = model("beef-lean", 3.0, [0.05, 0.05, 0.012]);
    let mut run = Run::new(&steak, celsius);
    let (temperature, walls) = (ZERO_C + celsius, ZERO_C + celsius);
    let bath = FreeAir { temperature, walls, convection: 5000.0, mass_transfer: 0.0, ..kitchen_air() };
    run.fry(60.0 * minutes, celsius, 5000.0, bath);
    let middle = steak.mesh().node_count() / 2;
    steak.node_colour(&run.state, middle)
}

/// Blue flesh looks raw: at 40 °C for ten minutes within ΔE 3 of it, at 45 °C within 5; at 50 °C it bleaches.
#[test]
fn flesh_that_was_only_warm_looks_raw() {
    let raw = kept(20.0, 0.1);
    let [blue, warm, rare] = [40.0, 45.0, 50.0].map(|celsius| kept(celsius, 10.0).difference(raw));
    assert!(blue < 3.0 && warm < 5.0 && warm > 1.5 * blue && rare > 8.0, "{blue} {warm} {rare}");
}

/// Above 70 °C flesh goes on to grey and darken, the faster the hotter it is.
#[test]
fn flesh_that_is_kept_hot_greys_on() {
    let [at_75, at_95] = [75.0, 95.0].map(|celsius| [5.0, 20.0, 60.0].map(|minutes| kept(celsius, minutes).0));
    for greys in [at_75, at_95] {
        assert!(greys.windows(2).all(|w| w[1][0] < w[0][0] - 0.3 && w[1][1] < w[0][1]), "{greys:?}");
    }
    assert!(at_95[1][0] < at_75[1][0] - 1.5, "{at_75:?} {at_95:?}");
}

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
    // Rare, medium-rare and medium are distinguishable, and so is each from raw meat.
    assert!(inside[..3].windows(2).all(|w| w[1].difference(w[0]) > 4.0), "{inside:?}");
    // Redness falls all the way.
    assert!(inside.windows(2).all(|w| w[1].0[1] < w[0].0[1]), "{inside:?}");
}
