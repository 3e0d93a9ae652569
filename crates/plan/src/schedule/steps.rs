//! The steps of a plan in the order of a cook's hands.

use crate::schedule::{Cue, Plan};

/// One step of a plan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Time since the hob was switched on [s].
    pub at_s: u32,
    /// What is done.
    pub deed: Deed,
}

/// What is done at a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Deed {
    /// The hob is set to a power [W].
    Power(f64),
    /// The food goes into the pan.
    Put,
    /// The food is turned over, for the nth time.
    Flip(usize),
    /// The food comes out of the pan, and the hob is switched off.
    Pull,
    /// The rest is over.
    Serve,
}

impl Plan {
    /// Returns the steps, in order.
    pub fn steps(&self) -> Vec<Step> {
        let schedule = &self.schedule;
        let mut steps = vec![Step { at_s: schedule.put_s, deed: Deed::Put }];
        steps.extend(schedule.powers.iter().map(|p| Step { at_s: p.at_s, deed: Deed::Power(p.hob_w) }));
        let flips = schedule.flips_s.iter().enumerate();
        steps.extend(flips.map(|(index, at_s)| Step { at_s: *at_s, deed: Deed::Flip(index + 1) }));
        steps.push(Step { at_s: schedule.pull_s, deed: Deed::Pull });
        steps.push(Step { at_s: schedule.pull_s + schedule.rest_s, deed: Deed::Serve });
        // The sort is stable: as in the recipe, the food goes in before the power changes.
        steps.sort_by_key(|step| step.at_s);
        steps
    }

    /// Returns what there was in the planned cook when a step came; none of a step at which nobody looks.
    pub fn cue(&self, step: &Step) -> Option<&Cue> {
        let has_cue = matches!(step.deed, Deed::Put | Deed::Flip(_) | Deed::Pull);
        self.cues.iter().find(|cue| has_cue && cue.at_s == step.at_s)
    }
}
