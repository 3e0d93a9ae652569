//! Promise: a cook that a helper plays elsewhere, handed over as bytes, is the cook that the window plays itself: bit by bit, with its
//! curves and marks.

use std::cell::RefCell;
use std::rc::Rc;
use std::sync::Arc;

use saute_kitchen::{Command, Library};
use saute_recipe::Recipe;
use saute_session::Session;
use saute_session::playback::playing::Playing;
use saute_session::work::in_frames::{Frames, OrInFrames};
use saute_session::work::thread::Threads;
use saute_session::work::worker::Worker;
use saute_session::work::{Agency, Helper, WorkKind};
use web_time::Duration;

/// How long a frame may play.
const FRAME: Duration = Duration::from_millis(5);

/// How often a stop is due: often enough for several in a cook of 90 s, however fast the machine plays it.
const STOP: Duration = Duration::from_millis(2);

/// A helper in the same thread: it works when the test lets it.
#[derive(Clone)]
struct Beside {
    executor: Rc<RefCell<Playing>>,
    answers: Rc<RefCell<Vec<Vec<u8>>>>,
    fails: bool,
    asked: Rc<RefCell<usize>>,
}

impl Beside {
    fn new(library: &Arc<Library>) -> Self {
        let executor = Rc::new(RefCell::new(Playing::new(Arc::clone(library)).stopping_every(STOP)));
        Self { executor, answers: Rc::default(), fails: false, asked: Rc::default() }
    }

    /// Plays a single tick, whatever the machine's speed.
    fn work(&self) {
        self.answers.borrow_mut().extend(self.executor.borrow_mut().go_on(Duration::ZERO));
    }
}

impl Helper for Beside {
    fn ask(&mut self, order: Vec<u8>) {
        *self.asked.borrow_mut() += 1;
        self.executor.borrow_mut().take(&order);
    }

    fn answers(&mut self) -> Option<Vec<Vec<u8>>> {
        (!self.fails).then(|| std::mem::take(&mut *self.answers.borrow_mut()))
    }
}

fn library() -> Arc<Library> {
    Arc::new(Library::embedded().expect("embedded data"))
}

fn cooked(library: &Arc<Library>) -> Session {
    let mut session = Session::new(Arc::clone(library), &Default::default()).expect("sets out");
    session.play(Recipe::parse(&library.recipes["medium"], "medium", library).expect("parses")).expect("plays");
    let cook = |session: &mut Session, s: f64| (0..(10.0 * s) as u32).for_each(|_| session.tick().expect("ticks"));
    cook(&mut session, 30.0);
    session.command(&Command::Hob(1500.0)).expect("hob");
    cook(&mut session, 20.0);
    session.command(&Command::Put { food: "steak".into(), at: [0.0; 2], heap: false }).expect("puts");
    cook(&mut session, 40.0);
    session
}

/// Lets frames pass until nothing travels; returns how many.
fn arrive(session: &mut Session, helper: &Beside) -> usize {
    (1..10_000)
        .find(|_| {
            helper.work();
            session.advance(Duration::from_millis(16), FRAME).expect("runs");
            !session.is_travelling()
        })
        .expect("arrives")
}

#[test]
fn a_recorded_cook_is_played_elsewhere_with_its_curves_and_marks() {
    let library = library();
    let live = cooked(&library);
    let mut here = Session::new(Arc::clone(&library), &Default::default()).expect("sets out");
    here.resume(live.whole_recording()).expect("resumes");
    here.finish_travel();
    let mut session = Session::new(Arc::clone(&library), &Default::default()).expect("sets out");
    let helper = Beside::new(&library);
    session.employ(Box::new(helper.clone()));
    session.resume(live.whole_recording()).expect("resumes");
    assert!(arrive(&mut session, &helper) > 100, "frames pass on the way");
    assert_eq!(*helper.asked.borrow(), 1);
    assert_eq!(session.kitchen.state_hash(), live.kitchen.state_hash());
    let recorded = |session: &Session| {
        let recording = session.recording();
        (recording.entries().to_vec(), recording.hashes().clone(), recording.moment(), session.marks.clone())
    };
    assert_eq!(recorded(&session), recorded(&here));
    assert_eq!(session.recorder.rows, here.recorder.rows);
    assert!(session.keyframe_count() > 2 && session.left_recipe().is_some());
    // Both go on in the same way.
    for session in [&mut session, &mut here] {
        session.command(&Command::Flip { food: "steak".into() }).expect("flips");
        (0..100).for_each(|_| session.tick().expect("ticks"));
    }
    assert_eq!(session.kitchen.state_hash(), here.kitchen.state_hash());
    assert_eq!(session.recorder.rows, here.recorder.rows);
}

