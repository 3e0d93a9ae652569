//! Which advice is shown while a person cooks a plan: the guide alone while the plan is kept to, the advice again once it is not.
//!
//! Advice uses the readings of the present, not the plan: its orders (other powers, take it out now) contradict the plan's steps a
//! little early or late. While the plan is kept to, only its texts without an order are left, and danger.

use saute_kitchen::advice::Advice;

use crate::goal::score::HOT_C;
use crate::schedule::follow::{Done, EARLY_S, Followed, Hand, StepStatus, is_near};
use crate::schedule::{Deed, Plan};

/// From this much after its time a step that is not done counts as left [s] (chosen: a minute of a steak is a flip; a quarter of it is no
/// hand that hesitates).
pub const LEFT_S: f64 = 15.0;

/// How a person follows a plan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Keeping {
    /// The plan is kept to.
    Kept,
    /// A step is long due.
    Missed(Deed),
    /// The hob has long had another power than this one [W].
    OtherPower(f64),
}

impl Keeping {
    /// Returns how a person follows a plan at a time [s], given its steps with their status and what was done, in order.
    pub fn of(plan: &Plan, steps: &[Followed], done: &[Done], now_s: f64) -> Self {
        let late = |f: &&Followed| matches!(f.standing, StepStatus::Open(in_s) if in_s <= -LEFT_S);
        if let Some(missed) = steps.iter().find(late) {
            return Self::Missed(missed.step.deed);
        }
        let is_over = steps.iter().any(|f| f.step.deed == Deed::Pull && !matches!(f.standing, StepStatus::Open(_)));
        match other_power(plan, done, now_s).filter(|_| !is_over) {
            Some(wanted) => Self::OtherPower(wanted),
            None => Self::Kept,
        }
    }

    /// Returns what is left of advice, next to the guide of the plan: everything once the plan is not kept to, else no order but those
    /// that avert danger.
    pub fn leaves(self, advice: &[Advice]) -> Vec<Advice> {
        let is_left = |one: &&Advice| self != Self::Kept || !one.is_due() || is_danger(one);
        advice.iter().filter(is_left).copied().collect()
    }
}

/// Oil near its flash point: no plan goes there.
fn is_danger(advice: &Advice) -> bool {
    matches!(advice, Advice::TooHot { hottest_c, .. } if *hottest_c > HOT_C)
}

/// The power that a plan requires, where the hob has long had another one [W].
fn other_power(plan: &Plan, done: &[Done], now_s: f64) -> Option<f64> {
    let (set_s, set) = done.iter().rev().find_map(|d| match d.what {
        Hand::Hob(w) => Some((d.at_s, Some(w))),
        Hand::Hold => Some((d.at_s, None)),
        Hand::Put | Hand::Flip | Hand::Out => None,
    })?;
    let powers = &plan.schedule.powers;
    let wanted = powers.iter().rfind(|power| f64::from(power.at_s) <= now_s)?;
    let is_next = |at_s: u32| f64::from(at_s) > now_s && f64::from(at_s) <= now_s + EARLY_S;
    let near = |wanted: f64| set.is_some_and(|set| is_near(set, wanted));
    let fits = near(wanted.hob_w) || powers.iter().any(|power| is_next(power.at_s) && near(power.hob_w));
    let since_s = set_s.max(f64::from(wanted.at_s));
    (!fits && now_s - since_s >= LEFT_S).then_some(wanted.hob_w)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::schedule::follow::follow;
    use crate::schedule::follow::tests::{done, plan};

    fn keeping(list: &[(f64, Hand)], now_s: f64) -> Keeping {
        let (plan, done) = (plan(), done(list));
        Keeping::of(&plan, &follow(&plan, &done, 1, now_s), &done, now_s)
    }

    const BEGUN: [(f64, Hand); 4] =
        [(0.0, Hand::Hob(2000.0)), (60.0, Hand::Put), (60.0, Hand::Hob(1100.0)), (100.0, Hand::Hob(400.0))];

    #[test]
    fn a_plan_is_kept_to_until_a_step_is_long_due() {
        assert_eq!(keeping(&BEGUN, 174.0), Keeping::Kept);
        assert_eq!(keeping(&BEGUN, 175.0), Keeping::Missed(Deed::Flip(1)));
        let flipped = [&BEGUN[..], &[(180.0, Hand::Flip)]].concat();
        assert_eq!(keeping(&flipped, 181.0), Keeping::Kept, "the guide speaks again once it is done");
    }

    #[test]
    fn another_power_leaves_the_plan_after_a_while_and_the_next_one_does_not() {
        let turned = |at_s, w| [&BEGUN[..], &[(at_s, Hand::Hob(w))]].concat();
        assert_eq!(keeping(&turned(110.0, 1100.0), 124.0), Keeping::Kept);
        assert_eq!(keeping(&turned(110.0, 1100.0), 125.0), Keeping::OtherPower(400.0));
        assert_eq!(keeping(&BEGUN[..3], 114.0), Keeping::Kept);
        assert_eq!(keeping(&BEGUN[..3], 115.0), Keeping::Missed(Deed::Power(400.0)));
        let early = [BEGUN[0], (40.0, Hand::Hob(1100.0))];
        assert_eq!(keeping(&early, 59.0), Keeping::Kept);
        let held = [&BEGUN[..], &[(105.0, Hand::Hold)]].concat();
        assert_eq!(keeping(&held, 140.0), Keeping::OtherPower(400.0));
        let ended = [&BEGUN[..], &[(105.0, Hand::Out), (105.0, Hand::Hob(0.0))]].concat();
        assert_eq!(keeping(&ended, 140.0), Keeping::Kept, "food that is out needs no power");
    }

    #[test]
    fn orders_are_left_to_the_guide_but_not_danger() {
        let take_out = Advice::TakeOut { peak_c: 61.0 };
        let waits = Advice::WouldPeak { peak_c: 50.0, wet: false };
        assert_eq!(Keeping::Kept.leaves(&[take_out, Advice::Flip, waits]), [waits]);
        assert_eq!(Keeping::Missed(Deed::Pull).leaves(&[take_out]), [take_out]);
    }
}
