//! Promise: a search for a plan shows how far it is, can be stopped and then keeps the best so far, and finds off the frame what it finds
//! in a plain loop.

use std::sync::Arc;

use egui_kittest::kittest::Queryable;
use saute_controls::act::{Act, AppAct, Card, LearnAct};
use saute_controls::plan::PlanAct;
use saute_kitchen::Library;
use saute_plan::schedule::asked::Asked;
use saute_plan::schedule::search::{PlanData, SearchProgress};
use saute_plan::schedule::{Plan, Planner, Stage};
use saute_session::plan::job::{PlanAnswer, PlanOrder, PlanProgress, Reply};
use saute_session::plan::planning::Planning;
use saute_session::work::executor::Executor;
use saute_session::work::{Agency, Helper, WorkKind};

use super::plan::{PHONE, WIDE, act, plan};
use crate::harness::{save, steps, window};

#[test]
fn a_search_shows_its_progress_and_can_be_cancelled() {
    let mut harness = window(WIDE);
    act(&mut harness, Act::App(AppAct::Open(Card::Plan)));
    act(&mut harness, Act::Learn(LearnAct::Plan(PlanAct::Find)));
    harness.get_by_label_contains("Search: ");
    save(&mut harness, "plan-searching");
    harness.get_by_label("Cancel").click();
    steps(&mut harness, 3);
    assert!(harness.query_by_label("Cancel").is_none());
    harness.get_by_label("Find a plan");
}

/// An agency whose search never ends, and has one plan so far.
struct HalfWay(Plan);

struct HalfWayHelper(Plan, Option<u64>);

impl Agency for HalfWay {
    fn hire(&self, _: WorkKind, _: &Arc<Library>) -> Box<dyn Helper> {
        Box::new(HalfWayHelper(self.0.clone(), None))
    }
}

impl Helper for HalfWayHelper {
    fn ask(&mut self, order: Vec<u8>) {
        self.1 = postcard::from_bytes::<PlanOrder>(&order).ok().map(|order| order.number);
    }

    fn answers(&mut self) -> Option<Vec<Vec<u8>>> {
        let search = SearchProgress { candidates: 12, share: 0.4, stage: Stage::Refine(0) };
        let progress = |number| PlanAnswer {
            number,
            reply: Reply::Progress(PlanProgress { search, so_far: Some(Box::new(PlanData::from(&self.0))) }),
        };
        Some(self.1.iter().map(|number| postcard::to_allocvec(&progress(*number)).expect("bytes")).collect())
    }
}

#[test]
fn a_search_that_is_stopped_keeps_the_best_so_far_and_says_that_it_is_rough() {
    let library = Library::embedded().expect("embedded data");
    let plan = Plan { is_stopped: true, is_rough: true, sensitivity: Vec::new(), ..plan(&library) };
    let mut harness = window(WIDE);
    harness.state_mut().employ(Box::new(HalfWay(plan)));
    act(&mut harness, Act::App(AppAct::Open(Card::Plan)));
    for (size, name) in [(WIDE, "wide"), (PHONE, "phone")] {
        harness.set_size(size);
        act(&mut harness, Act::Learn(LearnAct::Plan(PlanAct::Find)));
        harness.get_by_label_contains("Search: 40 %");
        harness.get_by_label("Stop, keep the best so far").click();
        steps(&mut harness, 3);
        harness.get_by_label_contains("The search was stopped.");
        save(&mut harness, &format!("plan-stopped-{name}"));
        assert!(harness.query_by_label_contains("If something is different").is_none(), "nothing was varied");
    }
    harness.get_by_label("Cook it live").click();
    steps(&mut harness, 3);
    harness.get_by_label_contains("Step 1 of");
}

/// The kind of work does in slices, on threads, what a plain loop does.
#[test]
fn a_search_off_the_frame_finds_the_plan_of_a_plain_one() {
    let library = Arc::new(Library::embedded().expect("embedded data"));
    let asked = Asked {
        food: "shrimp".into(),
        size_mm: vec![60.0, 14.0],
        initial_c: 5.0,
        count: None,
        hob: None,
        pan: "carbon-steel-26".into(),
        hob_w: vec![900.0],
        most_flips: 1,
        plain: false,
        target: "opaque".into(),
        scale: "shrimp".into(),
        crust_pct: 0.0,
    };
    let mut planning = Planning::default();
    planning.ask(asked.clone(), None, Some(Box::new(AtOnce(Executor::new(WorkKind::Plan, Arc::clone(&library))))));
    while planning.is_searching() {
        planning.take_answers(&library);
    }
    let mut planner = Planner::new(asked.order(&library).expect("an order"), Arc::clone(&library)).expect("begins");
    while planner.plan().is_none() {
        let results = planner.next_jobs().iter().map(|job| job.run(&library).expect("cooks")).collect();
        planner.take(results);
    }
    assert_eq!(planning.plan(), planner.plan().as_ref());
}

struct AtOnce(Executor);

impl Helper for AtOnce {
    fn ask(&mut self, order: Vec<u8>) {
        self.0.take(&order);
    }

    fn answers(&mut self) -> Option<Vec<Vec<u8>>> {
        Some(self.0.go_on(std::time::Duration::from_millis(20)).into_iter().collect())
    }
}