/// At real time a cook may be stopped between two ticks; it is that instant which comes back.
#[test]
fn a_cook_that_was_stopped_within_a_tick_comes_back_to_its_last_frame() {
    let library = library();
    let mut live = cooked(&library);
    live.set_paused(false);
    live.set_speed(1.0);
    while live.kitchen.is_between_ticks() {
        live.advance(Duration::from_millis(17), Duration::MAX).expect("goes on");
    }
    let end = live.kitchen.frame();
    for helps in [true, false] {
        let mut session = Session::new(Arc::clone(&library), &Default::default()).expect("sets out");
        let helper = Beside::new(&library);
        if helps {
            session.employ(Box::new(helper.clone()));
        }
        session.resume(live.whole_recording()).expect("resumes");
        arrive(&mut session, &helper);
        assert_eq!(session.kitchen.frame(), end);
        assert_eq!(session.kitchen.state_hash(), live.kitchen.state_hash());
    }
}

#[test]
fn an_instant_is_reached_elsewhere_and_a_way_beside_it() {
    let library = library();
    let mut session = Session::new(Arc::clone(&library), &Default::default()).expect("sets out");
    session.resume(cooked(&library).whole_recording()).expect("resumes");
    session.finish_travel();
    let exact = |session: &mut Session, helper: Option<&Beside>, s: f64| {
        session.scrub(s);
        match helper {
            Some(helper) => drop(arrive(session, helper)),
            None => session.finish_travel(),
        }
        session.kitchen.state_hash()
    };
    let alone = exact(&mut session, None, 40.0);
    let mut session = Session::new(Arc::clone(&library), &Default::default()).expect("sets out");
    session.resume(cooked(&library).whole_recording()).expect("resumes");
    session.finish_travel();
    let helper = Beside::new(&library);
    session.employ(Box::new(helper.clone()));
    assert_eq!(exact(&mut session, Some(&helper), 40.0), alone);
    // From here another way is gone; the first one is a branch.
    session.command(&Command::Hob(0.0)).expect("hob");
    (0..150).for_each(|_| session.tick().expect("ticks"));
    assert!(session.has_branches());
    let behind = |session: &mut Session| {
        helper.work();
        session.keep_beside(FRAME)
    };
    assert!((0..10_000).any(|_| !behind(&mut session)), "the branch arrives");
    println!("asked {} times", helper.asked.borrow());
    let hashes: Vec<(f64, u64)> = session.ways().iter().map(|w| (w.kitchen.time_s(), w.kitchen.state_hash())).collect();
    session.forget_beside();
    session.employ(Box::new(Beside { fails: true, ..helper.clone() }));
    while session.keep_beside(FRAME) {}
    let alone: Vec<(f64, u64)> = session.ways().iter().map(|w| (w.kitchen.time_s(), w.kitchen.state_hash())).collect();
    assert_eq!(hashes, alone);
}

#[test]
fn without_its_helper_the_window_goes_on_itself() {
    let library = library();
    let live = cooked(&library);
    let mut session = Session::new(Arc::clone(&library), &Default::default()).expect("sets out");
    let helper = Beside { fails: true, ..Beside::new(&library) };
    session.employ(Box::new(helper.clone()));
    session.resume(live.whole_recording()).expect("resumes");
    arrive(&mut session, &helper);
    assert_eq!(session.kitchen.state_hash(), live.kitchen.state_hash());
    assert_eq!(*helper.asked.borrow(), 1);
}

/// Plays a cook with a helper that works at its own speed; returns the hash of its end.
fn played_by(library: &Arc<Library>, live: &Session, helper: Box<dyn Helper>) -> u64 {
    let mut session: Session = Session::new(Arc::clone(library), &Default::default()).expect("sets out");
    session.employ(helper);
    session.resume(live.whole_recording()).expect("resumes");
    while session.is_travelling() {
        session.advance(Duration::from_millis(1), FRAME).expect("runs");
        std::thread::sleep(Duration::from_millis(1));
    }
    session.kitchen.state_hash()
}

#[test]
fn threads_and_frames_and_whoever_stands_in_play_the_same_cook() {
    let library = library();
    let live = cooked(&library);
    let threads = Threads::new(Arc::new(|| {}), || {});
    let failing = Box::new(Beside { fails: true, ..Beside::new(&library) });
    let helpers: [Box<dyn Helper>; 3] = [
        threads.hire(WorkKind::Play, &library),
        Frames.hire(WorkKind::Play, &library),
        Box::new(OrInFrames::new(failing, WorkKind::Play, &library)),
    ];
    for helper in helpers {
        assert_eq!(played_by(&library, &live, helper), live.kitchen.state_hash());
    }
}
