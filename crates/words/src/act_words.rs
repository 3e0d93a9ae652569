//! Acts in words: what marks and branches are called.

use saute_kitchen::{Command, celsius};
use saute_recipe::session::Done;

use crate::language::Language;

/// What was done.
pub fn act_words(done: &Done, l: Language) -> String {
    let key = match done {
        Done::Command(command) => return command_words(command, l),
        Done::Add => "mark.add",
        Done::Remove => "mark.remove",
        Done::Recipe => "mark.recipe",
        Done::End => "mark.end",
    };
    l.text(key).to_owned()
}

/// What a command does; a power or a temperature of the hob is a number and needs no word.
pub fn command_words(command: &Command, l: Language) -> String {
    let key = match command {
        Command::Hob(w) => return format!("{w:.0} W"),
        Command::HobHold { temperature, .. } => return format!("{:.0} °C", celsius(*temperature)),
        Command::Lead { .. } | Command::LetGo | Command::HoldPan { .. } => "mark.hand",
        Command::Put { .. } => "mark.in",
        Command::Flip { .. } => "mark.flip",
        Command::Rest { .. } => "mark.out",
        Command::Halve { .. } => "mark.halve",
        Command::MovePan { .. } => "mark.pan",
        Command::Cool { .. } => "mark.cloth",
        Command::Toss { .. } => "mark.toss",
        Command::Shake { .. } => "mark.shake",
        Command::Tilt { .. } => "mark.tilt",
        Command::Press { .. } => "mark.press",
        Command::Baste { .. } => "mark.baste",
        Command::Move { .. } => "mark.move",
        Command::Oil { .. } => "mark.oil",
        Command::Butter(_) => "mark.butter",
        Command::Water(_) => "mark.water",
        Command::Wipe => "mark.wipe",
        Command::Lid(true) => "mark.lid_on",
        Command::Lid(false) => "mark.lid_off",
    };
    l.text(key).to_owned()
}
