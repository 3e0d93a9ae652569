//! Promise: nothing that was done is lost, and every instant comes back bit by bit.

use std::sync::Arc;

use saute_kitchen::{Command, Library, RestOn};
use saute_recipe::Recipe;
use saute_recipe::session::Done;
use web_time::Duration;

use saute_session::timeline::Undone;
use saute_session::{FoodChoice, Session};
use saute_words::act_words::act_words;
use saute_words::language::Language;

fn session() -> Session {
    let library = Arc::new(Library::embedded().expect("embedded data"));
    let choice = FoodChoice { size_mm: vec![60.0, 50.0, 15.0], preheat_c: 180.0, ..FoodChoice::default() };
    Session::new(library, &choice).expect("sets out")
}

fn cook(s: &mut Session, seconds: f64) {
    let until = s.kitchen.time_s() + seconds;
    while s.kitchen.time_s() < until - 0.05 {
        s.tick().expect("ticks");
    }
}

fn flip() -> Command {
    Command::Flip { food: "steak".into() }
}

/// Hob on, in, a flip, out, over thirty seconds.
fn fried() -> Session {
    let mut s = session();
    s.command(&Command::Hob(1100.0)).expect("hob");
    cook(&mut s, 3.0);
    s.command(&Command::Put { food: "steak".into(), at: [0.0; 2], heap: false }).expect("put");
    cook(&mut s, 12.0);
    s.command(&flip()).expect("flip");
    cook(&mut s, 10.0);
    s.command(&Command::Rest { food: "steak".into(), on: RestOn::Board }).expect("out");
    cook(&mut s, 5.0);
    s
}

/// What was done, in words.
fn words(done: &Done) -> String {
    act_words(done, Language::ENGLISH)
}

/// What was undone, in words; none if it is no act.
fn undone(undone: Option<Undone>) -> Option<String> {
    match undone? {
        Undone::Act(done) => Some(words(&done)),
        Undone::Beginning => None,
    }
}

/// Everything that is shown of a cook, with the state bit by bit.
fn all_of(s: &Session) -> (u64, Vec<saute_recipe::recorder::Row>, Vec<String>, usize) {
    let marks = s.marks.iter().map(|mark| format!("{} {}", mark.time_s, words(&mark.done))).collect();
    (s.kitchen.state_hash(), s.recorder.rows.clone(), marks, s.recording().entries().len())
}

#[test]
fn undo_and_redo_come_back_to_the_same_bits() {
    let mut s = fried();
    let end = all_of(&s);
    for (what, left) in [("out", 3), ("flip", 2), ("in", 1), ("1100 W", 0)] {
        assert_eq!(undone(s.undo()).as_deref(), Some(what));
        s.finish_travel();
        assert_eq!((s.recording().entries().len(), s.paused), (left, true));
        assert_eq!(s.marks.len(), left, "{what}");
    }
    assert_eq!((s.undo(), s.kitchen.time_s()), (None, 0.0));
    let mut times = Vec::new();
    while s.redo() {
        s.finish_travel();
        times.push(s.kitchen.time_s().round());
    }
    assert_eq!(times, [3.0, 15.0, 25.0, 30.0]);
    assert_eq!(all_of(&s), end);
    assert!(!s.can_redo() && s.can_undo());
}

#[test]
fn scrubbing_there_and_back_comes_back_to_the_same_bits() {
    let mut s = fried();
    let end = all_of(&s);
    for time_s in [20.0, 1.0, 29.9, 14.95, 0.0, 12.3] {
        s.scrub(time_s);
        s.finish_travel();
        assert!((s.kitchen.time_s() - time_s).abs() < 0.06, "{} {time_s}", s.kitchen.time_s());
        assert!(s.recorder.rows.iter().all(|row| row.time_s <= time_s + 0.06));
        assert_eq!(s.end_s().round(), 30.0);
    }
    s.scrub(30.0);
    s.finish_travel();
    assert_eq!(all_of(&s), end);
    assert!(!s.lies_ahead());
}

/// A slice of a frame's time shows something near at once; the exact state comes slice by slice.
#[test]
fn a_travel_is_worked_off_in_slices() {
    let mut s = fried();
    let end = s.kitchen.state_hash();
    s.scrub(29.9);
    let mut slices = 0;
    while s.is_travelling() {
        assert!((0.0..=29.95).contains(&s.kitchen.time_s()) && (s.shown_s() - 29.9).abs() < 0.06);
        s.advance(Duration::ZERO, Duration::ZERO).expect("travels");
        slices += 1;
    }
    assert!(slices > 5, "{slices}");
    cook(&mut s, 0.1);
    assert_eq!(s.kitchen.state_hash(), end);
}

#[test]
fn time_that_goes_on_after_scrubbing_does_everything_again() {
    let mut s = fried();
    let end = all_of(&s);
    s.scrub(10.0);
    s.finish_travel();
    cook(&mut s, 20.0);
    assert_eq!(all_of(&s), end);
    assert!(!s.lies_ahead() && s.branches().is_empty());
}

