//! Promise: a pan shows for good how hot it has been.

use saute_kitchen::{Command, Kitchen, Library, TICK_S, celsius, kelvin};

use crate::stove::{library, run};

const TINTED: [&str; 5] =
    ["carbon-steel-26", "stainless-clad-26", "cast-iron-26", "cast-iron-grill-26", "carbon-steel-26-nonstick"];

/// How far the middle of the floor is from its colour when new [-].
fn tint(kitchen: &Kitchen) -> f64 {
    let shown = kitchen.pan_model().description.heat_tint.as_ref().expect("a pan that tints");
    let share = shown.share_at(celsius(kitchen.pan_state().peak[0]));
    share.iter().map(|v| (v - 1.0).abs()).sum()
}

#[test]
fn a_pan_heated_once_to_300_degrees_stays_tinted_when_it_has_cooled() {
    let library = library();
    for pan in TINTED {
        let mut kitchen = Kitchen::new(&library, pan, kelvin(20.0)).expect("pan");
        assert_eq!(tint(&kitchen), 0.0, "{pan}");
        kitchen = Kitchen::new(&library, pan, kelvin(300.0)).expect("pan");
        let hot = tint(&kitchen);
        run(&mut kitchen, 900.0);
        assert!(celsius(kitchen.pan_temperature()) < 150.0, "{pan}");
        assert!(hot > 0.02 && tint(&kitchen) == hot, "{pan} {hot}");
        // A copy of the world, as snapshots are, remembers it too.
        assert_eq!(tint(&kitchen.clone()), hot, "{pan}");
    }
}

#[test]
fn the_highest_temperature_of_a_pan_never_falls() {
    let mut kitchen = Kitchen::new(&library(), "carbon-steel-26", kelvin(20.0)).expect("pan");
    let mut before = kitchen.pan_state().peak.clone();
    for (watts, seconds) in [(2000.0, 60.0), (0.0, 120.0), (1500.0, 60.0)] {
        kitchen.apply(&Command::Hob(watts)).expect("accepted");
        for _ in 0..(seconds / TICK_S) as usize {
            kitchen.step();
            let state = kitchen.pan_state();
            assert!(state.peak.iter().zip(&before).all(|(now, was)| now >= was));
            assert!(state.peak.iter().zip(&state.temperature).all(|(peak, t)| peak >= t));
            before.clone_from(&state.peak);
        }
    }
    assert!(before.iter().any(|peak| *peak > kelvin(220.0)));
}

/// Straw, bronze, purple, blue: yellow loses blue light first, blue loses red most.
#[test]
fn carbon_steel_goes_through_the_temper_colours_in_their_order() {
    let library = library();
    let steel = library.pans["carbon-steel-26"].heat_tint.as_ref().expect("steel tints");
    let [straw, bronze, purple, blue] = [220.0, 260.0, 290.0, 310.0].map(|c| steel.share_at(c));
    assert!(straw[0] > straw[1] && straw[1] > straw[2] && straw[0] > 0.95, "{straw:?}");
    assert!(bronze[0] > bronze[1] && bronze[2] < straw[2], "{bronze:?}");
    assert!(purple[1] < purple[0].min(purple[2]), "{purple:?}");
    assert!(blue[2] > blue[1] && blue[1] > blue[0], "{blue:?}");
    assert_eq!(steel.share_at(20.0), [1.0; 3]);
}

#[test]
fn a_heat_tint_that_cannot_be_is_refused_where_it_stands() {
    let text = &Library::embedded_files()["pans/carbon-steel-26.toml"];
    for (from, to, said) in [
        ("celsius = [220.0, 260.0,", "celsius = [260.0, 220.0,", "rise"),
        ("celsius = [220.0, ", "celsius = [", "one colour for each"),
        ("[1.00, 0.88, 0.60]", "[1.00, 0.88, 2.60]", "from 0 to 2"),
    ] {
        let own = ("pans/own.toml".to_owned(), text.replacen(from, to, 1));
        let error = Library::with(&[own]).expect_err(to);
        assert!(error.file == "pans/own.toml" && error.line > 30 && error.message.contains(said), "{error}");
    }
}
