//! Why a kitchen cannot be fitted: what was entered is missing or wrong, or whoever fits cannot cook it.

use saute_plan::fit::log::log_error::{LogError, Question};
use saute_plan::fit::predict::FitError;
use serde::{Deserialize, Serialize};

use super::entered::EnteredError;
use saute_words::clock::clock;
use saute_words::language::Language;

/// Why a kitchen cannot be fitted.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub enum WhyNoFit {
    /// Nothing was measured.
    Nothing,
    /// There is no recipe of what was cooked.
    NoRecipe,
    /// The recipe has no food.
    NoFood,
    /// A row means nothing: its number from 1.
    Row(usize),
    /// The log cannot be read.
    Log {
        /// Its name.
        file: String,
        /// Line, from 1.
        line: u64,
        /// What is wrong there.
        detail: String,
    },
    /// The log does not state the unit of its temperatures.
    WhichUnit,
    /// The log's times can be read in several ways.
    WhichTimes,
    /// Several columns of the log can be the core's or the pan's.
    WhichColumn,
    /// The recipe cannot be read.
    Recipe {
        /// Its name.
        file: String,
        /// Line, from 1.
        line: usize,
        /// What is wrong there.
        detail: String,
    },
    /// A step waits for a condition.
    Condition {
        /// Number of the step, from 1.
        step: usize,
        /// Line in the recipe, from 1.
        line: usize,
    },
    /// The cook ended before a value was measured.
    Ended {
        /// Time of the value [s].
        at_s: f64,
        /// End of the recipe [s].
        end_s: f64,
    },
    /// The recipe cannot be cooked.
    NotCookable,
    /// The kitchen at home cannot be built.
    NoKitchen,
}

impl From<FitError> for WhyNoFit {
    fn from(error: FitError) -> Self {
        match error {
            FitError::Nothing => Self::Nothing,
            FitError::NoFood => Self::NoFood,
            FitError::Condition { step, line } => Self::Condition { step, line },
            FitError::Cook(_) => Self::NotCookable,
            FitError::Ended { at_s, end_s } => Self::Ended { at_s, end_s },
        }
    }
}

impl From<saute_schema::InputError> for WhyNoFit {
    fn from(error: saute_schema::InputError) -> Self {
        Self::Recipe { file: error.file, line: error.line, detail: error.message }
    }
}

impl From<LogError> for WhyNoFit {
    fn from(error: LogError) -> Self {
        match error.question {
            Some(Question::Unit(_)) => Self::WhichUnit,
            Some(Question::Times(_)) => Self::WhichTimes,
            Some(Question::Core(_) | Question::Pan(_)) => Self::WhichColumn,
            None => Self::Log { file: error.file, line: error.line, detail: error.message },
        }
    }
}

impl From<EnteredError> for WhyNoFit {
    fn from(error: EnteredError) -> Self {
        match error {
            EnteredError::Log(error) => error.into(),
            EnteredError::Row(number) => Self::Row(number),
            EnteredError::NoRecipe => Self::NoRecipe,
            EnteredError::Recipe(error) => error.into(),
        }
    }
}

impl WhyNoFit {
    /// Puts it into words.
    pub fn words(&self, l: Language) -> String {
        match self {
            Self::Nothing => l.text("athome.nothing").to_owned(),
            Self::NoRecipe => l.text("athome.no_recipe").to_owned(),
            Self::NoFood => l.text("athome.no_food").to_owned(),
            Self::Row(number) => l.fill("athome.wrong_row", &[("row", number)]),
            Self::Log { file, line, detail } => {
                l.fill("athome.wrong_log", &[("file", file), ("line", line), ("detail", detail)])
            }
            Self::WhichUnit => l.text("athome.which_unit").to_owned(),
            Self::WhichTimes => l.text("athome.which_times").to_owned(),
            Self::WhichColumn => l.text("athome.which_column").to_owned(),
            Self::Recipe { file, line, detail } => {
                l.fill("athome.wrong_recipe", &[("file", file), ("line", line), ("detail", detail)])
            }
            Self::Condition { step, line } => l.fill("athome.condition", &[("step", step), ("line", line)]),
            Self::Ended { at_s, end_s } => l.fill("athome.ended", &[("at", &clock(*at_s)), ("end", &clock(*end_s))]),
            Self::NotCookable => l.text("athome.not_cookable").to_owned(),
            Self::NoKitchen => l.text("plan.no_kitchen").to_owned(),
        }
    }
}
