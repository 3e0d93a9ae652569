//! What was done, for marks and lists: without the values that only a replay needs.

use saute_kitchen::Command;
use serde::{Deserialize, Serialize};

use crate::action::Action;
use crate::session::Deed;

/// Something that was done in a cook, by a recipe or by a person. Its words are made where it is shown.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub enum Done {
    /// A command that the kitchen carried out. A step of a recipe on several foods is one command on the name of its target.
    Command(Command),
    /// Food that was added.
    Add,
    /// A piece that was removed.
    Remove,
    /// The recipe was stopped, or it goes on.
    Recipe,
    /// The recipe ended the cook.
    End,
}

impl From<&Deed> for Done {
    fn from(deed: &Deed) -> Self {
        match deed {
            Deed::Command(command) => Self::Command(command.clone()),
            Deed::Add(_) => Self::Add,
            Deed::Remove(_) => Self::Remove,
            Deed::TakeOver | Deed::Resume => Self::Recipe,
        }
    }
}

impl From<&Action> for Done {
    fn from(action: &Action) -> Self {
        match action {
            Action::Pan(action) => Self::Command(action.command()),
            Action::Each(target, action) => Self::Command(action.command(target.name.clone(), [0.0; 2])),
            Action::Repeat(repeat) => Self::from(&*repeat.action),
            Action::End => Self::End,
        }
    }
}
