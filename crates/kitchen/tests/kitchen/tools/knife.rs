//! Promise: the knife halves a piece on the board once, at the given place, or gives the reason why not; halves cool
//! faster, and the energy account of the cook stays balanced.

use saute_kitchen::food::Rules;
use saute_kitchen::{Command, EventKind, Kitchen, MeshSize, OutlineKind, PieceOrder, Refused, RestOn, kelvin};
use saute_recipe::{Action, Cook, FoodAction, Recipe};

use crate::stove::{apply, library, run};

fn order(kind: &str, size_mm: [f64; 3]) -> PieceOrder {
    PieceOrder {
        id: "food".into(),
        kind: kind.into(),
        size: size_mm.map(|v| v * 1e-3),
        temperature: kelvin(20.0),
        seed: 1,
        coarseness: 1.5,
        rules: Rules::Full,
        mesh: MeshSize::Default,
        outline: OutlineKind::Plain,
    }
}

fn put() -> Command {
    Command::Put { food: "food".into(), at: [0.0, 0.0], heap: false }
}

fn rest(on: RestOn) -> Command {
    Command::Rest { food: "food".into(), on }
}

fn halve(at: f64) -> Command {
    Command::Halve { food: "food".into(), at }
}

/// Fried for a minute, then taken out to rest.
fn rested(kind: &str, size_mm: [f64; 3], on: RestOn) -> Kitchen {
    let mut kitchen = Kitchen::new(&library(), "carbon-steel-26", kelvin(180.0)).expect("pan");
    kitchen.add(&library(), &order(kind, size_mm)).expect("food");
    apply(&mut kitchen, put());
    run(&mut kitchen, 60.0);
    apply(&mut kitchen, rest(on));
    while kitchen.busy() {
        kitchen.step();
    }
    run(&mut kitchen, 1.3);
    kitchen
}

const FOODS: [(&str, [f64; 3]); 4] = [
    ("beef-lean", [100.0, 70.0, 20.0]),
    ("carrot-coin", [30.0, 30.0, 10.0]),
    ("carrot-stick", [60.0, 10.0, 10.0]),
    ("shrimp", [80.0, 20.0, 15.0]),
];

#[test]
fn halves_cool_faster_than_a_whole_piece_and_nothing_changes_at_the_instant_of_the_cut() {
    for (kind, size) in FOODS {
        let mut whole = rested(kind, size, RestOn::Board);
        let mut halves = whole.clone();
        let before = whole.pieces()[0].state.clone();
        apply(&mut halves, halve(0.0));
        assert!(halves.pieces()[0].state == before && halves.energy() == whole.energy(), "{kind}");
        assert_eq!(halves.pieces()[0].halved().map(|cut| cut.at), Some(0.0), "{kind}");
        assert!(whole.pieces()[0].halved().is_none());
        run(&mut whole, 120.0);
        run(&mut halves, 120.0);
        let mean = |kitchen: &Kitchen| {
            let piece = &kitchen.pieces()[0];
            assert!(piece.state.healthy);
            piece.model.volume_mean(&piece.state.temperature)
        };
        assert!(mean(&halves) < mean(&whole) - 0.05, "{kind}: {} {}", mean(&halves), mean(&whole));
        assert!(halves.pieces()[0].mass() < whole.pieces()[0].mass(), "{kind}: it dries or drips at its fresh faces");
    }
}

#[test]
fn the_energy_of_a_cook_with_a_cut_adds_up() {
    let mut kitchen = rested("beef-lean", [100.0, 70.0, 20.0], RestOn::Board);
    apply(&mut kitchen, halve(0.01));
    run(&mut kitchen, 60.0);
    apply(&mut kitchen, put());
    run(&mut kitchen, 60.0);
    assert!(kitchen.pieces()[0].in_pan() && kitchen.pieces()[0].halved().is_some());
    apply(&mut kitchen, rest(RestOn::Rack));
    run(&mut kitchen, 60.0);
    let e = kitchen.energy();
    let moved = e.hob.abs() + e.pan_stored.abs() + e.evaporation.abs() + e.air.abs() + e.other.abs();
    assert!(e.imbalance.abs() < 1e-12 * moved, "{e:?}");
}

