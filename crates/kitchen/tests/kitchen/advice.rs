//! Promise: a cook who follows the advice, and does nothing else, ends with a steak of the class that was wished.

use saute_fixtures::campaign::pairs;
use saute_kitchen::advice::{Advice, Goal, Situation, advise, class_goal};
use saute_kitchen::doneness::core_class;
use saute_kitchen::food::{Rules, Scale};
use saute_kitchen::piece::carry_over::foreseen_peak;
use saute_kitchen::{Command, Kitchen, Library, MeshSize, OutlineKind, PieceOrder, RestOn, TICK_S, celsius, kelvin};

fn steak(mm: f64) -> PieceOrder {
    PieceOrder {
        id: "steak".into(),
        kind: "beef-lean".into(),
        size: [0.120, 0.080, 1e-3 * mm],
        temperature: kelvin(5.0),
        seed: 1,
        coarseness: 1.5,
        rules: Rules::Full,
        mesh: MeshSize::Default,
        outline: OutlineKind::Natural,
    }
}

fn advice(kitchen: &Kitchen, goal_c: f64) -> Vec<Advice> {
    let piece = &kitchen.pieces()[0];
    let foreseen_c = celsius(foreseen_peak(&piece.model, &piece.state, kitchen.room()).0);
    advise(kitchen, piece, Some(Goal::Peak { core_c: goal_c, foreseen_c }))
}

fn food() -> String {
    "steak".to_owned()
}

/// Follows an advice; returns true if nothing is left to do.
fn follow(kitchen: &mut Kitchen, advice: Advice) -> bool {
    let command = match advice {
        Advice::PutIn { .. } => Command::Put { food: food(), at: [0.0; 2], heap: false },
        Advice::Flip => Command::Flip { food: food() },
        Advice::TakeOut { .. } => Command::Rest { food: food(), on: RestOn::Board },
        Advice::Rested { .. } => return true,
        other => match other.hob_w() {
            Some(watts) => Command::Hob(watts),
            None => return false,
        },
    };
    kitchen.apply(&command).expect("advice can be followed");
    false
}

/// Looks at the first advice every five seconds, as a person does, and follows it.
fn cook(library: &Library, pan: &str, mm: f64, oil: bool, goal_c: f64) -> (Kitchen, Vec<(f64, Advice)>) {
    let mut kitchen = Kitchen::new(library, pan, kelvin(20.0)).expect("pan");
    kitchen.add(library, &steak(mm)).expect("food");
    if oil {
        kitchen.apply(&Command::Oil { kind: None, mass: 0.005 }).expect("oil");
    }
    let mut told = Vec::new();
    while kitchen.time_s() < 3600.0 {
        if let Some(first) = advice(&kitchen, goal_c).first() {
            if first.is_due() {
                told.push((kitchen.time_s(), *first));
            }
            if follow(&mut kitchen, *first) {
                break;
            }
        }
        (0..(5.0 / TICK_S) as usize).for_each(|_| kitchen.step());
    }
    (kitchen, told)
}

fn scale(library: &Library) -> &Scale {
    library.scale("paper-2013").expect("shipped")
}

/// Cooks by the advice and compares the class of the core with the one that was wished.
#[track_caller]
fn reaches(library: &Library, class: usize, pan: &str, mm: f64, oil: bool) {
    let scale = scale(library);
    let (kitchen, told) = cook(library, pan, mm, oil, class_goal(scale, class));
    let piece = &kitchen.pieces()[0];
    let peak_c = celsius(piece.core_peak.0);
    assert_eq!(core_class(piece, scale), scale.class[class].name, "{pan} {mm} mm: {peak_c:.1} °C, {told:?}");
    let flips = told.iter().filter(|(_, advice)| *advice == Advice::Flip).count();
    assert!((1..4).contains(&flips), "{pan} {mm} mm: {told:?}");
    assert_eq!(kitchen.hob_w(), 0.0, "the hob is off in the end");
    let brown = Situation::of(&kitchen, piece).browning;
    assert!(brown.iter().all(|b| *b > 0.5), "{pan} {mm} mm: both sides are brown: {brown:?}");
}

#[test]
fn whoever_follows_the_advice_gets_a_medium_steak() {
    let library = Library::embedded().expect("embedded data");
    reaches(&library, 2, "carbon-steel-26", 18.0, true);
    reaches(&library, 2, "cast-iron-26", 25.0, false);
}

#[test]
fn whoever_follows_it_on_another_stove_gets_one_too() {
    let library = Library::embedded().expect("embedded data");
    for (stove, pan) in pairs(&["gas", "radiant", "iron-plate"], &["carbon-steel-26", "cast-iron-26"]) {
        reaches(&library.on_hob(stove).expect("a hob"), 2, pan, 25.0, true);
    }
}

#[test]
fn whoever_wishes_a_rare_steak_gets_one() {
    let library = Library::embedded().expect("embedded data");
    reaches(&library, 1, "aluminium-26", 25.0, true);
}
