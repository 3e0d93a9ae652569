//! The format of a study protocol.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use toml::Spanned;

/// A study: what participants agree to, the conditions, and the phases in their order.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "saute study")]
pub struct ProtocolFile {
    /// Id in logs and links: letters, digits and hyphens.
    #[schemars(with = "String")]
    pub id: Spanned<String>,
    /// Title for people; participants see it.
    #[schemars(with = "String")]
    pub title: Spanned<String>,
    /// What participants read and agree to before the first phase. No name is asked for.
    #[schemars(with = "String")]
    pub consent: Spanned<String>,
    /// Seed of the order in which conditions are given to participants.
    #[serde(default = "one")]
    pub seed: u32,
    /// If true, the session of each trial is kept beside the log as a `.saute` file.
    #[serde(default)]
    pub keep_sessions: bool,
    /// If true, the log holds the time of day at which the program was started; without it all times are relative.
    #[serde(default)]
    pub time_of_day: bool,
    /// If true, items may be answered with free text. Such answers may hold personal data: the person at the desk is warned.
    #[serde(default)]
    pub allow_free_text: bool,
    /// If true, participants hear the pan, and captions and level of its sound are shown; if false, trials are silent.
    #[serde(default)]
    pub sound: bool,
    /// Conditions; participants are spread over them evenly.
    #[schemars(with = "Vec<ConditionEntry>", length(min = 1, max = MOST_CONDITIONS))]
    pub condition: Vec<Spanned<ConditionEntry>>,
    /// Phases, in their order.
    #[schemars(with = "Vec<PhaseEntry>", length(min = 1, max = MOST_PHASES))]
    pub phase: Vec<Spanned<PhaseEntry>>,
}

/// Conditions and phases that a protocol may have (chosen: a study with more is a mistake).
pub(crate) const MOST_CONDITIONS: usize = 8;
pub(crate) const MOST_PHASES: usize = 20;
/// Trials of a phase, and items of a questionnaire.
pub(crate) const MOST_TRIALS: i64 = 50;
pub(crate) const MOST_ITEMS: usize = 40;
/// Longest trial [s] (chosen: two hours in the pan is no frying).
pub(crate) const LONGEST_S: f64 = 7200.0;

fn one() -> u32 {
    1
}

/// A condition.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ConditionEntry {
    /// Name in the log, as `A`: letters, digits and hyphens. Participants never see it.
    #[schemars(with = "String")]
    pub id: Spanned<String>,
    /// Whether the window shows what cannot be seen in a kitchen: temperatures, cut, doneness, curves, forecasts and advice.
    pub information: Information,
}

/// Whether read-outs are shown.
#[derive(Clone, Copy, Debug, Deserialize, Eq, JsonSchema, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Information {
    /// They are shown.
    Shown,
    /// They are hidden: only pan, food, hob and clock are seen.
    Hidden,
}

/// A phase: one of the three tables.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PhaseEntry {
    /// Title for people.
    pub title: Option<String>,
    /// Trials in the simulator.
    #[schemars(with = "Option<SimulateEntry>")]
    pub simulate: Option<Spanned<SimulateEntry>>,
    /// A cook at a real stove.
    #[schemars(with = "Option<CookForRealEntry>")]
    pub cook_for_real: Option<Spanned<CookForRealEntry>>,
    /// Questions.
    #[schemars(with = "Option<QuestionnaireEntry>")]
    pub questionnaire: Option<Spanned<QuestionnaireEntry>>,
}

/// Trials in the simulator.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SimulateEntry {
    /// Id of a shipped recipe (`saute list recipes`): its pan and food are set out, its steps are left to the participant.
    #[schemars(with = "Option<String>")]
    pub recipe: Option<Spanned<String>>,
    /// Id of a shipped scenario (`saute list scenarios`): its pan and food are set out.
    #[schemars(with = "Option<String>")]
    pub scenario: Option<Spanned<String>>,
    /// Id of the goal (`saute list goals`).
    #[schemars(with = "String")]
    pub goal: Spanned<String>,
    /// Number of trials.
    #[schemars(with = "u32", range(min = 1, max = MOST_TRIALS))]
    pub trials: Spanned<u32>,
    /// Simulated time over wall time [-]; fixed for the participant.
    #[schemars(with = "f64", range(min = 1, max = 20))]
    pub speed: Spanned<f64>,
    /// A trial ends here at the latest [simulated s]; 1800 by default.
    #[schemars(with = "Option<f64>", range(min = 10, max = LONGEST_S))]
    pub max_s: Option<Spanned<f64>>,
    /// Overrides the condition: everybody has the information, or nobody has it.
    pub information: Option<Information>,
    /// If true, the participant is told after each trial how it went.
    #[serde(default)]
    pub feedback: bool,
}

/// A cook at a real stove.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CookForRealEntry {
    /// What to do; it is shown as it is here.
    #[schemars(with = "String")]
    pub instructions: Spanned<String>,
    /// Id of the goal, whose classes `class` is chosen from.
    #[schemars(with = "String")]
    pub goal: Spanned<String>,
    /// What is entered afterwards.
    #[schemars(with = "Vec<Entered>", length(min = 1))]
    pub enter: Spanned<Vec<Entered>>,
}

/// What is entered of a cook at a real stove.
#[derive(Clone, Copy, Debug, Deserialize, Eq, JsonSchema, Ord, PartialEq, PartialOrd, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Entered {
    /// Highest temperature of the core, by a thermometer [°C].
    CoreC,
    /// Class of the middle of the cut, by its colour.
    Class,
    /// Share of the cut in the class of the goal, by eye or from a photograph [%].
    TargetSharePct,
    /// Weight before cooking [g].
    WeightBeforeG,
    /// Weight after cooking [g].
    WeightAfterG,
    /// Time in the pan [s].
    PanTimeS,
    /// Time of the rest [s].
    RestTimeS,
    /// Number of flips.
    Flips,
}

/// Questions.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct QuestionnaireEntry {
    /// Text above the questions.
    pub intro: Option<String>,
    /// Questions, in their order.
    #[schemars(with = "Vec<ItemEntry>", length(min = 1, max = MOST_ITEMS))]
    pub item: Vec<Spanned<ItemEntry>>,
}

/// A question.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ItemEntry {
    /// Name in the log: letters, digits and hyphens.
    #[schemars(with = "String")]
    pub id: Spanned<String>,
    /// The question.
    #[schemars(with = "String")]
    pub text: Spanned<String>,
    /// How it is answered.
    #[schemars(with = "AnswerKind")]
    pub answer: Spanned<AnswerKind>,
    /// With `likert`: words for 1 and for 7.
    #[schemars(with = "Option<Vec<String>>", length(min = 2, max = 2))]
    pub ends: Option<Spanned<Vec<String>>>,
    /// With `number`: lowest and highest answer.
    #[schemars(with = "Option<Vec<f64>>", length(min = 2, max = 2))]
    pub range: Option<Spanned<Vec<f64>>>,
    /// With `number`: unit, as `°C`.
    pub unit: Option<String>,
    /// With `choice`: the answers to choose from.
    #[schemars(with = "Option<Vec<String>>", length(min = 2, max = 9))]
    pub choices: Option<Spanned<Vec<String>>>,
}

/// How a question is answered.
#[derive(Clone, Copy, Debug, Deserialize, Eq, JsonSchema, PartialEq)]
#[serde(rename_all = "snake_case")]
pub enum AnswerKind {
    /// One of seven steps.
    Likert,
    /// A number in a range.
    Number,
    /// One of a few answers.
    Choice,
    /// Free text; only with `allow_free_text`.
    Text,
}
