//! The state of a runner apart from its recipe, to be handed to another program.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::cook::repeating::Repeating;
use crate::cook::runner::{Runner, StoppedBy};
use crate::cook::watch::Watch;
use crate::recipe::Recipe;

/// How far a runner is in its recipe.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct RunnerState {
    next: usize,
    begun: bool,
    ready_at: f64,
    armed: Option<Watch>,
    repeating: Option<Repeating>,
    warnings: Vec<String>,
    stopped: Option<StoppedBy>,
}

impl Runner {
    /// Returns how far it is in its recipe.
    pub fn state(&self) -> RunnerState {
        let Self { next, begun, ready_at, stopped, .. } = *self;
        let Self { armed, repeating, warnings, .. } = self.clone();
        RunnerState { next, begun, ready_at, armed, repeating, warnings, stopped }
    }

    /// Returns a runner that goes on from a state in the same recipe.
    pub fn resumed(recipe: Arc<Recipe>, state: RunnerState) -> Self {
        let RunnerState { next, begun, ready_at, armed, repeating, warnings, stopped } = state;
        Self { recipe, next, begun, ready_at, armed, repeating, warnings, stopped }
    }
}
