//! Promise: the desk answers all questions about the watched piece from one present, states how old the answers are, begins
//! again after something was done, and works no more than it was given time for.

use saute_kitchen::{Command, FRAME_S, Kitchen, Library, TICK_S};
use saute_plan::forecast::{Desk, EXACT_S, HORIZON_S, Question, Wanted};

use super::comparison::{Case, FOOD};

fn kitchen(library: &Library) -> Kitchen {
    let thin =
        Case { size_mm: [70.0, 60.0, 15.0], kind: "beef-lean", held_c: None, flipped_at_s: None, ..Case::numbered(5) };
    // Late enough that the core, taken out, gets warmer than the room: it has a peak, and raw food none.
    Case { at_s: 90.0, ..thin }.kitchen(library)
}

/// Works until the desk needs no more time; returns the ticks of work.
fn work(desk: &mut Desk) -> u64 {
    let mut all = 0;
    loop {
        let worked = desk.advance(50);
        assert!(worked <= 50);
        all += worked;
        if worked < 50 {
            return all;
        }
    }
}

#[test]
fn it_answers_every_question_from_one_present() {
    let library = Library::embedded().unwrap();
    let mut kitchen = kitchen(&library);
    let mut desk = Desk::default();
    assert_eq!(desk.wants(kitchen.frame(), 0), Wanted::Nothing);
    desk.watch(Some(FOOD), Some(library.scales[0].clone()));
    assert_eq!(desk.wants(kitchen.frame(), 0), Wanted::Present);
    desk.begin(&kitchen, 0).unwrap();
    assert_eq!(desk.wants(kitchen.frame(), 0), Wanted::Time);
    work(&mut desk);
    assert_eq!(desk.wants(kitchen.frame(), 0), Wanted::Nothing);
    let core = kitchen.piece(FOOD).unwrap().core();
    for question in Question::ALL {
        let answer = desk.answer(question).unwrap();
        let outlook = &answer.outlook;
        assert_eq!((outlook.samples[0].after_s, outlook.samples[0].core), (0.0, core), "{question:?}");
        assert_eq!(outlook.samples.last().unwrap().after_s, HORIZON_S);
        let shares = outlook.samples.last().unwrap().shares.unwrap();
        assert!((shares.0.iter().sum::<f64>() - 100.0).abs() < 1e-9);
        assert!(answer.is_current(0) && !answer.is_current(1));
    }
    let peak = |question| desk.answer(question).unwrap().outlook.peak;
    assert!(peak(Question::TakeOut).is_over && peak(Question::TakeOut).core > core);
    assert!(peak(Question::TakeOut).core < peak(Question::LowerHeat).core);
    assert!(peak(Question::LowerHeat).core < peak(Question::AsItIs).core);
    let exact = &desk.exact_answer().unwrap().outlook;
    (0..(EXACT_S / TICK_S).round() as u64).for_each(|_| kitchen.step());
    assert_eq!(exact.samples.last().unwrap().core, kitchen.piece(FOOD).unwrap().core());
}

#[test]
fn it_begins_anew_after_something_was_done_and_the_full_model_looks_further_every_ten_seconds() {
    let library = Library::embedded().unwrap();
    let mut kitchen = kitchen(&library);
    let mut desk = Desk::default();
    desk.watch(Some(FOOD), None);
    desk.begin(&kitchen, 0).unwrap();
    desk.advance(20);
    kitchen.step();
    // Time passes while a round is under way: it goes on. Something is done: it begins again.
    assert_eq!(desk.wants(kitchen.frame(), 0), Wanted::Time);
    assert_eq!(desk.wants(kitchen.frame(), 1), Wanted::Present);
    work(&mut desk);
    let began = desk.exact_answer().unwrap().outlook.frame;
    (0..20).for_each(|_| kitchen.step());
    assert_eq!(desk.wants(kitchen.frame(), 0), Wanted::Present);
    assert!((desk.answer(Question::Flip).unwrap().age_s(kitchen.frame()) - 2.1).abs() < FRAME_S);
    desk.begin(&kitchen, 0).unwrap();
    work(&mut desk);
    assert_eq!(desk.exact_answer().unwrap().outlook.frame, began);
    (0..80).for_each(|_| kitchen.step());
    desk.begin(&kitchen, 0).unwrap();
    work(&mut desk);
    let exact = &desk.exact_answer().unwrap().outlook;
    assert_eq!(exact.frame, began + 600, "of a present that it had passed it runs what is missing");
    let mut later = kitchen.clone();
    (0..599).for_each(|_| later.step());
    let cores = (exact.samples[0].after_s, exact.samples.last().unwrap().core);
    assert_eq!(cores, (0.0, later.piece(FOOD).unwrap().core()));
    // On a cold hob nobody lowers the heat.
    kitchen.apply(&Command::Hob(0.0)).unwrap();
    desk.begin(&kitchen, 1).unwrap();
    assert!(desk.answer(Question::LowerHeat).is_none());
    work(&mut desk);
    assert!(desk.answer(Question::Flip).unwrap().is_current(1) && desk.exact_answer().unwrap().is_current(1));
}

