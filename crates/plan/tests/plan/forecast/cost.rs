//! Promise: all questions about one steak are answered twice a second on half of one core.

use std::time::Duration;

use saute_fixtures::processor;
use saute_kitchen::Library;
use saute_kitchen::reduced::Reductions;
use saute_plan::forecast::{Ahead, Ask, EXACT_S, Exact, Question};

use super::comparison::{Case, FOOD};

/// Time of the processor for the work of this thread.
fn computed(work: impl FnOnce()) -> Duration {
    processor::of_thread(work).1
}

/// Half of a core for half a second, less what "as it is" with the full model takes of it every ten seconds.
#[test]
#[ignore = "measures time: run it alone"]
fn cost_of_a_round_is_a_quarter_of_a_second_at_most() {
    let library = Library::embedded().unwrap();
    let case = Case { size_mm: [120.0, 80.0, 25.0], kind: "beef-lean", ..Case::numbered(3) };
    let kitchen = case.kitchen(&library);
    let ask = |question| Ask { food: FOOD.into(), question, scale: Some(library.scales[0].clone()) };
    let mut reductions = Reductions::default();
    let first = computed(|| drop(kitchen.reduced(&mut reductions).unwrap()));
    let mut round = computed(|| drop(kitchen.reduced(&mut reductions).unwrap()));
    println!("carried over: {first:?} the first time, then {round:?}");
    for question in Question::ALL {
        let mut ahead = Ahead::begin(&kitchen, &ask(question), &mut reductions).unwrap().unwrap();
        let spent = computed(|| while ahead.advance(100) > 0 {});
        println!("{question:?}: {spent:?}");
        round += spent;
    }
    let exact = computed(|| {
        Exact::begin(&kitchen, &ask(Question::AsItIs), EXACT_S).unwrap().unwrap().advance(u64::MAX);
    });
    println!("round: {round:?}; {EXACT_S} s of the full model: {exact:?}");
    assert!(round + exact / 20 < Duration::from_millis(250));
}
