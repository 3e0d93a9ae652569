//! A checked protocol.

use std::sync::Arc;

use saute_kitchen::Library;
use saute_recipe::Recipe;
use saute_schema::{InputError, InputText};

use super::check::Check;
use super::protocol_file::{Entered, Information};
use saute_plan::Aimed;

/// A checked protocol.
#[derive(Clone, Debug)]
pub struct Protocol {
    /// Id in logs and links.
    pub id: String,
    /// Title for people.
    pub title: String,
    /// What participants agree to.
    pub consent: String,
    /// Seed of the order of the conditions.
    pub seed: u32,
    /// True if the session of each trial is kept.
    pub keep_sessions: bool,
    /// True if the log contains the time of day of the start.
    pub time_of_day: bool,
    /// True if the pan is heard, and its sound shown as captions and level.
    pub sound: bool,
    /// Conditions.
    pub conditions: Vec<Condition>,
    /// Phases, in their order.
    pub phases: Vec<Phase>,
    /// Checksum of the text: logs of a protocol that was changed are not mixed.
    pub checksum: u32,
}

/// A condition.
#[derive(Clone, Debug, Eq, PartialEq)]
pub struct Condition {
    /// Name in the log.
    pub id: String,
    /// Whether read-outs are shown.
    pub information: Information,
}

/// A phase.
#[derive(Clone, Debug)]
pub struct Phase {
    /// Title for people; empty where there is none.
    pub title: String,
    /// What is done.
    pub task: Task,
}

/// What is done in a phase.
#[derive(Clone, Debug)]
pub enum Task {
    /// Trials in the simulator.
    Simulate(Simulate),
    /// A cook at a real stove.
    CookForReal(CookForReal),
    /// Questions.
    Questionnaire(Questionnaire),
}

/// Trials in the simulator.
#[derive(Clone, Debug)]
pub struct Simulate {
    /// The recipe whose pan and food are set out.
    pub recipe: Arc<Recipe>,
    /// The goal.
    pub goal: Aimed,
    /// Number of trials.
    pub trials: u32,
    /// Simulated time over wall time [-].
    pub speed: f64,
    /// Longest trial [simulated s].
    pub max_s: f64,
    /// Information for everybody; by the condition where none is stated.
    pub information: Option<Information>,
    /// True if the participant is shown how a trial went.
    pub feedback: bool,
}

/// A cook at a real stove.
#[derive(Clone, Debug)]
pub struct CookForReal {
    /// What to do.
    pub instructions: String,
    /// The goal.
    pub goal: Aimed,
    /// What is entered.
    pub enter: Vec<Entered>,
}

/// Questions.
#[derive(Clone, Debug)]
pub struct Questionnaire {
    /// Text above them; empty where there is none.
    pub intro: String,
    /// The questions.
    pub items: Vec<Item>,
}

/// A question.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    /// Name in the log.
    pub id: String,
    /// The question.
    pub text: String,
    /// How it is answered.
    pub answer: Answering,
}

/// How a question is answered.
#[derive(Clone, Debug, PartialEq)]
pub enum Answering {
    /// One of seven steps, with words for the first and the last.
    Likert([String; 2]),
    /// A number in a range, with its unit.
    Number([f64; 2], String),
    /// One of a few answers.
    Choice(Vec<String>),
    /// Free text.
    Text,
}

/// Steps of a Likert item.
pub const LIKERT_STEPS: u8 = 7;

impl Protocol {
    /// Parses and checks a protocol. `file` is its name in messages.
    ///
    /// # Errors
    ///
    /// Returns file, line, key and remedy of the first mistake.
    pub fn parse(text: &str, file: &str, library: &Library) -> Result<Self, InputError> {
        Check { input: InputText { text, file }, library }.protocol()
    }

    /// Returns what is entered or asked in a phase: names in the log; nothing for trials.
    pub fn items_of(&self, phase: usize) -> Vec<String> {
        match self.phases.get(phase).map(|phase| &phase.task) {
            Some(Task::CookForReal(real)) => real.enter.iter().map(|entered| entered.id().to_owned()).collect(),
            Some(Task::Questionnaire(asked)) => asked.items.iter().map(|item| item.id.clone()).collect(),
            _ => Vec::new(),
        }
    }
}

impl Entered {
    /// All of them, in the order in which they are requested.
    pub const ALL: [Self; 8] = [
        Self::CoreC,
        Self::Class,
        Self::TargetSharePct,
        Self::WeightBeforeG,
        Self::WeightAfterG,
        Self::PanTimeS,
        Self::RestTimeS,
        Self::Flips,
    ];

    /// Its name in protocols and logs.
    pub fn id(self) -> &'static str {
        match self {
            Self::CoreC => "core_c",
            Self::Class => "class",
            Self::TargetSharePct => "target_share_pct",
            Self::WeightBeforeG => "weight_before_g",
            Self::WeightAfterG => "weight_after_g",
            Self::PanTimeS => "pan_time_s",
            Self::RestTimeS => "rest_time_s",
            Self::Flips => "flips",
        }
    }

    /// Lowest and highest value that makes sense; none for the class (chosen: beyond these it is a mistyped number).
    pub fn range(self) -> Option<[f64; 2]> {
        match self {
            Self::CoreC => Some([0.0, 110.0]),
            Self::Class => None,
            Self::TargetSharePct => Some([0.0, 100.0]),
            Self::WeightBeforeG | Self::WeightAfterG => Some([1.0, 5000.0]),
            Self::PanTimeS | Self::RestTimeS => Some([0.0, 7200.0]),
            Self::Flips => Some([0.0, 200.0]),
        }
    }

    /// Its unit; empty where it has none.
    pub fn unit(self) -> &'static str {
        match self {
            Self::CoreC => "°C",
            Self::TargetSharePct => "%",
            Self::WeightBeforeG | Self::WeightAfterG => "g",
            Self::PanTimeS | Self::RestTimeS => "s",
            Self::Class | Self::Flips => "",
        }
    }
}
