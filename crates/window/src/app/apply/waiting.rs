//! Acts that are given while time is turned: they are done as soon as the instant is reached.

use saute_controls::act::{Act, CookAct};
use saute_kitchen::{Command, kelvin};
use saute_words::act_words::command_words;
use saute_words::language::Language;

/// What waits until the instant is reached to which time is turned.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Waiting {
    /// An act.
    Act(Act),
    /// A command that a hand gave over the scene.
    Command(Command),
}

impl Waiting {
    /// Returns true if this one takes the place of the one before: a slider that is dragged gives many.
    pub(crate) fn replaces(&self, before: &Self) -> bool {
        let is_hob = |waiting: &Self| {
            matches!(waiting, Self::Act(Act::Cook(CookAct::HobSet(_)) | Act::Cook(CookAct::HobHold(_))))
        };
        is_hob(self) && is_hob(before)
    }

    /// What it is called.
    pub(crate) fn words(&self, l: Language) -> String {
        match self {
            Self::Act(Act::Cook(CookAct::HobSet(w))) => command_words(&Command::Hob(*w), l),
            Self::Act(Act::Cook(CookAct::HobHold(c))) => {
                command_words(&Command::HobHold { temperature: kelvin(*c), power: 0.0 }, l)
            }
            Self::Act(act) => l.text(act.traits().words).to_owned(),
            Self::Command(command) => command_words(command, l),
        }
    }
}
