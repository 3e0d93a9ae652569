//! What a study and a lesson allow of all that a person can do.

use std::collections::BTreeSet;

use saute_picture::View;
use saute_session::guided::permits::{of_lesson, of_study};
use saute_session::permits::Permits;
use saute_study::class::Locked;

use saute_controls::act::{Act, AppAct, Card, CookAct, Setting, TimeAct, ViewAct};

fn allow(permits: Permits, act: &Act) -> bool {
    permits.allow(act.traits().needs)
}

#[test]
fn a_study_allows_cooking_and_looking_and_nothing_that_stops_time_or_leads_out() {
    let [shown, hidden] = [false, true].map(|hidden| of_study(hidden, false));
    for act in [
        Act::Time(TimeAct::Undo),
        Act::Time(TimeAct::SpeedSet(20.0)),
        Act::Time(TimeAct::Pause),
        Act::Cook(CookAct::SetOut(1)),
        Act::Cook(CookAct::Play("rare".into())),
        Act::Cook(CookAct::Restart),
        Act::App(AppAct::Photo),
        Act::App(AppAct::Open(Card::Plan)),
        Act::App(AppAct::Open(Card::AtHome)),
    ] {
        assert!(!allow(shown, &act) && !allow(hidden, &act), "{act:?}");
    }
    for act in [ViewAct::View(View::Temperature), ViewAct::Slice, ViewAct::Curves].map(Act::View) {
        assert!(allow(shown, &act) && !allow(hidden, &act), "{act:?}");
    }
    for act in [CookAct::Put, CookAct::Flip, CookAct::Out, CookAct::HobSet(1000.0)].map(Act::Cook) {
        assert!(allow(hidden, &act), "{act:?}");
    }
    assert!(allow(hidden, &Act::View(ViewAct::View(View::Look))) && allow(hidden, &Act::App(AppAct::Help)));
    let louder = Act::App(AppAct::Set(Setting::Sound(true)));
    assert!(!allow(shown, &louder) && allow(of_study(true, true), &louder), "what is heard is stated by the protocol");
}

#[test]
fn a_lesson_locks_what_its_scenario_says_and_the_way_out_only_if_it_is_locked() {
    let locked = BTreeSet::from([Locked::Speed]);
    let [free, fixed] = [false, true].map(|leaving| of_lesson(&locked, leaving, false));
    assert!(!allow(free, &Act::Time(TimeAct::Step)) && allow(free, &Act::Time(TimeAct::Undo)));
    assert!(allow(free, &Act::App(AppAct::CopyLink)));
    assert!(allow(fixed, &Act::Cook(CookAct::Restart)), "it begins again");
    for act in [AppAct::CopyLink, AppAct::ChooseFile, AppAct::Open(Card::Lessons)].map(Act::App) {
        assert!(!allow(fixed, &act), "{act:?}");
    }
    for act in [CookAct::Play("rare".into()), CookAct::SetOut(1)].map(Act::Cook) {
        assert!(!allow(fixed, &act), "{act:?}");
    }
}
