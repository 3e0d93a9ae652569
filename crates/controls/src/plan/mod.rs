//! "Plan my steak": the request, the search for a plan, and the cook that follows it.

pub mod kitchen_card;
pub mod plan_state;

use saute_kitchen::Library;
use saute_plan::schedule::Plan;

use crate::settings::Settings;
use crate::settings::plan_choice::PlanChoice;
use saute_words::language::Language;
use saute_words::plan_words;

/// What is done about a plan.
#[derive(Clone, Debug, PartialEq)]
pub enum PlanAct {
    /// Chooses the target and what else is requested of a plan.
    Choose(PlanChoice),
    /// Searches for a plan.
    Find,
    /// Ends the search and keeps the best plan so far.
    Stop,
    /// Sets out the food of the plan, to be cooked by a person step by step.
    CookLive,
    /// Lets the plan cook itself.
    CookItself,
    /// Saves a file that is made of the plan.
    Save(PlanFile),
    /// Does the steps that are due, in a cook that follows a plan.
    DoStep,
    /// Lets time run fast; near the next step the clock falls back to real time.
    Hurry,
    /// Ends the guidance; the cook goes on.
    Leave,
}

/// A file that is made of a plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlanFile {
    /// Its recipe.
    Recipe,
    /// The kitchen card.
    Card,
}

impl PlanFile {
    /// Keys of the notices once one is saved, or cannot be.
    pub const SAID: [&str; 2] = ["plan.saved", "plan.not_saved"];

    /// How the name of the file ends.
    pub fn ending(self) -> &'static str {
        match self {
            Self::Recipe => "toml",
            Self::Card => "html",
        }
    }

    /// Its type, as browsers call it.
    pub fn media_type(self) -> &'static str {
        match self {
            Self::Recipe => "application/toml",
            Self::Card => "text/html",
        }
    }

    /// Key of the words on its button.
    pub fn words(self) -> &'static str {
        match self {
            Self::Recipe => "plan.save_recipe",
            Self::Card => "plan.save_card",
        }
    }

    /// A name for the file.
    pub fn file_name(self, l: Language) -> String {
        format!("{}.{}", l.text("plan.file"), self.ending())
    }
}

/// The text of a plan's recipe, under what it promises.
pub fn recipe_file(plan: &Plan, library: &Library, settings: &Settings) -> String {
    let l = settings.language;
    let core = settings.fine_temperature(plan.promised.core_peak_c);
    let mut lines = vec![
        plan_words::heading(&plan.order, library, settings.speech()),
        format!("{} {}", l.text("plan.promised"), l.fill("plan.middle", &[("core", &core)])),
        plan_words::on_target(plan, l),
        plan_words::crust(&plan.promised, l),
    ];
    lines.extend(plan_words::why_not(plan, settings.speech()));
    lines.extend(plan.is_rough.then(|| l.text("plan.rough").to_owned()));
    let comment: String = lines.iter().map(|line| format!("# {line}\n")).collect();
    comment + &plan.recipe_text()
}
