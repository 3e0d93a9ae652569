//! The actions of a recipe. [`ActionKind`] lists them; [`Action`] is one of them, checked and in SI units.
//!
//! ```
//! use saute_kitchen::Library;
//! use saute_recipe::{Action, ActionKind, PanAction, Recipe};
//!
//! let text = "[[step]]\noil_g = { g = 10, kind = \"canola\" }\n[[step]]\nend = true";
//! let recipe = Recipe::parse(text, "oil.toml", &Library::embedded()?)?;
//! let action = &recipe.steps[0].action;
//! // Grams in the file, kilograms in the action.
//! assert_eq!(*action, Action::Pan(PanAction::Oil { kind: Some("canola".into()), mass: 0.01 }));
//! assert_eq!((action.kind(), action.name()), (ActionKind::Oil, "oil_g"));
//! assert_eq!(action.words(), "10 g canola oil");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod food_action;
pub mod kind;
pub mod pan_action;
pub mod repeat;

use saute_kitchen::Command;
use serde_json::Value;

pub use food_action::FoodAction;
pub use kind::ActionKind;
pub use pan_action::PanAction;
pub use repeat::{Repeat, RepeatEnd};

use crate::recipe::Target;

/// What a step does.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Acts on the pan, the hob or the lid.
    Pan(PanAction),
    /// Acts on each food of a target, one after the other.
    Each(Target, FoodAction),
    /// Carries out another action again and again.
    Repeat(Repeat),
    /// Ends the cook.
    End,
}

impl Action {
    /// Returns the action that gives a command; none for the motions of a hand, which no recipe states.
    pub fn of_command(command: &Command) -> Option<Self> {
        PanAction::of_command(command).map(Self::Pan).or_else(|| {
            let (food, action) = FoodAction::of_command(command)?;
            Some(Self::Each(Target { name: food.clone(), foods: vec![food], group: false }, action))
        })
    }

    /// Returns the kind of the action.
    pub fn kind(&self) -> ActionKind {
        match self {
            Self::Pan(action) => action.kind(),
            Self::Each(_, action) => action.kind(),
            Self::Repeat(_) => ActionKind::Repeat,
            Self::End => ActionKind::End,
        }
    }

    /// Returns the key of the action in a recipe.
    pub fn name(&self) -> &'static str {
        self.kind().name()
    }

    /// Returns the food, the group or "all" on which the action acts; none for an action on the pan or a repeated one.
    pub fn target(&self) -> Option<&Target> {
        match self {
            Self::Each(target, _) => Some(target),
            Self::Pan(_) | Self::Repeat(_) | Self::End => None,
        }
    }

    /// Returns the action's value in the units of the recipe, as JSON.
    pub fn value(&self) -> Value {
        match self {
            Self::Pan(action) => action.value(),
            Self::Each(_, action) => action.value(),
            Self::Repeat(repeat) => repeat.value(),
            Self::End => true.into(),
        }
    }

    /// Returns the action in English: `hob 2000 W`, `flip steak`.
    pub fn words(&self) -> String {
        match self {
            Self::Pan(action) => action.words(),
            Self::Each(target, action) => action.words(&target.name),
            Self::Repeat(repeat) => repeat.words(),
            Self::End => self.name().to_owned(),
        }
    }

    /// Returns the time for which the next step waits at least [s]; a repeated action waits at each repetition.
    pub fn duration_s(&self) -> f64 {
        match self {
            Self::Pan(action) => action.duration_s(),
            Self::Each(_, action) => action.duration_s(),
            Self::Repeat(_) | Self::End => 0.0,
        }
    }
}

/// Returns a length in millimetres from metres [mm], or a mass in grams from kilograms [g].
pub(crate) fn mm(si: f64) -> f64 {
    tidy(si * 1e3)
}

/// Returns a number of a recipe without the rounding error of its conversion to SI units and back.
pub(crate) fn tidy(value: f64) -> f64 {
    libm::round(value * 1e6) / 1e6
}
