//! The format of a scenario.

use schemars::JsonSchema;
use serde::Deserialize;
use toml::Spanned;

use crate::protocol_file::{Information, LONGEST_S};

/// A lesson: what is set out, the goal, what is locked or hidden, and questions.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "saute scenario")]
pub struct ScenarioFile {
    /// Id in results and links: letters, digits and hyphens.
    #[schemars(with = "String")]
    pub id: Spanned<String>,
    /// Title for people.
    #[schemars(with = "String")]
    pub title: Spanned<String>,
    /// The title in Japanese.
    pub title_ja: Option<String>,
    /// What the student reads first.
    #[schemars(with = "String")]
    pub intro: Spanned<String>,
    /// The same in Japanese.
    pub intro_ja: Option<String>,
    /// Id of a shipped recipe (`saute list recipes`): its pan and food are set out, its steps are left to the student.
    #[schemars(with = "Option<String>")]
    pub recipe: Option<Spanned<String>>,
    /// Pan and food, in place of `recipe`.
    #[schemars(with = "Option<SetOutEntry>")]
    pub set_out: Option<Spanned<SetOutEntry>>,
    /// Id of the goal (`saute list goals`).
    #[schemars(with = "String")]
    pub goal: Spanned<String>,
    /// What the student cannot change.
    #[serde(default)]
    pub lock: Vec<Locked>,
    /// Whether the window shows what cannot be seen in a kitchen; shown by default.
    pub overlays: Option<Information>,
    /// Simulated time over wall time at the start [-]; 1 by default.
    #[schemars(with = "Option<f64>", range(min = 1, max = 20))]
    pub speed: Option<Spanned<f64>>,
    /// The lesson ends here at the latest [simulated s]; 1800 by default.
    #[schemars(with = "Option<f64>", range(min = 10, max = LONGEST_S))]
    pub max_s: Option<Spanned<f64>>,
    /// Questions at which the cook pauses.
    #[serde(default)]
    #[schemars(with = "Vec<PredictEntry>", length(max = 4))]
    pub predict: Vec<Spanned<PredictEntry>>,
}

/// Pan and food.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SetOutEntry {
    /// Id of a food (`saute list foods`).
    #[schemars(with = "String")]
    pub food: Spanned<String>,
    /// Its dimensions: those of its form [mm]; the food's own by default.
    pub size_mm: Option<Vec<f64>>,
    /// Start temperature of the food [°C]; 5 by default.
    pub initial_c: Option<f64>,
    /// Id of a pan (`saute list pans`); a carbon steel pan by default.
    pub pan: Option<String>,
    /// Start temperature of the pan [°C]; 20 by default.
    pub preheat_c: Option<f64>,
}

/// What a student cannot change.
#[derive(Clone, Copy, Debug, Deserialize, Eq, JsonSchema, Ord, PartialEq, PartialOrd)]
#[serde(rename_all = "snake_case")]
pub enum Locked {
    /// Food: none is chosen, added or removed.
    Foods,
    /// The pan.
    Pan,
    /// Speed and single steps.
    Speed,
    /// Views other than the look, and the cut.
    Views,
    /// Undo, turning time, and other ways.
    Rewind,
}

/// A question at which the cook pauses. One of `at_s`, `core_c` and `after` states when.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PredictEntry {
    /// At this time [simulated s].
    #[schemars(with = "Option<f64>", range(min = 0, max = LONGEST_S))]
    pub at_s: Option<Spanned<f64>>,
    /// Once the core has this temperature [°C].
    #[schemars(with = "Option<f64>", range(min = -10, max = 100))]
    pub core_c: Option<Spanned<f64>>,
    /// After this was done for the first time.
    pub after: Option<Deed>,
    /// With `after`: so long after it [simulated s]; 0 by default.
    #[schemars(with = "Option<f64>", range(min = 0, max = LONGEST_S))]
    pub after_s: Option<Spanned<f64>>,
    /// What is asked.
    pub ask: AskKind,
    /// With `core_in`: how far ahead [simulated s]; 120 by default.
    #[schemars(with = "Option<f64>", range(min = 5, max = 1200))]
    pub in_s: Option<Spanned<f64>>,
    /// Words before the question.
    pub text: Option<String>,
    /// The same in Japanese.
    pub text_ja: Option<String>,
}

/// What is done to food.
#[derive(Clone, Copy, Debug, Deserialize, Eq, JsonSchema, PartialEq)]
#[serde(rename_all = "snake_case")]
pub enum Deed {
    /// It is put into the pan.
    Put,
    /// It is flipped.
    Flip,
    /// It is taken out.
    Out,
}

/// What is asked.
#[derive(Clone, Copy, Debug, Deserialize, Eq, JsonSchema, PartialEq)]
#[serde(rename_all = "snake_case")]
pub enum AskKind {
    /// How warm the core is now [°C].
    CoreNow,
    /// How warm it will be a while later [°C].
    CoreIn,
    /// How warm it will get at most [°C].
    CorePeak,
    /// How much of the underside is brown now [%].
    UndersideBrown,
    /// Which class of doneness the core will have in the end.
    ClassInTheEnd,
}
