//! Why nothing can be planned, as it comes back from whoever searches.

use saute_plan::goal::TargetError;
use saute_plan::schedule::JobError;
use saute_plan::schedule::asked::AskedError;
use serde::{Deserialize, Serialize};

use saute_words::language::Language;

/// Why nothing can be planned.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub enum WhyNoPlan {
    /// The food is unknown.
    NoFood,
    /// The scale has no such class.
    NoClass {
        /// What was requested.
        class: String,
        /// The classes that there are.
        known: Vec<String>,
    },
    /// The temperature is none of a core.
    WrongCore,
    /// The hob has no power.
    NoPower,
    /// The food cannot be built or set out.
    NotCookable,
    /// The kitchen at home cannot be built.
    NoKitchen,
}

impl From<AskedError> for WhyNoPlan {
    fn from(error: AskedError) -> Self {
        match error {
            AskedError::Food(_) => Self::NoFood,
            AskedError::Target(TargetError::Temperature(_)) => Self::WrongCore,
            AskedError::Target(TargetError::NoSuchClass { class, known, .. }) => {
                Self::NoClass { class, known: known.split(", ").map(str::to_owned).collect() }
            }
            AskedError::Job(error) => error.into(),
        }
    }
}

impl From<JobError> for WhyNoPlan {
    fn from(error: JobError) -> Self {
        match error {
            JobError::NoPower => Self::NoPower,
            JobError::Input(_) | JobError::Setup(_) => Self::NotCookable,
        }
    }
}

impl WhyNoPlan {
    /// Puts it into words.
    pub fn words(&self, l: Language) -> String {
        match self {
            Self::NoFood => l.text("plan.no_food").to_owned(),
            Self::NoClass { class, known } => {
                let known: Vec<&str> = known.iter().map(|class| l.called("class", class)).collect();
                let known = known.join(l.text("doneness.list_joint"));
                l.fill("plan.no_class", &[("class", &l.called("class", class)), ("known", &known)])
            }
            Self::WrongCore => l.text("plan.wrong_core").to_owned(),
            Self::NoPower => l.text("plan.no_power").to_owned(),
            Self::NotCookable => l.text("plan.not_cookable").to_owned(),
            Self::NoKitchen => l.text("plan.no_kitchen").to_owned(),
        }
    }
}
