//! The answer of the planner.

use crate::goal::{Outcome, Score, Shortfall};
use crate::schedule::{Cue, Order, Schedule, Sensitivity};

/// The best schedule that was found.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// What was ordered.
    pub order: Order,
    /// The schedule.
    pub schedule: Schedule,
    /// What the cook of its recipe gives on the full mesh, unless the plan is rough.
    pub promised: Outcome,
    /// The score of that.
    pub score: Score,
    /// What there is to see at each step: one for putting in, each flip, and pulling.
    pub cues: Vec<Cue>,
    /// What it gives if something is different.
    pub sensitivity: Vec<Sensitivity>,
    /// Number of candidates that were cooked [-].
    pub candidates: usize,
    /// True if the search was stopped before its end.
    pub is_stopped: bool,
    /// True if it was stopped before its finish: what is promised was cooked on coarse meshes.
    pub is_rough: bool,
}

impl Plan {
    /// Returns everything that is missing to the goal; nothing if it is met.
    pub fn shortfalls(&self) -> Vec<Shortfall> {
        Shortfall::of(&self.promised, &self.order.goal)
    }

    /// Returns the text of the recipe.
    pub fn recipe_text(&self) -> String {
        self.schedule.recipe_text(&self.order)
    }
}
