//! A plan that a person cooks: which steps are done, which is next, and how late each was.
//!
//! Steps keep their times whatever happens: a late one moves no other. Foods are counted, since each can go into the pan, be turned and
//! come out only once a step; a power counts for the first open step with about that power and is not far ahead. The step that takes
//! the food out also switches the hob off: it is done when both are.

use crate::schedule::{Deed, Plan, Step};

/// Something that a person did.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Done {
    /// When [s].
    pub at_s: f64,
    /// What.
    pub what: Hand,
}

/// What a hand can do for a plan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Hand {
    /// Set the hob to a power [W].
    Hob(f64),
    /// Let the hob hold a temperature.
    Hold,
    /// Put a piece into the pan.
    Put,
    /// Turned a piece over.
    Flip,
    /// Took a piece out of the pan.
    Out,
}

/// Status of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StepStatus {
    /// It was done, so much after its time; before it where negative [s].
    Done(f64),
    /// It was left out: a later one of its kind is done.
    LeftOut,
    /// It is due in so many seconds; negative once it is late [s].
    Open(f64),
}

/// What is left of an open step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Left {
    /// All of it.
    All,
    /// Food that is in the pan yet; the hob is off.
    Food,
    /// The hob, which is on yet; the food is out.
    Hob,
}

/// A step with its status.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Followed {
    /// The step.
    pub step: Step,
    /// Its status.
    pub standing: StepStatus,
    /// What is left of it while it is open.
    pub left: Left,
}

/// Powers closer than this to that of a step count, as a share and at least [W] (chosen: a slider is set by eye).
const NEAR_SHARE: f64 = 0.05;
const NEAR_W: f64 = 25.0;
/// A power counts for a step from this time before it on [s] (chosen: who turns the knob early means the next step, not the one after).
pub(super) const EARLY_S: f64 = 30.0;
/// From this much after its time a step is late, and before it early [s] (chosen: who looks up, reads and reaches for the pan needs
/// some seconds; people who pressed as soon as they saw "now" were told to be 5 s late).
pub const LATE_S: f64 = 6.0;

/// Returns the steps of a plan with their status at a time [s], given what was done for a number of pieces, in order.
pub fn follow(plan: &Plan, done: &[Done], pieces: usize, now_s: f64) -> Vec<Followed> {
    let (steps, pieces) = (plan.steps(), pieces.max(1));
    let times = done_times(&steps, done, pieces, now_s);
    let is_out = nth(done, Hand::Out, pieces).is_some();
    let standing = |(index, step): (usize, &Step)| {
        let at_s = f64::from(step.at_s);
        let is_later = |later: usize| match steps[later].deed {
            // The food decides, whatever the hob does.
            Deed::Pull => is_out && makes_needless(&Deed::Pull, &step.deed),
            deed => times[later].is_some() && makes_needless(&deed, &step.deed),
        };
        match times[index] {
            Some(done_s) => StepStatus::Done(done_s - at_s),
            None if (index + 1..steps.len()).any(is_later) => StepStatus::LeftOut,
            None => StepStatus::Open(at_s - now_s),
        }
    };
    let standings: Vec<StepStatus> = steps.iter().enumerate().map(standing).collect();
    let left = |step: &Step| match step.deed {
        Deed::Pull if is_out => Left::Hob,
        Deed::Pull if !is_heating(done) => Left::Food,
        _ => Left::All,
    };
    let followed = |(step, standing): (Step, StepStatus)| Followed { step, standing, left: left(&step) };
    steps.into_iter().zip(standings).map(followed).collect()
}

/// When something was done for the nth time [s].
fn nth(done: &[Done], what: Hand, count: usize) -> Option<f64> {
    done.iter().filter(|d| d.what == what).nth(count - 1).map(|d| d.at_s)
}

/// True if the hob is on after all that was done.
fn is_heating(done: &[Done]) -> bool {
    done.iter().rev().find_map(|d| heats(d.what)).unwrap_or(false)
}

/// Whether a deed leaves the hob on; none if it has nothing to do with the hob.
fn heats(what: Hand) -> Option<bool> {
    match what {
        Hand::Hob(w) => Some(w > 0.0),
        Hand::Hold => Some(true),
        Hand::Put | Hand::Flip | Hand::Out => None,
    }
}

/// When all pieces were out and the hob was off for the first time [s].
fn ended_s(done: &[Done], pieces: usize) -> Option<f64> {
    let is_end = |count: &usize| nth(&done[..*count], Hand::Out, pieces).is_some() && !is_heating(&done[..*count]);
    (1..=done.len()).find(is_end).map(|count| done[count - 1].at_s)
}

/// When each step was done [s].
fn done_times(steps: &[Step], done: &[Done], pieces: usize, now_s: f64) -> Vec<Option<f64>> {
    let mut powers = done.iter().filter_map(|d| if let Hand::Hob(w) = d.what { Some((d.at_s, w)) } else { None });
    let mut power = |step: &Step, wanted: f64| {
        let from_s = f64::from(step.at_s) - EARLY_S;
        let mut ahead = powers.clone();
        let found = ahead.find(|(at_s, w)| *at_s >= from_s && is_near(*w, wanted))?;
        powers = ahead;
        Some(found.0)
    };
    let time = |step: &Step| match step.deed {
        Deed::Power(wanted) => power(step, wanted),
        Deed::Put => nth(done, Hand::Put, pieces),
        Deed::Flip(number) => nth(done, Hand::Flip, number * pieces),
        Deed::Pull => ended_s(done, pieces),
        Deed::Serve => Some(f64::from(step.at_s)).filter(|at_s| now_s >= *at_s),
    };
    steps.iter().map(time).collect()
}

