//! A cook that follows a plan, with a person who does the steps.

use saute_kitchen::{Command, Place};
use saute_plan::goal::Outcome;
use saute_plan::schedule::follow::{Done, Followed, Hand, Standing, follow};
use saute_plan::schedule::{Deed, Plan};
use saute_recipe::session::Deed as Recorded;

use crate::session::Session;

/// From this time before it on a step can be done by the button [s] (chosen: a hand that is ready needs no more).
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
}

/// What the guide says at an instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Guidance {
    /// All steps with how they stand.
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
            Standing::Open(in_s) => Some(in_s),
            Standing::Done(_) | Standing::LeftOut => None,
        }
    }

    /// Number of steps that are behind.
    pub fn behind(&self) -> usize {
        self.steps.iter().filter(|f| !is_open(f)).count()
    }
}

impl Live {
    /// Follows a plan in a session whose food was just set out for it.
    pub fn new(plan: Plan, session: &Session) -> Self {
        let masses = session.kitchen.pieces().iter().map(saute_kitchen::Piece::mass).collect();
        Self { text: plan.recipe_text(), plan, masses, gave: None }
    }

    /// The plan.
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// Returns true if the session's cook is the one that follows the plan.
    pub fn is_of(&self, session: &Session) -> bool {
        let beginning = session.recording().beginning();
        !beginning.plays && beginning.text == self.text
    }

    /// Returns what the guide says now.
    pub fn guidance(&self, session: &Session) -> Guidance {
        let steps = follow(&self.plan, &done_in(session), self.masses.len(), session.shown_s());
        let first = steps.iter().find(|f| is_open(f)).map(|f| f.step.at_s);
        let next = steps.iter().copied().filter(|f| is_open(f) && Some(f.step.at_s) == first).collect();
        let done = |f: &Followed| match f.standing {
            Standing::Done(late_s) => Some((f.step, late_s)),
            Standing::Open(_) | Standing::LeftOut => None,
        };
        let when = |(step, late_s): &(saute_plan::schedule::Step, f64)| f64::from(step.at_s) + late_s;
        let last = steps.iter().filter_map(done).max_by(|a, b| when(a).total_cmp(&when(b)));
        Guidance { steps, next, last: last.map(|(step, late_s)| (step.deed, late_s)) }
    }

    /// Returns what the cook gave, once the rest is over.
    pub fn gave(&self) -> Option<&Outcome> {
        self.gave.as_ref().map(|(_, outcome)| outcome)
    }

    /// Looks after the clock: near a step it runs at real time, and at the end it stops; reads what the cook gave.
    pub fn look_after(&mut self, session: &mut Session) {
        let guidance = self.guidance(session);
        if session.speed > 1.0 && guidance.due_in_s().is_some_and(|in_s| in_s < LEAD_S) {
            session.set_speed(1.0);
        }
        let (now_s, is_over) = (session.shown_s(), guidance.next.is_empty());
        if !is_over {
            self.gave = None;
        } else if self.gave.is_none() {
            self.gave = Some((now_s, Outcome::read(&session.kitchen, &self.masses, &self.plan.order.goal)));
            session.set_paused(true);
        }
    }

    /// Returns the commands of the steps that come next, for the pieces that are there.
    pub fn commands(&self, session: &Session) -> Vec<Command> {
        let guidance = self.guidance(session);
        guidance.next.iter().flat_map(|followed| commands_of(&followed.step.deed, session)).collect()
    }
}

fn is_open(followed: &Followed) -> bool {
    matches!(followed.standing, Standing::Open(_))
}

/// What was done in the cook up to the shown instant.
fn done_in(session: &Session) -> Vec<Done> {
    let hand = |command: &Command| match command {
        Command::Hob(w) => Some(Hand::Hob(*w)),
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

fn commands_of(deed: &Deed, session: &Session) -> Vec<Command> {
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
            rests.map(|food| Command::Rest { food, on }).chain([Command::Hob(0.0)]).collect()
        }
        Deed::Serve => Vec::new(),
    }
}
