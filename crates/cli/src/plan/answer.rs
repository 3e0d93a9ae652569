//! The plan as `saute plan --json` prints it.

use std::time::Duration;

use saute_plan::goal::{Outcome, Score, Shortfall};
use saute_plan::schedule::{Cue, Plan, Schedule, Sensitivity};
use serde::Serialize;

/// The plan as JSON.
#[derive(Debug, Serialize)]
pub struct PlanReport<'a> {
    target: Target<'a>,
    is_met: bool,
    missing: Vec<Shortfall>,
    schedule: &'a Schedule,
    /// What the cook of the recipe gives, on the mesh of `saute cook`.
    promised: Outcome,
    score: Score,
    cues: &'a [Cue],
    sensitivity: Vec<Changed<'a>>,
    candidates: usize,
    /// True if the search was stopped before its end.
    is_stopped: bool,
    /// True if it was stopped before its finish: what is promised was cooked on coarse meshes.
    is_rough: bool,
    recipe: String,
    wall_s: f64,
}

/// What was requested.
#[derive(Debug, Serialize)]
struct Target<'a> {
    name: &'a str,
    scale: &'a str,
    /// Value of the core that is aimed at, in the unit of the scale.
    aim: f64,
    unit: &'static str,
    crust_pct: f64,
}

/// What comes of a change.
#[derive(Debug, Serialize)]
struct Changed<'a> {
    words: String,
    is_met: bool,
    #[serde(flatten)]
    sensitivity: &'a Sensitivity,
}

impl<'a> PlanReport<'a> {
    /// Returns the answer of a plan that took some time.
    pub fn new(plan: &'a Plan, wall: Duration) -> Self {
        let goal = &plan.order.goal;
        let changed =
            |s: &'a Sensitivity| Changed { words: s.change.words(), is_met: s.missing.is_none(), sensitivity: s };
        Self {
            target: Target {
                name: &goal.name,
                scale: &goal.scale.id,
                aim: goal.aim,
                unit: goal.unit(),
                crust_pct: goal.crust_pct,
            },
            is_met: plan.shortfalls().is_empty(),
            missing: plan.shortfalls(),
            schedule: &plan.schedule,
            promised: plan.promised,
            score: plan.score,
            cues: &plan.cues,
            sensitivity: plan.sensitivity.iter().map(changed).collect(),
            candidates: plan.candidates,
            is_stopped: plan.is_stopped,
            is_rough: plan.is_rough,
            recipe: plan.recipe_text(),
            wall_s: wall.as_secs_f64(),
        }
    }
}