pub(super) fn is_near(watt: f64, wanted: f64) -> bool {
    (watt - wanted).abs() <= (NEAR_SHARE * wanted).max(NEAR_W)
}

/// Powers follow each other, and what comes out is not turned over any more.
fn makes_needless(later: &Deed, earlier: &Deed) -> bool {
    match earlier {
        Deed::Power(_) => matches!(later, Deed::Power(_) | Deed::Pull),
        Deed::Flip(_) => matches!(later, Deed::Flip(_) | Deed::Pull),
        Deed::Put | Deed::Pull | Deed::Serve => false,
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
pub(super) mod tests {
    use saute_kitchen::Library;

    use super::*;
    use crate::goal::{Goal, Outcome, Score};
    use crate::schedule::{Order, Schedule, Setting};

    pub fn plan() -> Plan {
        let library = Library::embedded().unwrap();
        let power = |at_s, hob_w| Setting { at_s, hob_w };
        Plan {
            order: Order {
                food: "beef-lean".into(),
                size_mm: vec![120.0, 80.0, 25.0],
                initial_c: 5.0,
                count: None,
                hob: None,
                pan: "carbon-steel-26".into(),
                hob_w: vec![400.0, 1100.0, 2000.0],
                most_flips: 2,
                most_rest_s: None,
                pan_c: None,
                plain: false,
                goal: Goal::new(&"medium".parse().unwrap(), library.scale("chefs").unwrap(), 60.0).unwrap(),
            },
            schedule: Schedule {
                powers: vec![power(0, 2000.0), power(60, 1100.0), power(100, 400.0)],
                put_s: 60,
                flips_s: vec![160, 260],
                pull_s: 400,
                rest_s: 120,
            },
            promised: Outcome::default(),
            score: Score(0.0),
            cues: Vec::new(),
            sensitivity: Vec::new(),
            candidates: 1,
            is_stopped: false,
            is_rough: false,
        }
    }

    pub fn done(list: &[(f64, Hand)]) -> Vec<Done> {
        list.iter().map(|(at_s, what)| Done { at_s: *at_s, what: *what }).collect()
    }

    fn standings(list: &[(f64, Hand)], pieces: usize, now_s: f64) -> Vec<StepStatus> {
        follow(&plan(), &done(list), pieces, now_s).into_iter().map(|f| f.standing).collect()
    }

    /// Steps: 2000 W, put, 1100 W, 400 W, flip 1, flip 2, pull, serve.
    #[test]
    fn steps_are_done_early_or_late_and_no_other_step_moves() {
        use StepStatus::{Done, Open};
        let list = [(0.0, Hand::Hob(2000.0)), (72.0, Hand::Put), (58.0, Hand::Hob(1080.0)), (105.0, Hand::Hob(400.0))];
        assert_eq!(
            standings(&list, 1, 120.0),
            [Done(0.0), Done(12.0), Done(-2.0), Done(5.0), Open(40.0), Open(140.0), Open(280.0), Open(400.0)]
        );
    }

    #[test]
    fn a_power_that_is_passed_on_the_way_counts_for_no_step_far_ahead() {
        let list = [(0.0, Hand::Hob(400.0)), (1.0, Hand::Hob(1100.0)), (2.0, Hand::Hob(2000.0))];
        assert_eq!(
            standings(&list, 1, 10.0)[..4],
            [StepStatus::Done(2.0), StepStatus::Open(50.0), StepStatus::Open(50.0), StepStatus::Open(90.0)]
        );
    }

    #[test]
    fn a_step_that_a_later_one_makes_needless_is_left_out() {
        let list = [(60.0, Hand::Put), (165.0, Hand::Flip), (380.0, Hand::Out)];
        let standings = standings(&list, 1, 390.0);
        assert_eq!(standings[5..7], [StepStatus::LeftOut, StepStatus::Done(-20.0)]);
        assert_eq!(standings[0], StepStatus::LeftOut, "the hob does not matter any more");
    }

    #[test]
    fn a_group_is_turned_when_each_of_its_pieces_is() {
        let flips = [(60.0, Hand::Put), (62.0, Hand::Put), (160.0, Hand::Flip), (163.0, Hand::Flip)];
        assert_eq!(standings(&flips, 2, 170.0)[4], StepStatus::Done(3.0));
        assert_eq!(standings(&flips[..3], 2, 170.0)[4], StepStatus::Open(-10.0));
    }

    #[test]
    fn the_end_is_done_when_the_food_is_out_and_the_hob_is_off_and_says_what_is_left() {
        let on = (100.0, Hand::Hob(400.0));
        let of = |list: &[(f64, Hand)]| {
            let followed = follow(&plan(), &done(list), 1, 420.0)[6];
            (followed.standing, followed.left)
        };
        assert_eq!(of(&[on]), (StepStatus::Open(-20.0), Left::All));
        assert_eq!(of(&[on, (400.0, Hand::Out)]), (StepStatus::Open(-20.0), Left::Hob));
        assert_eq!(of(&[on, (390.0, Hand::Hob(0.0))]), (StepStatus::Open(-20.0), Left::Food));
        let both = [on, (400.0, Hand::Out), (405.0, Hand::Hob(0.0)), (410.0, Hand::Hob(400.0))];
        assert_eq!(of(&both).0, StepStatus::Done(5.0), "what is done stays done");
        let early = [on, (300.0, Hand::Out)];
        assert_eq!(standings(&early, 1, 310.0)[4..6], [StepStatus::LeftOut; 2], "nothing is left to flip");
    }
}