#[test]
fn the_knife_says_why_it_does_not_cut() {
    let mut kitchen = Kitchen::new(&library(), "carbon-steel-26", kelvin(180.0)).expect("pan");
    kitchen.add(&library(), &order("beef-lean", [100.0, 70.0, 20.0])).expect("food");
    assert_eq!(kitchen.apply(&halve(0.0)), Err(Refused::NotOnBoard("food".into())));
    apply(&mut kitchen, put());
    run(&mut kitchen, 1.0);
    assert_eq!(kitchen.apply(&halve(0.0)), Err(Refused::NotOnBoard("food".into())));
    let racked = &mut rested("beef-lean", [100.0, 70.0, 20.0], RestOn::Rack);
    assert_eq!(racked.apply(&halve(0.0)), Err(Refused::NotOnBoard("food".into())));
    let mut kitchen = rested("beef-lean", [100.0, 70.0, 20.0], RestOn::Foil);
    assert_eq!(kitchen.apply(&halve(0.06)), Err(Refused::BesideFood { food: "food".into(), most_mm: 47 }));
    assert!(kitchen.pieces()[0].halved().is_none() && kitchen.pieces()[0].place.name() == "foil");
    apply(&mut kitchen, halve(-0.02));
    assert_eq!(kitchen.pieces()[0].place.name(), "board", "foil is taken off");
    assert_eq!(kitchen.apply(&halve(0.0)), Err(Refused::AlreadyHalved("food".into())));
    let told = kitchen.events().tally(EventKind::Halved);
    assert!(told.count == 1 && (told.amount - kitchen.pieces()[0].mass()).abs() < 1e-12);
}

fn recipe(steps: &str) -> String {
    let step = |s: &str| format!("[[step]]\n{s}\n");
    let steps: String = steps.split(';').map(|s| step(s.trim())).collect();
    format!(
        "[pan]\ninitial_c = 180\n[[food]]\nid = \"c\"\nkind = \"carrot-coin\"\ncount = 2\n{steps}[[step]]\nend = true\n"
    )
}

#[test]
fn recipes_halve_by_a_bare_name_or_a_table_and_the_summary_tells_it() {
    let library = library();
    let text = recipe(
        "put = \"c\"; after_s = 5\nrest = \"c\"; after_s = 2\nhalve = \"c.1\"; halve = { food = \"all\", at_mm = 3 }",
    );
    let recipe = Recipe::parse(&text, "cut.toml", &library).expect("parses");
    let action = |i: usize| match &recipe.steps[i].action {
        Action::Each(_, action) => *action,
        other => panic!("{other:?}"),
    };
    assert_eq!((action(2), action(3)), (FoodAction::Halve { at: 0.0 }, FoodAction::Halve { at: 0.003 }));
    let mut cook = Cook::new(recipe, &library).expect("sets out");
    while cook.stopped().is_none() {
        cook.advance().expect("runs");
    }
    let summary = cook.summary(0.0);
    assert_eq!(summary.foods.iter().map(|f| f.halved_at_mm).collect::<Vec<_>>(), [Some(0.0), Some(3.0)]);
    assert_eq!(summary.groups[0].mean.halved_at_mm, Some(1.5));
    assert!(summary.events.iter().any(|t| t.kind == EventKind::Halved && t.count == 2));
    assert!(
        summary
            .steps
            .iter()
            .any(|s| s.action.name() == "halve" && s.action.value()["at_mm"] == 3.0 && s.foods == ["c.2"])
    );
}

#[test]
fn a_recipe_that_halves_what_is_not_on_the_board_is_refused_before_the_cook() {
    let library = library();
    for (steps, line, said) in [
        ("halve = \"c\"", 8, "does not lie on the board"),
        ("put = \"c\"; halve = \"c.1\"", 10, "does not lie on the board"),
        ("put = \"c\"; rest = { food = \"c\", on = \"rack\" }; halve = \"c\"", 12, "does not lie on the board"),
        ("put = \"c\"; rest = \"c\"; halve = \"c\"; halve = \"c.2\"", 14, "in halves already"),
        ("put = \"c\"; rest = \"c\"; halve = { food = \"c\", at_mm = 900 }", 13, "halve.at_mm"),
    ] {
        let error = Recipe::parse(&recipe(steps), "cut.toml", &library).expect_err(steps);
        assert!(error.message.contains(said) && !error.remedy.is_empty(), "{steps}: {error:?}");
        assert!(error.line >= line - 1 && error.line <= line + 1, "{steps}: line {}", error.line);
    }
}
