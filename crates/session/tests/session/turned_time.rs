//! Promise: whatever is undone, redone, turned to and done otherwise, what is shown is what its commands make of the beginning.

use std::sync::Arc;

use saute_fixtures::draws::{Draws, count, seed};
use saute_kitchen::dynamics::Pose;
use saute_kitchen::{Command, Library, RestOn};
use saute_recipe::{Recipe, Replay};
use saute_session::{FoodChoice, Session};

/// A thin steak on the coarse mesh, with a recipe that goes on by itself until somebody takes over.
const SMALL: &str = r#"
[pan]
initial_c = 180
[[food]]
id = "steak"
kind = "beef-lean"
size_mm = [60, 50, 10]
initial_c = 5
mesh = "2013"
[[step]]
hob_w = 1000
[[step]]
at_s = 3
put = "steak"
[[step]]
at_s = 9
flip = "steak"
[[step]]
at_s = 600
end = true
"#;

/// Sequences, and things done in each (chosen: half a minute in all).
const SEQUENCES: u64 = 36;
const DEEDS: u64 = 14;
/// Longest time that passes at once [ticks].
const TICKS: u64 = 25;

fn session(library: &Arc<Library>) -> Session {
    let mut session = Session::new(Arc::clone(library), &FoodChoice::default()).expect("sets out");
    session.play(Recipe::parse(SMALL, "small.toml", library).expect("parses")).expect("plays");
    session
}

/// A command that may be refused: then nothing is recorded.
fn command(draws: &mut Draws) -> Command {
    let food = "steak".to_owned();
    match draws.below(7) {
        0 => Command::Hob(100.0 * draws.below(20) as f64),
        1 => Command::Put { food, at: [draws.within(-0.03, 0.03), 0.0], heap: false },
        2 => Command::Flip { food },
        3 => Command::Rest { food, on: RestOn::Board },
        4 => Command::HoldPan { pose: Pose::at(0.0, 0.0, draws.within(0.0, 0.02)) },
        5 => Command::LetGo,
        _ => Command::Water(0.01),
    }
}

fn deed(session: &mut Session, draws: &mut Draws) -> &'static str {
    match draws.below(12) {
        0 | 1 => {
            session.undo();
            "undo"
        }
        2 => {
            session.redo();
            "redo"
        }
        3 | 4 => {
            session.scrub(draws.within(0.0, session.end_s() + 1.0));
            "scrub"
        }
        5 => {
            let branches = session.branches().len() as u64;
            session.go_to_branch(draws.below(branches + 1) as usize, true);
            "branch"
        }
        6 => {
            session.resume_recipe();
            "resume"
        }
        7 => {
            // Some are refused.
            let _ = session.command(&command(draws));
            "command"
        }
        8 => {
            session.keep_beside(web_time::Duration::from_millis(draws.below(3)));
            "beside"
        }
        9 if draws.below(3) == 0 => {
            session.restart().expect("restarts");
            "restart"
        }
        _ => {
            session.set_paused(false);
            // A recipe that was resumed may command what hands have done already: the window reports it, and time stops there.
            let _ = (0..draws.below(TICKS)).all(|_| session.tick().is_ok());
            let _ = session.command(&command(draws));
            "time"
        }
    }
}

/// The kitchen that is shown, and one in which its commands are carried out from the beginning.
fn compare(session: &Session, library: &Library, done: &[&str]) {
    let recording = session.recording();
    let mut fresh = Replay::begin(recording, library).expect("begins");
    fresh.run_to(recording, library, recording.moment());
    assert_eq!(fresh.departure(), None, "{done:?}");
    assert!(fresh.kitchen.to_bytes() == session.kitchen.to_bytes(), "{done:?}");
    // What is shown next to it is what its own commands make of it.
    assert!(session.marks.iter().all(|mark| mark.at <= recording.moment()), "{done:?}");
}

#[test]
fn what_is_shown_is_what_its_commands_make_of_the_beginning() {
    let library = Arc::new(Library::embedded().expect("embedded data"));
    let first = seed();
    for sequence in 0..count("SAUTE_TURNED_TIMES", SEQUENCES) {
        let mut draws = Draws(first.wrapping_add(sequence));
        let (mut session, mut done) = (session(&library), Vec::new());
        for _ in 0..DEEDS {
            done.push(deed(&mut session, &mut draws));
            session.finish_travel();
            compare(&session, &library, &done);
        }
    }
}
