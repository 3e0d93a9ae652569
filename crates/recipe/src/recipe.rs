//! A checked recipe in SI units.

use std::borrow::Cow;
use std::ops::Range;

use crate::action::Action;
use crate::condition::Condition;
use saute_kitchen::bytes::Models;
use saute_kitchen::data::library::Library;
use saute_kitchen::kitchen::{Kitchen, PieceOrder, SetupError};
use saute_kitchen::piece::piece_state::Piece;
use saute_schema::LibraryError;

/// A checked recipe in SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct Recipe {
    /// Title.
    pub title: String,
    /// How long it takes, as its file states it [min].
    pub minutes: Option<f64>,
    /// Time at which the cook stops if no step has ended it [s].
    pub max_s: f64,
    /// Id of the pan.
    pub pan_kind: String,
    /// Oil in the pan at the start [kg]; none if the recipe states none.
    pub oil: Option<f64>,
    /// Id of the hob; none for that of the kitchen at home.
    pub hob_kind: Option<String>,
    /// Initial temperature of the pan [K].
    pub pan_temperature: f64,
    /// Foods; the pieces of a group follow each other.
    pub foods: Vec<PieceOrder>,
    /// Groups of foods.
    pub groups: Vec<Group>,
    /// Steps; the last one ends the cook.
    pub steps: Vec<Step>,
    /// Name of the recipe's file, for messages.
    pub file: String,
    /// Text of the recipe's file.
    pub text: String,
}

/// Several pieces of one food under one name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Group {
    /// Id in the recipe.
    pub id: String,
    /// Id of the food's kind.
    pub kind: String,
    /// Indices into the recipe's foods.
    pub members: Range<usize>,
}

/// One step.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// Trigger.
    pub trigger: Trigger,
    /// Action.
    pub action: Action,
    /// Line in the file, from 1.
    pub line: usize,
}

/// The condition for a step to fire.
#[derive(Clone, Debug, PartialEq)]
pub enum Trigger {
    /// At a time since the start [s].
    At(f64),
    /// At a time since the end of the previous step [s].
    After(f64),
    /// Once a condition is true, at once if it is true already.
    When(Condition),
}

/// Quantities of a food that a condition can test.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Core temperature [K].
    Core,
    /// Mean temperature of the upper face [K].
    Top,
    /// Mean temperature of the lower face [K].
    Bottom,
    /// Mass [kg].
    Mass,
}

impl Quantity {
    /// Returns the key of the quantity in a recipe: `core_c`.
    pub fn key(self) -> &'static str {
        match self {
            Self::Core => "core_c",
            Self::Top => "top_c",
            Self::Bottom => "bottom_c",
            Self::Mass => "mass_g",
        }
    }

    /// Returns the quantity of a piece [K, kg].
    pub fn of(self, piece: &Piece) -> f64 {
        match self {
            Self::Core => piece.core(),
            Self::Top => piece.face(false),
            Self::Bottom => piece.face(true),
            Self::Mass => piece.mass(),
        }
    }
}

/// Name of the target that contains all foods of a recipe.
pub const ALL: &str = "all";

/// The foods of an action or of a condition.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Target {
    /// Name in the recipe: id of a food or a group, or [`ALL`].
    pub name: String,
    /// Ids of the foods.
    pub foods: Vec<String>,
    /// True for a group or [`ALL`]: an action then skips foods that do not meet its requirement.
    pub group: bool,
}

impl Recipe {
    /// Returns the library with the recipe's hob.
    ///
    /// # Errors
    ///
    /// If there is no such hob.
    pub fn library<'a>(&self, library: &'a Library) -> Result<Cow<'a, Library>, LibraryError> {
        self.hob_kind.as_ref().map_or(Ok(Cow::Borrowed(library)), |kind| library.on_hob(kind))
    }

    /// Returns a kitchen with the recipe's hob and pan and the oil that it states, at time 0.
    ///
    /// # Errors
    ///
    /// If the library lacks hob or pan.
    pub fn empty_kitchen(&self, library: &Library) -> Result<Kitchen, SetupError> {
        let library = &*self.library(library)?;
        let oil = self.oil.unwrap_or_else(|| Kitchen::usual_oil(library));
        Kitchen::with_oil(library, &self.pan_kind, self.pan_temperature, oil)
    }

    /// Returns a kitchen with the recipe's pan and foods, at time 0.
    pub fn kitchen(&self, library: &Library) -> Result<Kitchen, SetupError> {
        self.kitchen_with(library, &mut Models::default())
    }

    /// As [`Self::kitchen`], with known models, to which those that had to be built are added.
    pub fn kitchen_with(&self, library: &Library, models: &mut Models) -> Result<Kitchen, SetupError> {
        let mut kitchen = self.empty_kitchen(library)?;
        for food in &self.foods {
            kitchen.add_with(library, food, models)?;
        }
        Ok(kitchen)
    }
}
