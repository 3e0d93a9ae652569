//! A cook that follows a plan, with a person who does the steps.

use saute_kitchen::{Command, Place};
use saute_plan::goal::{Goal, Judgement, Outcome};
use saute_plan::schedule::follow::{Done, Followed, Hand, StepStatus, follow};
use saute_plan::schedule::kept::Kept;
use saute_plan::schedule::voice::Keeping;
use saute_plan::schedule::{Deed, Plan};
use saute_recipe::recorder::Laid;
use saute_recipe::session::{Deed as Recorded, Entry};

use crate::Session;
use crate::easing::Easing;
use crate::hands::Hands;

/// From this time before a step on time does not run fast any more [s] (chosen: it takes a moment to look up).
pub const READY_S: f64 = 10.0;
/// Time before a step at which the clock falls back to real time [s] (chosen: time to look up).
const LEAD_S: f64 = 6.0;

/// A cook that follows a plan.
#[derive(Clone, Debug)]
pub struct Live {
    plan: Plan,
    /// Text of the recipe that the cook begins with.
    text: String,
    /// Masses of the pieces at the start [kg].
    masses: Vec<f64>,
    /// What the cook gave, at the time at which that was read [s].
    gave: Option<(f64, Outcome)>,
    /// True if the plan cooks itself.
    plays: bool,
    /// Real time near a step.
    easing: Easing,
    /// True once the person has closed the result at the end.
    is_closed: bool,
}

/// The guidance at an instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Guidance {
    /// All steps with their status.
    pub steps: Vec<Followed>,
    /// The steps that come next, which share a time.
    pub next: Vec<Followed>,
    /// The step that was done last, with how late it was [s].
    pub last: Option<(Deed, f64)>,
}

impl Guidance {
    /// In how many seconds the next step is due; negative once it is late [s].
    pub fn due_in_s(&self) -> Option<f64> {
        match self.next.first()?.standing {
            StepStatus::Open(in_s) => Some(in_s),
            StepStatus::Done(_) | StepStatus::LeftOut => None,
        }
    }

    /// Which of the plan's times comes next, from 1 on, and how many there are: steps that share a time count once.
    pub fn place(&self) -> [usize; 2] {
        let mut times: Vec<u32> = self.steps.iter().map(|f| f.step.at_s).collect();
        times.dedup();
        let next = self.next.first().and_then(|f| times.iter().position(|at_s| *at_s == f.step.at_s));
        [next.unwrap_or(times.len() - 1) + 1, times.len()]
    }
}

impl Live {
    /// Follows a plan in a session whose food was just set out for it.
    pub fn new(plan: Plan, session: &Session<impl Hands>) -> Self {
        let masses = session.kitchen.pieces().iter().map(saute_kitchen::Piece::mass).collect();
        let plays = session.recording().beginning().plays;
        let text = plan.recipe_text();
        Self { text, plan, masses, gave: None, plays, easing: Easing::default(), is_closed: false }
    }

    /// The plan.
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// Returns true if the session's cook is the one of the plan, with a person who follows it.
    pub fn is_of(&self, session: &Session<impl Hands>) -> bool {
        !self.plays && self.judges(session)
    }

    /// Returns true if the session's cook is the one of the plan, whoever cooks.
    pub fn judges(&self, session: &Session<impl Hands>) -> bool {
        let beginning = session.recording().beginning();
        beginning.plays == self.plays && beginning.text == self.text
    }

    /// Closes the result at the end; returns false if the cook is not over: then the guide ends.
    pub fn close(&mut self) -> bool {
        self.is_closed = self.gave.is_some();
        self.is_closed
    }

    /// Returns true once the result at the end is closed. The plan still judges the cook.
    pub fn is_closed(&self) -> bool {
        self.is_closed
    }

    /// The goal of the plan.
    pub fn goal(&self) -> &Goal {
        &self.plan.order.goal
    }

    /// Returns how well the plan was kept to, given what it gave.
    pub fn kept(&self, session: &Session<impl Hands>, judgement: &Judgement) -> Kept {
        let steps = (!self.plays).then(|| self.guidance(session).steps);
        Kept::of(&self.plan, steps.as_deref(), &judgement.outcome)
    }

    /// Returns how the person follows the plan now.
    pub fn keeping(&self, session: &Session<impl Hands>) -> Keeping {
        let (done, now_s) = (done_in(session), session.shown_s());
        let steps = follow(&self.plan, &done, self.masses.len(), now_s);
        Keeping::of(&self.plan, &steps, &done, now_s)
    }

    /// The speed to which time returns after the step that it waits for at real time [-]; none if it does not.
    pub fn returns_to(&self) -> Option<f64> {
        self.easing.left()
    }

    /// Time is to run fast up to the next step.
    pub fn hurries(&mut self, session: &Session<impl Hands>) {
        self.easing.hurry_from(session.speed);
    }

    /// The person has chosen a speed: it stays.
    pub fn keeps_speed(&mut self) {
        self.easing.forget();
    }

    /// Returns the guidance now.
    pub fn guidance(&self, session: &Session<impl Hands>) -> Guidance {
        let steps = follow(&self.plan, &done_in(session), self.masses.len(), session.shown_s());
        let first = steps.iter().find(|f| is_open(f)).map(|f| f.step.at_s);
        let next = steps.iter().copied().filter(|f| is_open(f) && Some(f.step.at_s) == first).collect();
        let done = |f: &Followed| match f.standing {
            StepStatus::Done(late_s) => Some((f.step, late_s)),
            StepStatus::Open(_) | StepStatus::LeftOut => None,
        };
        let when = |(step, late_s): &(saute_plan::schedule::Step, f64)| f64::from(step.at_s) + late_s;
        let last = steps.iter().filter_map(done).max_by(|a, b| when(a).total_cmp(&when(b)));
        Guidance { steps, next, last: last.map(|(step, late_s)| (step.deed, late_s)) }
    }