#[test]
fn what_was_undone_does_not_happen_again_and_is_kept_as_a_branch() {
    let mut s = fried();
    let end = all_of(&s);
    s.undo();
    s.undo();
    s.finish_travel();
    cook(&mut s, 5.0);
    assert_eq!(s.recording().entries().len(), 2, "no flip");
    let [branch] = &s.branches()[..] else { panic!("one branch") };
    assert_eq!((branch.done.as_ref().map(words), branch.at_s.round()), (Some("flip".into()), 15.0));
    // Nothing else was done: redo leads back.
    assert!(s.redo());
    s.finish_travel();
    assert_eq!(all_of(&s), end);
    assert!(s.branches().is_empty());
}

#[test]
fn another_act_makes_a_branch_and_both_ways_can_be_gone() {
    let mut s = fried();
    let end = all_of(&s);
    s.scrub(15.0);
    s.command(&Command::Hob(0.0)).expect("hob");
    cook(&mut s, 15.0);
    let other = all_of(&s);
    assert_ne!(other.0, end.0);
    assert!(!s.redo(), "another act was done");
    assert_eq!(s.branches()[0].done.as_ref().map(words).as_deref(), Some("flip"));
    s.go_to_branch(0, true);
    s.finish_travel();
    assert_eq!(all_of(&s), end);
    assert_eq!(s.branches()[0].done.as_ref().map(words).as_deref(), Some("0 W"));
    s.go_to_branch(0, true);
    s.finish_travel();
    assert_eq!(all_of(&s), other);
}

#[test]
fn starting_over_can_be_undone_and_done_again() {
    let mut s = fried();
    let end = all_of(&s);
    s.restart().expect("restarts");
    cook(&mut s, 2.0);
    let fresh = s.kitchen.state_hash();
    assert!(s.can_undo() && s.marks.is_empty());
    assert_eq!(s.undo(), Some(Undone::Beginning));
    assert_eq!(all_of(&s), end);
    assert!(s.redo());
    assert_eq!((s.kitchen.state_hash(), s.marks.len()), (fresh, 0));
    assert_eq!(s.undo(), Some(Undone::Beginning));
    assert_eq!(all_of(&s), end);
}

#[test]
fn food_that_was_added_and_taken_away_comes_back() {
    let mut s = fried();
    s.add(&FoodChoice::default(), 2).expect("adds");
    cook(&mut s, 1.0);
    let with = all_of(&s);
    s.remove(&["steak".into()]);
    assert_eq!(s.kitchen.pieces().len(), 2);
    assert_eq!(s.undo(), Some(Undone::Act(Done::Remove)));
    s.finish_travel();
    assert_eq!(all_of(&s), with);
    assert_eq!(s.undo(), Some(Undone::Act(Done::Add)));
    s.finish_travel();
    assert_eq!(s.kitchen.pieces().len(), 1);
    s.redo();
    s.redo();
    s.finish_travel();
    assert_eq!(s.kitchen.pieces().len(), 2);
    // A restart sets out what was added, too, and an undo does not take it away piece by piece.
    s.restart().expect("restarts");
    assert_eq!(s.kitchen.pieces().len(), 3);
    assert_eq!(s.undo(), Some(Undone::Beginning));
    assert_eq!(s.kitchen.pieces().len(), 2);
}

#[test]
fn a_recipe_that_was_taken_over_and_resumed_comes_back() {
    let mut s = session();
    let text = "[[step]]\nhob_w = 1100\n[[step]]\nat_s = 8\nhob_w = 700\n[[step]]\nat_s = 12\nend = true\n";
    s.play(Recipe::parse(text, "own.toml", &s.library).expect("parses")).expect("plays");
    cook(&mut s, 3.0);
    s.command(&Command::Hob(400.0)).expect("hob");
    cook(&mut s, 2.0);
    assert!(s.resume_recipe());
    cook(&mut s, 4.0);
    assert_eq!(s.kitchen.hob_w(), 700.0, "the recipe went on");
    let end = all_of(&s);
    s.scrub(4.0);
    s.finish_travel();
    assert!(s.runner.is_none() && s.left_recipe().is_some());
    s.scrub(1.0);
    s.finish_travel();
    assert!(s.runner.is_some());
    cook(&mut s, 8.0);
    assert_eq!(all_of(&s), end);
    // The whole session again, as from a file.
    let recording = s.recording().clone();
    let mut again = session();
    again.resume(recording).expect("resumes");
    let mut slices = 0;
    while again.is_travelling() {
        again.advance(Duration::ZERO, Duration::ZERO).expect("plays");
        slices += 1;
    }
    assert!(slices > 50 && again.paused, "{slices}");
    assert_eq!(all_of(&again), end);
}
