//! Promise: on a first visit time runs fast while nothing is to be done, and at the pace of a kitchen where a hand is needed; what is
//! requested beyond the few controls opens all of them.

use egui::{Context, RawInput};
use saute_controls::act::{Act, AppAct, Card, CookAct, TimeAct, ViewAct};
use saute_picture::view::View;
use saute_window::{SauteApp, Start};

/// A window without a picture that remembers nothing yet.
struct FirstVisit {
    app: SauteApp,
    ctx: Context,
    now_s: f64,
}

impl FirstVisit {
    fn new(stored: &str) -> Self {
        let ctx = Context::default();
        let app = SauteApp::start(&ctx, None, Some(stored.into()), Start::default()).expect("starts");
        let mut visit = Self { app, ctx, now_s: 0.0 };
        visit.act(Act::App(AppAct::Shut(Card::FirstSteps)));
        visit
    }

    fn act(&mut self, act: Act) {
        let ctx = self.ctx.clone();
        self.app.act(act, &ctx);
        self.frames(2);
    }

    fn frames(&mut self, count: usize) {
        for _ in 0..count {
            self.now_s += 0.001;
            let input = RawInput { time: Some(self.now_s), ..RawInput::default() };
            let _ = self.ctx.clone().run_ui(input, |ui| self.app.frame(ui));
        }
    }

    /// Cooks so many ticks without frames, then draws one.
    fn tick(&mut self, count: usize) {
        (0..count).for_each(|_| self.app.session_mut().tick().expect("ticks"));
        self.frames(1);
    }

    fn speed(&self) -> f64 {
        self.app.session().speed
    }

    /// Cooks without frames until the coach requests a hand, or `most_s` are over; returns how long that took [s].
    fn until_a_hand_is_needed(&mut self, most_s: f64) -> f64 {
        let from_s = self.app.session().kitchen.time_s();
        loop {
            self.tick(10);
            let passed_s = self.app.session().kitchen.time_s() - from_s;
            if self.speed() == 1.0 || passed_s > most_s {
                return passed_s;
            }
        }
    }
}

#[test]
fn time_is_fast_and_waits_for_a_hand() {
    let mut visit = FirstVisit::new("{}");
    assert!(visit.app.settings().few && visit.app.settings().eases);
    assert_eq!(visit.speed(), 1.0, "the hob waits for a hand");
    visit.act(Act::Cook(CookAct::HobSet(1100.0)));
    assert_eq!(visit.speed(), 5.0, "nobody needs to look while the pan heats");
    let heated_s = visit.until_a_hand_is_needed(3600.0);
    assert!((60.0..400.0).contains(&heated_s), "the steak is to go in, after {heated_s} s");
    visit.act(Act::Cook(CookAct::Put));
    visit.frames(3);
    visit.act(Act::Time(TimeAct::SpeedSet(2.0)));
    assert!(visit.speed() == 2.0 && !visit.app.settings().eases, "a speed that was chosen stays");
    // The steak is to be turned within that time.
    visit.until_a_hand_is_needed(360.0);
    assert_eq!(visit.speed(), 2.0);
    visit.act(Act::Time(TimeAct::SpeedEased));
    assert!(visit.app.settings().eases);
}

#[test]
fn a_toss_flies_at_the_pace_of_a_hand_and_time_is_fast_again_afterwards() {
    let mut visit = FirstVisit::new("{}");
    visit.act(Act::Cook(CookAct::HobHold(180.0)));
    visit.until_a_hand_is_needed(3600.0);
    visit.act(Act::Cook(CookAct::Put));
    while visit.speed() == 1.0 {
        visit.tick(10);
    }
    visit.act(Act::Cook(CookAct::Toss));
    visit.tick(12);
    assert_eq!(visit.speed(), 1.0, "it flies and lands");
    visit.tick(6);
    assert_eq!(visit.speed(), 5.0);
}

#[test]
fn a_later_visit_has_what_was_chosen_and_the_speed_that_the_machine_held() {
    let visit = FirstVisit::new("{\"introduced\":true}");
    assert!(!visit.app.settings().few && !visit.app.settings().eases);
    assert_eq!(visit.speed(), 1.0);
    let visit = FirstVisit::new("{\"introduced\":true,\"speed\":20.0,\"held_speed\":3.0}");
    assert_eq!((visit.speed(), visit.app.settings().speed), (3.0, 20.0), "the wish is kept beside it");
}

#[test]
fn what_is_asked_for_by_a_key_opens_all_controls() {
    for act in [ViewAct::Curves, ViewAct::View(View::Temperature), ViewAct::Pantry, ViewAct::Slice] {
        let mut visit = FirstVisit::new("{}");
        visit.act(Act::View(ViewAct::View(View::Look)));
        assert!(visit.app.settings().few);
        visit.act(Act::View(act.clone()));
        assert!(!visit.app.settings().few, "{act:?}");
    }
}
