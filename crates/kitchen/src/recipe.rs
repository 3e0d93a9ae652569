//! Recipes: checked, in SI units, ready to run.

use crate::command::Command;
use crate::input_error::{InputError, InputText};
use crate::kitchen::{Kitchen, PieceOrder, SetupError};
use crate::library::Library;
use crate::recipe_check::Check;

/// A recipe, checked.
#[derive(Clone, Debug, PartialEq)]
pub struct Recipe {
    /// Title for people.
    pub title: String,
    /// Where it stops if the steps have not ended it [s].
    pub max_s: f64,
    /// Id of the pan.
    pub pan_kind: String,
    /// Start temperature of the pan [K].
    pub pan_temperature: f64,
    /// Foods.
    pub foods: Vec<PieceOrder>,
    /// Steps, the last one ends the cook.
    pub steps: Vec<Step>,
    /// Name of its file, for messages.
    pub file: String,
    /// Its text.
    pub text: String,
}

/// One step.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// When.
    pub trigger: Trigger,
    /// What.
    pub action: Action,
    /// Line in the file.
    pub line: usize,
}

/// When a step fires.
#[derive(Clone, Debug, PartialEq)]
pub enum Trigger {
    /// At a time from the start [s].
    At(f64),
    /// This long after the end of the step before [s].
    After(f64),
    /// When the pan's floor crosses a temperature [K].
    Pan(f64),
    /// When a quantity of a food crosses a value.
    Food {
        /// Which food.
        food: String,
        /// Which quantity.
        quantity: Quantity,
        /// Value in SI units.
        value: f64,
    },
}

/// Quantities of a food that a condition may watch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Core temperature [K].
    Core,
    /// Mean of the upper face [K].
    Top,
    /// Mean of the lower face [K].
    Bottom,
    /// Mass [kg].
    Mass,
}

/// What a step does.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Gives the kitchen a command.
    Do(Command),
    /// Ends the cook.
    End,
}

impl Action {
    /// How long the action keeps the next step waiting [s].
    pub fn duration_s(&self) -> f64 {
        if let Self::Do(Command::Cool { for_s }) = self { *for_s } else { 0.0 }
    }
}

impl Recipe {
    /// Reads and checks a recipe. `file` is its name in messages.
    pub fn parse(text: &str, file: &str, library: &Library) -> Result<Self, InputError> {
        Check { input: InputText { text, file }, library }.recipe()
    }

    /// The kitchen in which the recipe starts.
    pub fn kitchen(&self, library: &Library) -> Result<Kitchen, SetupError> {
        let mut kitchen = Kitchen::new(library, &self.pan_kind, self.pan_temperature)?;
        for food in &self.foods {
            kitchen.add(library, food)?;
        }
        Ok(kitchen)
    }
}
