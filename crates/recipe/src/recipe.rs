//! Recipes: checked, in SI units, ready to run.

use std::ops::Range;

use crate::action::Action;
use crate::check::recipe_check::Check;
use saute_kitchen::data::library::Library;
use saute_kitchen::kitchen::{Kitchen, PieceOrder, SetupError};
use saute_kitchen::piece::piece_state::Piece;
use saute_kitchen::{InputError, InputText};

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
    /// Foods, the pieces of a group one after the other.
    pub foods: Vec<PieceOrder>,
    /// Groups of them.
    pub groups: Vec<Group>,
    /// Steps, the last one ends the cook.
    pub steps: Vec<Step>,
    /// Name of its file, for messages.
    pub file: String,
    /// Its text.
    pub text: String,
}

/// Several foods of one kind under one name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Group {
    /// Name in the recipe.
    pub id: String,
    /// Kind of food.
    pub kind: String,
    /// Which of the recipe's foods.
    pub members: Range<usize>,
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
    /// When a quantity of a food has crossed a value since the step was armed; of several foods, when the last of them has.
    Food {
        /// Which foods.
        food: Target,
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

impl Quantity {
    /// Its value for a piece [K, kg].
    pub fn of(self, piece: &Piece) -> f64 {
        match self {
            Self::Core => piece.core(),
            Self::Top => piece.face(false),
            Self::Bottom => piece.face(true),
            Self::Mass => piece.mass(),
        }
    }
}

/// Name that stands for all foods of a recipe.
pub const ALL: &str = "all";

/// Whom an action or a condition concerns.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Target {
    /// As the recipe names it: a food, a group, or [`ALL`].
    pub name: String,
    /// The foods that it stands for.
    pub foods: Vec<String>,
    /// Whether it is a group or [`ALL`]: then foods that an action cannot concern are passed over.
    pub group: bool,
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
