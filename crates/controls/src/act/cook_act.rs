//! What a person does with food, pan, hob and tools, and which cook is begun.

use saute_plan::forecast::Question;

use super::traits::{Subject, Traits};
use crate::input::pouring::Pourable;
use saute_session::permits::Permit;

/// What hands do, and which cook is begun.
#[derive(Clone, Debug, PartialEq)]
pub enum CookAct {
    /// Next lower or higher hob setting.
    Hob(i8),
    /// Sets the hob [W].
    HobSet(f64),
    /// Lets the hob hold the pan at a temperature [°C].
    HobHold(f64),
    /// Wet cloth under the pan.
    Cloth,
    /// The food into the pan.
    Put,
    /// Lays these pieces side by side onto the floor of the pan, as many as fit.
    Lay(Vec<String>),
    /// Drops these pieces into the pan onto each other.
    Heap(Vec<String>),
    /// Takes these pieces away altogether.
    Remove(Vec<String>),
    /// Turn it over.
    Flip,
    /// Onto the board.
    Out,
    /// Does what a forecast is about with the piece that the panels show.
    Asked(Question),
    /// The knife halves what was taken out.
    Halve,
    /// Tosses what is in the pan.
    Toss,
    /// Adds a portion of oil, butter or water.
    Pour(Pourable),
    /// The next portion.
    Portion,
    /// Lid on or off.
    Lid,
    /// Spoons hot fat of the pan over the piece in hand.
    Baste,
    /// Wipes the empty pan.
    Wipe,
    /// The other tool.
    Tool,
    /// Raises the turner [m].
    ToolBy(f64),
    /// Rolls the turner to the right [rad].
    RollBy(f64),
    /// Levels the turner.
    LevelTool,
    /// Lays the tool down.
    PutAway,
    /// Starts over with so many of the chosen food, and the chosen pan.
    SetOut(usize),
    /// Sets out so many more of the chosen food.
    Add(usize),
    /// Plays a recipe of the library from its start, by its id.
    Play(String),
    /// Lets the recipe go on from which a command took over.
    ResumeRecipe,
    /// Start over.
    Restart,
}

impl CookAct {
    /// What else is true of it.
    pub fn traits(&self) -> Traits {
        match self {
            Self::Hob(by) => does(Subject::Hob, if *by > 0 { "key.hob_up" } else { "key.hob_down" }),
            Self::HobSet(_) | Self::HobHold(_) => does(Subject::Hob, Traits::NO_WORDS),
            Self::Cloth => does(Subject::Hob, "key.cloth"),
            Self::Put => does(Subject::Food, "key.put"),
            Self::Lay(_) | Self::Heap(_) => does(Subject::Food, Traits::NO_WORDS),
            Self::Remove(_) => Traits { needs: &[Permit::Foods], ..does(Subject::Food, Traits::NO_WORDS) },
            Self::Flip => does(Subject::Food, "key.flip"),
            Self::Out => does(Subject::Food, "key.out"),
            Self::Asked(Question::AsItIs | Question::Flip | Question::TakeOut | Question::LowerHeat) => {
                does(Subject::Food, Traits::NO_WORDS)
            }
            Self::Halve => does(Subject::Food, "key.halve"),
            Self::Toss => does(Subject::Food, "key.toss"),
            Self::Pour(Pourable::Oil) => does(Subject::Food, "key.oil"),
            Self::Pour(Pourable::Butter) => does(Subject::Food, "key.butter"),
            Self::Pour(Pourable::Water) => does(Subject::Food, "key.water"),
            Self::Portion => holds(Subject::Food, "key.portion"),
            Self::Lid => does(Subject::Food, "key.lid"),
            Self::Baste => does(Subject::Food, "key.baste"),
            Self::Wipe => does(Subject::Food, "key.wipe"),
            Self::Tool => holds(Subject::Tool, "key.tool"),
            Self::ToolBy(by) => holds(Subject::Tool, if *by > 0.0 { "key.tool_up" } else { "key.tool_down" }),
            Self::RollBy(by) => holds(Subject::Tool, if *by > 0.0 { "key.roll_right" } else { "key.roll_left" }),
            Self::LevelTool => holds(Subject::Tool, "key.level"),
            Self::PutAway => holds(Subject::Tool, "key.put_away"),
            Self::SetOut(_) => Traits { needs: &[Permit::Foods, Permit::Pan], ..does(Subject::Food, Traits::NO_WORDS) },
            Self::Add(_) => Traits { needs: &[Permit::Foods], ..does(Subject::Food, Traits::NO_WORDS) },
            Self::Play(_) | Self::ResumeRecipe => {
                Traits { needs: &[Permit::Leaving], ..does(Subject::Food, Traits::NO_WORDS) }
            }
            Self::Restart => Traits { needs: &[Permit::Restart], ..does(Subject::Hob, "key.restart") },
        }
    }
}

/// What changes the cook: it waits while time is turned.
fn does(subject: Subject, words: &'static str) -> Traits {
    Traits { changes_cook: true, waits: true, ..holds(subject, words) }
}

/// What a hand holds or chooses, which changes nothing yet.
fn holds(subject: Subject, words: &'static str) -> Traits {
    Traits::plain(subject, words, &[Permit::Hands])
}