#[test]
fn as_it_is_goes_on_from_round_to_round_and_says_what_a_new_one_would() {
    let library = Library::embedded().unwrap();
    let mut kitchen = kitchen(&library);
    let [mut desk, mut anew] = [Desk::default(), Desk::default()];
    desk.watch(Some(FOOD), None);
    let round = |desk: &mut Desk, kitchen: &Kitchen| {
        desk.begin_with(kitchen, 0, &[Question::AsItIs]).unwrap();
        work(desk)
    };
    let first = round(&mut desk, &kitchen);
    for lasts in [23, 4, 31] {
        (0..lasts).for_each(|_| kitchen.step());
        let worked = round(&mut desk, &kitchen);
        assert!(worked < first / 20, "{worked} of {first}");
        anew.watch(None, None);
        anew.watch(Some(FOOD), None);
        round(&mut anew, &kitchen);
        let [went_on, begun] = [&desk, &anew].map(|desk| &desk.answer(Question::AsItIs).unwrap().outlook);
        assert_eq!((went_on.frame, went_on.samples[0]), (begun.frame, begun.samples[0]));
        for after_s in [0.0, 60.0, 120.0, HORIZON_S] {
            let [one, other] = [went_on, begun].map(|outlook| outlook.core_at(after_s));
            assert!((one - other).abs() < 0.1, "{one} K and {other} K after {after_s} s");
        }
        let last_s = went_on.samples.last().unwrap().after_s;
        assert!((HORIZON_S - 1e-3..HORIZON_S + 0.5).contains(&last_s), "{last_s} s");
        assert!(went_on.samples.windows(2).all(|pair| pair[0].after_s < pair[1].after_s));
    }
    // After half a minute it begins again, as if nothing had gone before.
    (0..250).for_each(|_| kitchen.step());
    round(&mut desk, &kitchen);
    anew.watch(None, None);
    anew.watch(Some(FOOD), None);
    round(&mut anew, &kitchen);
    assert_eq!(desk.answer(Question::AsItIs), anew.answer(Question::AsItIs));
}

#[test]
fn it_drops_what_it_found_of_another_piece() {
    let library = Library::embedded().unwrap();
    let kitchen = kitchen(&library);
    let mut desk = Desk::default();
    desk.watch(Some(FOOD), None);
    desk.begin(&kitchen, 0).unwrap();
    work(&mut desk);
    desk.watch(Some(FOOD), None);
    assert!(desk.answer(Question::AsItIs).is_some());
    desk.watch(Some("another"), None);
    assert!(desk.answer(Question::AsItIs).is_none() && desk.exact_answer().is_none());
    desk.begin(&kitchen, 0).unwrap();
    assert_eq!(desk.advance(10), 0);
}

#[test]
fn while_a_hand_turns_a_piece_over_only_the_full_model_runs() {
    let library = Library::embedded().unwrap();
    let mut kitchen = kitchen(&library);
    let mut desk = Desk::default();
    desk.watch(Some(FOOD), None);
    kitchen.apply(&Command::Flip { food: FOOD.into() }).unwrap();
    kitchen.step();
    desk.begin(&kitchen, 1).unwrap();
    work(&mut desk);
    assert!(Question::ALL.iter().all(|question| desk.answer(*question).is_none()));
    assert!(desk.exact_answer().unwrap().is_current(1));
    (0..30).for_each(|_| kitchen.step());
    assert_eq!(desk.wants(kitchen.frame(), 1), Wanted::Present);
    desk.begin(&kitchen, 1).unwrap();
    work(&mut desk);
    assert!(desk.answer(Question::Flip).unwrap().is_current(1));
}
