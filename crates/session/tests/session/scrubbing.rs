//! Prints how fast time is turned in a cook of twenty minutes, and how large its keyframes are. Run it with `--ignored --nocapture`; speed
//! is shown, never asserted, but keyframes keep to their size.

use std::sync::Arc;
use std::time::Instant;

use saute_kitchen::{Command, Library};
use saute_recipe::Recipe;
use saute_session::timeline::MOST_BYTES;
use saute_session::{FoodChoice, Session};

/// The dish of which the window's speed is measured.
const DISH: &str = include_str!("../../../window/src/desktop/dish.toml");
/// Length of the cook [s].
const COOK_S: f64 = 1200.0;
/// Budget of a slice, as the window gives it [ms].
const SLICE_MS: u64 = 20;
/// Instants, as shares of the cook, in an order that goes back and forth.
const SHARES: [f64; 12] = [0.93, 0.07, 0.51, 0.49, 0.999, 0.31, 0.77, 0.003, 0.62, 0.18, 0.86, 0.41];

fn cook_on(session: &mut Session) {
    while session.kitchen.time_s() < COOK_S {
        session.set_paused(false);
        session.tick().expect("ticks");
    }
}

fn report(name: &str, session: &mut Session, cooked_s: f64) {
    let [mut shown, mut exact] = [Vec::new(), Vec::new()];
    for share in SHARES {
        let begun = Instant::now();
        session.scrub(share * COOK_S);
        shown.push(begun.elapsed().as_secs_f64());
        while session.is_travelling() {
            session.travel_on(web_time::Duration::from_millis(SLICE_MS));
        }
        exact.push(begun.elapsed().as_secs_f64());
    }
    let most = |times: &[f64]| times.iter().copied().fold(0.0, f64::max);
    let mean = |times: &[f64]| times.iter().sum::<f64>() / times.len() as f64;
    println!(
        "{name}: cooked in {cooked_s:.1} s; shown after {:.3} s (most {:.3}), exact after {:.3} s (most {:.3}); {} keyframes, {:.1} MB",
        mean(&shown),
        most(&shown),
        mean(&exact),
        most(&exact),
        session.keyframe_count(),
        session.keyframe_bytes() as f64 / f64::from(1 << 20),
    );
    assert!(session.keyframe_bytes() <= MOST_BYTES);
}

#[test]
#[ignore = "a cook of twenty minutes, for its numbers"]
fn scrubbing_in_the_default_steak() {
    let library = Arc::new(Library::embedded().expect("embedded data"));
    let mut session = Session::new(library, &FoodChoice::default()).expect("sets out");
    session.command(&Command::Hob(1100.0)).expect("hob");
    session.command(&Command::Put { food: "steak".into(), at: [0.0; 2], heap: false }).expect("put");
    let begun = Instant::now();
    cook_on(&mut session);
    report("default steak", &mut session, begun.elapsed().as_secs_f64());
}

#[test]
#[ignore = "twenty minutes of a dish of 23, for its numbers"]
fn scrubbing_in_the_dish_of_23() {
    let library = Arc::new(Library::embedded().expect("embedded data"));
    let recipe = Recipe::parse(DISH, "dish.toml", &library).expect("parses");
    let mut session = Session::new(library, &FoodChoice::default()).expect("sets out");
    session.play(recipe).expect("plays");
    let begun = Instant::now();
    cook_on(&mut session);
    report("dish of 23", &mut session, begun.elapsed().as_secs_f64());
}
