//! Promise: whoever presses the button of the line that states what to do, some seconds after it is lit and whatever its words are, meets the
//! goal at the first try, with a screen reader's press or with the keyboard alone.
//!
//! Every run presses after 10 s of wall time, by its own clock; `SAUTE_NOW=all`, as in the campaign, cooks four pans, three
//! steaks and three classes with hands that are 2, 5, 10 and 20 s late, and requires 95 of 100.

use egui::accesskit::{Action, ActionRequest, NodeId, Role, TreeId, TreeUpdate};
use egui::{Context, Event, Key, Modifiers, RawInput};
use saute_controls::act::{Act, AppAct, CookAct, Setting};
use saute_controls::goal_choice::goal_of;
use saute_kitchen::advice::class_goal;
use saute_kitchen::{Place, TICK_S};
use saute_plan::goal::GoalVerdict;
use saute_session::FoodChoice;
use saute_window::{SauteApp, Start};

/// Time from look to look, at the speed of real time, and of a frame [wall s]: what is between is cooked without frames, so that
/// no machine is too slow for it.
const LOOK_S: f64 = 1.0;
const FRAME_S: f64 = 0.001;
/// How far a core cools before it counts as rested [K].
const RESTED_K: f64 = 0.35;
/// Share of the cooks that must meet their goal [%].
const ENOUGH_PCT: usize = 95;

/// A window without a picture, whose line is read from its words for those who do not see it.
struct Cook {
    app: SauteApp,
    ctx: Context,
    now_s: f64,
    looked_s: f64,
    events: Vec<Event>,
    orders: usize,
    by: Hand,
}

/// How the button is pressed.
#[derive(Clone, Copy, PartialEq)]
enum Hand {
    /// As a screen reader does it.
    Reader,
    /// By Tab and Space.
    Keyboard,
}

/// Presses of Tab that reach every control of the window from any other [-] (chosen: far more than there are).
const MOST_TABS: usize = 100;

/// What the line requests: the button and what it is called.
type Lit = (NodeId, String);

impl Cook {
    /// A visit of somebody about whom this is stored.
    fn visit(stored: Option<String>, by: Hand) -> Self {
        let ctx = Context::default();
        ctx.enable_accesskit();
        let app = SauteApp::start(&ctx, None, stored, Start::default()).expect("starts");
        Self { app, ctx, now_s: 0.0, looked_s: 0.0, events: Vec::new(), orders: 0, by }
    }

    fn begin(pan: &str, mm: f64, class: usize) -> Self {
        let mut cook = Self::visit(None, Hand::Reader);
        let choice = FoodChoice { pan: pan.to_owned(), size_mm: vec![120.0, 80.0, mm], ..FoodChoice::default() };
        cook.act(Act::App(AppAct::Set(Setting::Choice(choice))));
        cook.act(Act::Cook(CookAct::SetOut(1)));
        let goal = class_goal(&cook.app.scale().expect("a scale"), class);
        cook.act(Act::App(AppAct::Set(Setting::Goal(goal))));
        cook
    }

    fn act(&mut self, act: Act) {
        let ctx = self.ctx.clone();
        self.app.act(act, &ctx);
    }

    /// Draws a frame; returns what the line requests.
    fn frame(&mut self) -> Option<Lit> {
        self.looked_s += LOOK_S;
        (0..(LOOK_S / TICK_S) as usize).for_each(|_| self.app.session_mut().tick().expect("ticks"));
        lit(&self.drawn()?)
    }

    /// Draws a frame in which next to no time passes; returns what is there for those who do not see it.
    fn drawn(&mut self) -> Option<TreeUpdate> {
        self.now_s += FRAME_S;
        let events = std::mem::take(&mut self.events);
        let input = RawInput { time: Some(self.now_s), events, ..RawInput::default() };
        let output = self.ctx.clone().run_ui(input, |ui| self.app.frame(ui));
        output.platform_output.accesskit_update
    }

    fn press(&mut self, button: NodeId) {
        match self.by {
            Hand::Reader => {
                let target_tree = TreeId::ROOT;
                let request = ActionRequest { action: Action::Click, target_tree, target_node: button, data: None };
                self.events.push(Event::AccessKitActionRequest(request));
            }
            Hand::Keyboard => {
                self.tab_to(button);
                self.strike(Key::Space);
            }
        }
    }

    /// Moves the focus to a control by Tab alone.
    fn tab_to(&mut self, control: NodeId) {
        for _ in 0..MOST_TABS {
            if self.drawn().is_some_and(|update| update.focus == control) {
                return;
            }
            self.strike(Key::Tab);
        }
        panic!("{MOST_TABS} presses of Tab do not reach it: {:?}", self.drawn().map(|update| update.focus));
    }

