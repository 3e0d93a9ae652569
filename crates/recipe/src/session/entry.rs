//! One entry of a recording.

use saute_kitchen::bytes::Models;
use saute_kitchen::{Command, FRAME_S, Kitchen, Library, PieceOrder};
use serde::{Deserialize, Serialize};

use crate::action::Action;
use crate::cook::step_record::StepRecord;
use crate::session::playhead::DepartureCause;

/// What happened between two frames, other than the recipe's own steps.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// Frames since the start.
    pub frame: u64,
    /// True if it happened after the recipe's steps that were due at this frame.
    pub after_steps: bool,
    /// What happened.
    pub deed: Deed,
}

/// What a person or a device did.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub enum Deed {
    /// The recipe was stopped: a person took over.
    TakeOver,
    /// A command that the kitchen carried out.
    Command(Command),
    /// Food that was added.
    Add(PieceOrder),
    /// A piece that was removed, by its name.
    Remove(String),
    /// The recipe goes on after a person had taken over.
    Resume,
}

impl Entry {
    /// Time of the entry [s].
    pub fn time_s(&self) -> f64 {
        self.frame as f64 * FRAME_S
    }

    /// Returns a command as the step of a recipe; none for what no recipe can state.
    pub fn as_step(&self) -> Option<StepRecord> {
        let Deed::Command(command) = &self.deed else { return None };
        let action = Action::of_command(command)?;
        let foods = action.target().map(|target| target.foods.clone()).unwrap_or_default();
        Some(StepRecord::new(action, foods, self.time_s()))
    }
}

impl Deed {
    /// Does it in a kitchen, with known models, to which one that had to be built is added. Whether a recipe plays is its owner's
    /// matter.
    ///
    /// # Errors
    ///
    /// If the kitchen refuses it, or if a food cannot be built.
    pub fn carry_out(
        &self,
        kitchen: &mut Kitchen,
        library: &Library,
        models: &mut Models,
    ) -> Result<(), DepartureCause> {
        match self {
            Self::TakeOver | Self::Resume => Ok(()),
            Self::Command(command) => kitchen.apply(command).map_err(DepartureCause::Refused),
            Self::Add(order) => kitchen.add_with(library, order, models).map_err(DepartureCause::Setup),
            Self::Remove(food) => {
                kitchen.remove(food);
                Ok(())
            }
        }
    }

    /// Returns true for one of the many poses by which a hand moves pan or tool.
    pub fn is_pose(&self) -> bool {
        matches!(self, Self::Command(Command::HoldPan { .. } | Command::Lead { .. }))
    }
}
