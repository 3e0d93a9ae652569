//! Promise: a cook who follows the advice, and nothing else, meets the goal *medium, with a crust* in every flat pan, whatever the
//! steak's thickness: brown on both sides, nothing charred, and the oil far below its flash point.

use saute_fixtures::campaign::pairs;
use saute_kitchen::advice::{Advice, Goal as Wish, Situation, class_goal};
use saute_kitchen::food::{Rules, Scale};
use saute_kitchen::piece::carry_over::foreseen_peak;
use saute_kitchen::{Command, Kitchen, Library, MeshSize, OutlineKind, PieceOrder, RestOn, TICK_S, celsius, kelvin};
use saute_plan::goal::{Goal, Outcome, Shortfall};

/// How often a cook looks at the advice [s].
const LOOKS_S: f64 = 5.0;
/// Hottest place of a pan that nobody need fear [°C]: 40 K below the flash points of cooking oils.
const SAFE_C: f64 = 270.0;

fn set_out(library: &Library, pan: &str, mm: f64, seed: u64) -> Kitchen {
    let mut kitchen = Kitchen::new(library, pan, kelvin(20.0)).expect("pan");
    let steak = PieceOrder {
        id: "steak".into(),
        kind: "beef-lean".into(),
        size: [0.120, 0.080, 1e-3 * mm],
        temperature: kelvin(5.0),
        seed,
        coarseness: 1.5,
        rules: Rules::Full,
        mesh: MeshSize::Default,
        outline: OutlineKind::Natural,
    };
    kitchen.add(library, &steak).expect("food");
    kitchen.apply(&Command::Oil { kind: None, mass: 0.005 }).expect("oil");
    kitchen
}

fn first_advice(kitchen: &Kitchen, core_c: f64) -> Option<Advice> {
    let piece = &kitchen.pieces()[0];
    let foreseen_c = celsius(foreseen_peak(&piece.model, &piece.state, kitchen.room()).0);
    Situation::of(kitchen, piece).advice(Some(Wish::Peak { core_c, foreseen_c })).first().copied()
}

fn command(advice: Advice) -> Option<Command> {
    let food = || "steak".to_owned();
    match advice {
        Advice::PutIn { .. } => Some(Command::Put { food: food(), at: [0.0; 2], heap: false }),
        Advice::Flip => Some(Command::Flip { food: food() }),
        Advice::TakeOut { .. } => Some(Command::Rest { food: food(), on: RestOn::Board }),
        about_hob => about_hob.hob_w().map(Command::Hob),
    }
}

/// Follows the advice until the steak has rested; returns how often it was flipped.
fn follow(kitchen: &mut Kitchen, core_c: f64) -> usize {
    let mut flips = 0;
    loop {
        let advice = first_advice(kitchen, core_c);
        if matches!(advice, Some(Advice::Rested { .. })) {
            return flips;
        }
        flips += usize::from(advice == Some(Advice::Flip));
        if let Some(command) = advice.and_then(command) {
            kitchen.apply(&command).expect("advice can be followed");
        }
        (0..(LOOKS_S / TICK_S) as usize).for_each(|_| kitchen.step());
        assert!(kitchen.time_s() < 3600.0, "the advice leads nowhere: {advice:?}");
    }
}

#[track_caller]
fn meets(library: &Library, scale: &Scale, class: &str, [pan, mm, seed]: [&str; 3]) {
    let goal = Goal::described(library.goal(class).expect("shipped"), scale).expect("is on it");
    let at = scale.class.iter().position(|one| one.name == class).expect("is a class");
    let mut kitchen = set_out(library, pan, mm.parse().expect("mm"), seed.parse().expect("seed"));
    let mass = kitchen.pieces()[0].mass();
    let flips = follow(&mut kitchen, class_goal(scale, at));
    let outcome = Outcome::read(&kitchen, &[mass], &goal);
    assert_eq!(Shortfall::of(&outcome, &goal), [], "{pan} {mm} mm {class}, {flips} flips: {outcome:?}");
    assert!(outcome.hottest_c < SAFE_C && !outcome.fire_hazard, "{pan} {mm} mm {class}: {outcome:?}");
}

const PANS: [&str; 4] = ["carbon-steel-26", "cast-iron-26", "aluminium-26", "stainless-clad-26"];

/// Every thickness and every pan; each with each in the campaign.
#[test]
fn whoever_follows_the_advice_meets_the_goal_in_every_flat_pan() {
    let library = Library::embedded().expect("embedded data");
    let scale = library.scale("paper-2013").expect("shipped");
    for (pan, mm) in pairs(&PANS, &["15", "20", "25", "35"]) {
        meets(&library, scale, "medium", [pan, mm, "1"]);
    }
    for (pan, [mm, seed]) in pairs(&PANS, &[["22", "5"], ["30", "2"]]) {
        meets(&library, scale, "rare", [pan, mm, seed]);
    }
}

#[test]
fn the_grill_pan_browns_steaks_that_are_not_thin() {
    let library = Library::embedded().expect("embedded data");
    let scale = library.scale("paper-2013").expect("shipped");
    for mm in ["25", "35"] {
        meets(&library, scale, "medium", ["cast-iron-grill-26", mm, "1"]);
    }
}
