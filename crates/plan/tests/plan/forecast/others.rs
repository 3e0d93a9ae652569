//! Promise: other foods are forecast as well: several pieces that touch, on their own meshes, under a lid and on ridges.

use saute_kitchen::food::Rules;
use saute_kitchen::reduced::Reductions;
use saute_kitchen::{Command, Kitchen, Library, MeshSize, OutlineKind, PieceOrder, kelvin};
use saute_plan::forecast::{Ahead, Ask, Exact, Outlook, Question};

fn kitchen(library: &Library, pan: &str, kinds: &[&str]) -> Kitchen {
    let mut kitchen = Kitchen::new(library, pan, kelvin(180.0)).unwrap();
    kitchen.apply(&Command::Hob(700.0)).unwrap();
    for (i, kind) in kinds.iter().enumerate() {
        let food = &library.foods[*kind];
        let order = PieceOrder {
            id: format!("{i}"),
            kind: (*kind).into(),
            size: food.form.extent(&food.size.default_mm).unwrap().map(|mm| 1e-3 * mm),
            temperature: kelvin(8.0),
            seed: i as u64,
            coarseness: 1.5,
            rules: Rules::Full,
            mesh: MeshSize::Default,
            outline: OutlineKind::Natural,
        };
        kitchen.add(library, &order).unwrap();
        let at = [0.025 * i as f64 - 0.03, 0.0];
        kitchen.apply(&Command::Put { food: order.id, at, heap: true }).unwrap();
        (0..10).for_each(|_| kitchen.step());
    }
    (0..300).for_each(|_| kitchen.step());
    kitchen
}

/// What is foreseen and what happens within a minute.
fn both(kitchen: &Kitchen, question: Question) -> [Outlook; 2] {
    let ask = Ask { food: "0".into(), question, scale: None };
    let mut ahead = Ahead::begin(kitchen, &ask, &mut Reductions::default()).unwrap().unwrap();
    ahead.advance(120);
    let mut exact = Exact::begin(kitchen, &ask, 60.0).unwrap().unwrap();
    exact.advance(u64::MAX);
    [ahead.outlook().clone(), exact.outlook().clone()]
}

#[test]
fn pieces_that_are_no_slices_are_forecast_with_those_that_they_touch() {
    let library = Library::embedded().unwrap();
    let kitchen = kitchen(&library, "carbon-steel-26", &["shrimp", "carrot-coin", "leek-ring"]);
    for question in [Question::AsItIs, Question::TakeOut] {
        let [foreseen, happened] = both(&kitchen, question).map(|outlook| outlook.core_at(60.0));
        assert!((foreseen - happened).abs() < 3.0, "{question:?}: {foreseen} {happened}");
    }
}

#[test]
fn ridges_and_a_lid_do_not_stop_a_forecast() {
    let library = Library::embedded().unwrap();
    let mut kitchen = kitchen(&library, "cast-iron-grill-26", &["beef-patty"]);
    let [foreseen, happened] = both(&kitchen, Question::AsItIs).map(|outlook| outlook.core_at(60.0));
    assert!((foreseen - happened).abs() < 3.0, "{foreseen} {happened}");
    kitchen.apply(&Command::Lid(true)).unwrap();
    let [foreseen, happened] = both(&kitchen, Question::AsItIs).map(|outlook| outlook.core_at(60.0));
    assert!((foreseen - happened).abs() < 3.0, "{foreseen} {happened}");
    // Nobody turns over what is below a lid.
    let ask = Ask { food: "0".into(), question: Question::Flip, scale: None };
    let flipped = Ahead::begin(&kitchen, &ask, &mut Reductions::default()).unwrap();
    assert!(flipped.is_none());
}

#[test]
fn shrimps_in_much_oil_are_forecast() {
    let library = Library::embedded().unwrap();
    let mut kitchen = kitchen(&library, "carbon-steel-26", &["shrimp", "shrimp"]);
    kitchen.apply(&Command::Oil { kind: Some("canola".into()), mass: 0.2 }).unwrap();
    (0..100).for_each(|_| kitchen.step());
    let [foreseen, happened] = both(&kitchen, Question::AsItIs).map(|outlook| outlook.core_at(60.0));
    assert!((foreseen - happened).abs() < 3.0, "{foreseen} {happened}");
}
