//! How well a person kept to a plan in the end: what is reported of it in addition to the judgement.

use crate::goal::Outcome;
use crate::schedule::follow::{Followed, LATE_S, StepStatus};
use crate::schedule::{Deed, Plan};

/// How a cook of a plan went, measured by the plan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kept {
    /// It gave what was promised.
    AsPlanned,
    /// It did not, and this step was farthest off its time.
    OffTime {
        /// The step.
        deed: Deed,
        /// How late it was; negative if it was early; none if it was left out [s].
        late_s: Option<f64>,
    },
    /// It did not, though each step was done at its time: food, pan or start were others.
    Otherwise,
}

/// Core and shares within which a cook gave what was promised [K, points of %] (chosen: what 3 s of a hand make of a steak, and what a
/// probe errs).
const NEAR_K: f64 = 1.5;
const NEAR_PCT: f64 = 8.0;

impl Kept {
    /// Measures what a cook gave by the plan, given the steps with their status at the end; none where steps are not known.
    pub fn of(plan: &Plan, steps: Option<&[Followed]>, gave: &Outcome) -> Self {
        if is_as_promised(&plan.promised, gave) {
            return Self::AsPlanned;
        }
        let steps = steps.unwrap_or_default().iter().filter(|f| f.step.deed != Deed::Serve);
        let off = steps.filter_map(|f| match f.standing {
            StepStatus::Done(late_s) if late_s.abs() > LATE_S => Some((f.step.deed, Some(late_s))),
            StepStatus::Done(_) | StepStatus::Open(_) => None,
            StepStatus::LeftOut => Some((f.step.deed, None)),
        });
        // One that was left out is farther off than any other.
        let far = |late_s: Option<f64>| late_s.map_or(f64::INFINITY, f64::abs);
        let worst = off.max_by(|a, b| far(a.1).total_cmp(&far(b.1)));
        worst.map_or(Self::Otherwise, |(deed, late_s)| Self::OffTime { deed, late_s })
    }
}

fn is_as_promised(promised: &Outcome, gave: &Outcome) -> bool {
    let near = |of: fn(&Outcome) -> f64, most: f64| (of(gave) - of(promised)).abs() <= most;
    near(|o| o.core_peak_c, NEAR_K)
        && near(|o| o.target_share_pct, NEAR_PCT)
        && gave.least_crust_pct >= promised.least_crust_pct - NEAR_PCT
        && gave.charred_pct <= promised.charred_pct + NEAR_PCT
        && gave.fire_hazard <= promised.fire_hazard
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::schedule::follow::tests::{done, plan};
    use crate::schedule::follow::{Hand, follow};

    const PROMISED: Outcome = Outcome {
        core_peak_c: 61.5,
        at_core: 61.5,
        target_share_pct: 43.0,
        beyond_pct: 40.0,
        crust_pct: 70.0,
        least_crust_pct: 62.0,
        charred_pct: 0.0,
        lost_pct: 12.0,
        hottest_c: 250.0,
        fire_hazard: false,
    };

    #[test]
    fn what_was_promised_is_as_planned_and_what_was_not_names_the_step_that_was_farthest_off() {
        let plan = Plan { promised: PROMISED, ..plan() };
        let list = [(60.0, Hand::Put), (162.0, Hand::Flip), (290.0, Hand::Flip), (440.0, Hand::Out)];
        let steps = follow(&plan, &done(&list), 1, 600.0);
        let near = Outcome { core_peak_c: 62.5, ..PROMISED };
        assert_eq!(Kept::of(&plan, Some(&steps), &near), Kept::AsPlanned);
        let far = Outcome { core_peak_c: 68.0, ..PROMISED };
        let powers = [(0.0, Hand::Hob(2000.0)), (60.0, Hand::Hob(1100.0)), (100.0, Hand::Hob(400.0))];
        let off = [(440.0, Hand::Hob(0.0))];
        let all = [&powers[..1], &list[..1], &powers[1..], &list[1..], &off].concat();
        let steps = follow(&plan, &done(&all), 1, 600.0);
        let out = Kept::OffTime { deed: Deed::Pull, late_s: Some(40.0) };
        assert_eq!(Kept::of(&plan, Some(&steps), &far), out);
        assert_eq!(Kept::of(&plan, None, &far), Kept::Otherwise);
    }
}