    /// Returns what the cook gave, once the rest is over.
    pub fn gave(&self) -> Option<&Outcome> {
        self.gave.as_ref().map(|(_, outcome)| outcome)
    }

    /// Looks after the clock: near a step it runs at real time, after it as before, and at the end it stops; reads what the cook gave.
    /// Returns true when the rest has just ended.
    pub fn look_after(&mut self, session: &mut Session<impl Hands>) -> bool {
        let guidance = self.guidance(session);
        let (now_s, is_over) = (session.shown_s(), guidance.next.is_empty());
        if !is_over {
            (self.gave, self.is_closed) = (None, false);
            self.keep_time(&guidance, session);
            return false;
        }
        if self.gave.is_some() {
            return false;
        }
        self.gave = Some((now_s, Outcome::read(&session.kitchen, &self.masses, self.goal())));
        session.set_paused(true);
        self.ease(false, session);
        true
    }

    /// Real time near a step, and the former speed after it unless another one was chosen.
    fn keep_time(&mut self, guidance: &Guidance, session: &mut Session<impl Hands>) {
        if let Some(in_s) = guidance.due_in_s() {
            self.ease(in_s < LEAD_S, session);
        }
    }

    fn ease(&mut self, is_near: bool, session: &mut Session<impl Hands>) {
        if let Some(speed) = self.easing.look(is_near, session.speed) {
            session.set_speed(speed);
        }
    }

    /// Returns the commands of the steps that come next, for the pieces that are there.
    pub fn commands(&self, session: &Session<impl Hands>) -> Vec<Command> {
        let guidance = self.guidance(session);
        guidance.next.iter().flat_map(|followed| commands_of(&followed.step.deed, session)).collect()
    }
}

fn is_open(followed: &Followed) -> bool {
    matches!(followed.standing, StepStatus::Open(_))
}

/// What was done in the cook up to the shown instant, in order.
fn done_in(session: &Session<impl Hands>) -> Vec<Done> {
    let mut done = done_by_commands(session);
    let turned = turned_by_hand(session);
    done.extend(turned.into_iter().map(|at_s| Done { at_s, what: Hand::Flip }));
    done.sort_by(|a, b| a.at_s.total_cmp(&b.at_s));
    done
}

/// When food was turned over without a command [s]: no flip of it was commanded since it was last turned.
fn turned_by_hand(session: &Session<impl Hands>) -> Vec<f64> {
    let turns = session.recorder.turns();
    let entries = session.recording().entries();
    let by_hand = |turn: &Laid| {
        let earlier = turns.clone().rfind(|other| other.food == turn.food && other.at_s < turn.at_s);
        let before_s = earlier.map_or(0.0, |earlier| earlier.at_s);
        let asks = |entry: &Entry| match &entry.deed {
            Recorded::Command(Command::Flip { food }) => {
                *food == turn.food && (before_s..=turn.at_s).contains(&entry.time_s())
            }
            _ => false,
        };
        (!entries.iter().any(asks)).then_some(turn.at_s)
    };
    turns.clone().filter_map(by_hand).collect()
}

fn done_by_commands(session: &Session<impl Hands>) -> Vec<Done> {
    let hand = |command: &Command| match command {
        Command::Hob(w) => Some(Hand::Hob(*w)),
        Command::HobHold { .. } => Some(Hand::Hold),
        Command::Put { .. } => Some(Hand::Put),
        Command::Flip { .. } => Some(Hand::Flip),
        Command::Rest { .. } => Some(Hand::Out),
        _ => None,
    };
    let entries = session.recording().entries().iter();
    let done = entries.filter_map(|entry| match &entry.deed {
        Recorded::Command(command) => Some(Done { at_s: entry.time_s(), what: hand(command)? }),
        _ => None,
    });
    done.collect()
}

fn commands_of(deed: &Deed, session: &Session<impl Hands>) -> Vec<Command> {
    let kitchen = &session.kitchen;
    let ids = |meant: fn(&saute_kitchen::Piece) -> bool| -> Vec<String> {
        kitchen.pieces().iter().filter(|p| meant(p)).map(|p| p.id.clone()).collect()
    };
    let in_pan = || ids(saute_kitchen::Piece::in_pan);
    match deed {
        Deed::Power(w) => vec![Command::Hob(*w)],
        Deed::Put => {
            let waiting = ids(|p| p.place == Place::Waiting);
            let places = kitchen.free_places(&waiting, [0.0, 0.0]);
            waiting.into_iter().zip(places).map(|(food, at)| Command::Put { food, at, heap: false }).collect()
        }
        Deed::Flip(_) => in_pan().into_iter().map(|food| Command::Flip { food }).collect(),
        Deed::Pull => {
            let rests = in_pan().into_iter();
            let on = saute_kitchen::RestOn::Board;
            let off = (kitchen.hob_w() > 0.0).then_some(Command::Hob(0.0));
            rests.map(|food| Command::Rest { food, on }).chain(off).collect()
        }
        Deed::Serve => Vec::new(),
    }
}