    /// Presses a key and lets go of it.
    fn strike(&mut self, key: Key) {
        for pressed in [true, false] {
            let modifiers = Modifiers::NONE;
            self.events.push(Event::Key { key, physical_key: None, pressed, repeat: false, modifiers });
            self.drawn();
        }
    }

    /// Presses the button of the line, each time that it has been lit for `late_s`, until the food has rested.
    fn press_when_lit(&mut self, late_s: f64) {
        let mut since: Option<(String, f64)> = None;
        while !self.has_rested() {
            let asked = self.frame();
            assert!(self.app.session().kitchen.time_s() < 3600.0, "it leads nowhere: {asked:?}");
            let Some((button, label)) = asked else {
                since = None;
                continue;
            };
            let seen_s = match &since {
                Some((before, at_s)) if *before == label => *at_s,
                _ => self.looked_s,
            };
            since = Some((label, seen_s));
            if self.looked_s - seen_s >= late_s {
                (self.orders, since) = (self.orders + 1, None);
                self.press(button);
            }
        }
    }

    fn has_rested(&self) -> bool {
        self.app
            .session()
            .shown_piece()
            .is_some_and(|steak| matches!(steak.place, Place::Rest(_)) && steak.core() < steak.core_peak.0 - RESTED_K)
    }
}

/// The button with a label.
fn button(update: &TreeUpdate, label: &str) -> Option<NodeId> {
    let is_it = |node: &egui::accesskit::Node| node.role() == Role::Button && node.label() == Some(label);
    update.nodes.iter().find(|(_, node)| is_it(node)).map(|(id, _)| *id)
}

/// The button of the line, where it requests something.
fn lit(update: &TreeUpdate) -> Option<Lit> {
    let asks = |label: &str| {
        (label.starts_with("As advised: ") && !label.ends_with("Result")) || label == "Take it out: the goal is reached"
    };
    let buttons = update.nodes.iter().filter(|(_, node)| node.role() == Role::Button);
    let mut lit = buttons.filter_map(|(id, node)| Some((*id, node.label().filter(|label| asks(label))?.to_owned())));
    let first = lit.next();
    assert!(lit.next().is_none(), "one button at most");
    first
}

/// Cooks by the line alone; returns why the goal was not met.
fn cooked(pan: &str, mm: f64, class: usize, late_s: f64) -> Result<(), String> {
    let mut cook = Cook::begin(pan, mm, class);
    cook.press_when_lit(late_s);
    let (session, settings) = (cook.app.session(), cook.app.settings());
    let goal = goal_of(session, settings).expect("a goal");
    let judgement = session.judgement(&goal).expect("there is food");
    let outcome = judgement.outcome;
    println!(
        "{pan} {mm} mm {} {late_s} s late: {:?} in {:.0} s with {} presses, core {:.1} °C, crust {:.0} %, hottest {:.0} °C",
        goal.name,
        judgement.verdict,
        session.kitchen.time_s(),
        cook.orders,
        outcome.at_core,
        outcome.least_crust_pct,
        outcome.hottest_c
    );
    if judgement.verdict == GoalVerdict::Met { Ok(()) } else { Err(format!("{pan} {mm} mm {} {late_s}", goal.name)) }
}

#[test]
fn whoever_presses_the_lit_button_meets_the_goal() {
    let (pans, thick, classes, late): (&[&str], &[f64], &[usize], &[f64]) = if std::env::var_os("SAUTE_NOW").is_some() {
        let pans = &["carbon-steel-26", "cast-iron-26", "aluminium-26", "stainless-clad-26"];
        (pans, &[20.0, 25.0, 35.0], &[1, 2, 3], &[2.0, 5.0, 10.0, 20.0])
    } else {
        (&["cast-iron-26"], &[25.0], &[2], &[10.0])
    };
    let (mut all, mut missed) = (0, Vec::new());
    for (pan, mm, class) in
        pans.iter().flat_map(|p| thick.iter().flat_map(move |t| classes.iter().map(move |c| (p, t, c))))
    {
        for late_s in late {
            all += 1;
            missed.extend(cooked(pan, *mm, *class, *late_s).err());
        }
    }
    assert!(100 * (all - missed.len()) >= ENOUGH_PCT * all, "{} of {all} missed: {missed:?}", missed.len());
}

#[test]
fn the_keyboard_alone_cooks_a_first_steak() {
    let mut cook = Cook::visit(Some("{}".to_owned()), Hand::Keyboard);
    let begin = (0..10).find_map(|_| button(&cook.drawn()?, "Begin"));
    cook.press(begin.expect("the card of the first steps"));
    cook.press_when_lit(10.0);
    let (session, settings) = (cook.app.session(), cook.app.settings());
    let goal = goal_of(session, settings).expect("a goal");
    assert_eq!(session.judgement(&goal).expect("there is food").verdict, GoalVerdict::Met);
}
