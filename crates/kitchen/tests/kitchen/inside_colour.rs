//! Promise: the colour of the inside shows the doneness, during the cook as well as rested and halved.

use saute_kitchen::{Command, Library, Piece, TICK_S};
use saute_recipe::{Cook, Recipe};

/// Redness a* at the reddest place of the cut across the middle of the long axis [-].
fn reddest(piece: &Piece) -> f64 {
    let mesh = piece.model.mesh();
    // The crust has a separate colour.
    let inside = |node: &usize| piece.state.browning[*node] < 0.01 && mesh.position(*node)[0].abs() < 5e-3;
    let middle = (0..mesh.node_count()).filter(inside);
    middle.map(|node| piece.model.node_colour(&piece.state, node).0[1]).fold(f64::MIN, f64::max)
}

/// Reddest place, on a coarser mesh, when a shipped recipe takes its steak out, and two minutes after the rested steak was halved.
fn redness(library: &Library, id: &str) -> [f64; 2] {
    let text = library.recipes[id].replacen("[[food]]", "[[food]]\ncoarseness = 1.5", 1);
    let recipe = Recipe::parse(&text, id, library).unwrap_or_else(|e| panic!("{e}"));
    let mut cook = Cook::new(recipe, library).expect("begins");
    let mut live = None;
    while cook.stopped().is_none() {
        cook.fire().unwrap_or_else(|e| panic!("{e}"));
        if live.is_none() && cook.steps.iter().any(|step| step.action.name() == "rest") {
            live = Some(reddest(&cook.kitchen.pieces()[0]));
        }
        cook.tick();
    }
    let food = cook.kitchen.pieces()[0].id.clone();
    cook.kitchen.apply(&Command::Halve { food, at: 0.0 }).expect("halved");
    (0..(120.0 / TICK_S) as usize).for_each(|_| cook.kitchen.step());
    [live.expect("rested"), reddest(&cook.kitchen.pieces()[0])]
}

#[test]
fn rare_medium_and_well_done_differ_by_4_in_redness_from_one_to_the_next() {
    let library = Library::embedded().expect("embedded data");
    let read = ["rare", "medium", "well-done"].map(|id| redness(&library, id));
    for (place, name) in ["taken out", "rested and halved"].iter().enumerate() {
        let a = read.map(|r| r[place]);
        assert!(a[0] >= a[1] + 4.0 && a[1] >= a[2] + 4.0, "{name}: {a:?}");
    }
}
