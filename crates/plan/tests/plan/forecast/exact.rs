//! Promise: "as it is" with the full model is the later state of the kitchen, bit for bit, however it is sliced.

use saute_kitchen::{Command, Library};
use saute_plan::forecast::{Ask, EXACT_S, Exact, Question};

use super::comparison::{Case, FOOD};

#[test]
fn as_it_is_equals_the_later_state_bit_for_bit() {
    let library = Library::embedded().unwrap();
    let case = Case { at_s: 20.0, flipped_at_s: None, ..Case::numbered(7) };
    let mut kitchen = case.kitchen(&library);
    // In the middle of a motion, and with all that liquids do.
    kitchen.apply(&Command::Water(0.01)).unwrap();
    kitchen.apply(&Command::Flip { food: FOOD.into() }).unwrap();
    kitchen.step();
    let ask = Ask { food: FOOD.into(), question: Question::AsItIs, scale: None };
    let mut exact = Exact::begin(&kitchen, &ask, EXACT_S).unwrap().unwrap();
    let mut slice = 1;
    while !exact.is_done() {
        exact.advance(slice);
        slice = slice % 17 + 3;
    }
    (0..(EXACT_S / saute_kitchen::TICK_S).round() as u64).for_each(|_| kitchen.step());
    assert_eq!(exact.kitchen().state_hash(), kitchen.state_hash());
    let last = exact.outlook().samples.last().unwrap();
    assert_eq!((last.after_s, last.core), (EXACT_S, kitchen.piece(FOOD).unwrap().core()));
}
