//! Marks: labelled events for the plot.

use saute_kitchen::Command;
use saute_recipe::{Action, Moment};

/// An event, for the plot.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// When [s].
    pub time_s: f64,
    /// What.
    pub label: String,
    /// The instant after it.
    pub at: Moment,
}

/// Label of a command at the curves; none for what a hand does all the time.
pub(crate) fn label(command: &Command) -> Option<String> {
    Some(match command {
        Command::Lead { .. } | Command::LetGo | Command::HoldPan { .. } => return None,
        Command::Hob(w) => format!("{w:.0} W"),
        Command::HobHold { temperature, .. } => format!("{:.0} °C", saute_kitchen::celsius(*temperature)),
        Command::Put { .. } => "in".into(),
        Command::Flip { .. } => "flip".into(),
        Command::Rest { .. } => "out".into(),
        Command::Halve { .. } => "halve".into(),
        Command::MovePan { .. } => "pan".into(),
        Command::Cool { .. } => "cloth".into(),
        Command::Toss { .. } => "toss".into(),
        Command::Shake { .. } => "shake".into(),
        Command::Tilt { .. } => "tilt".into(),
        Command::Press { .. } => "press".into(),
        Command::Move { .. } => "move".into(),
        Command::Oil { .. } => "oil".into(),
        Command::Butter(_) => "butter".into(),
        Command::Water(_) => "water".into(),
        Command::Lid(on) => if *on { "lid on" } else { "lid off" }.into(),
    })
}

/// Label of a step: that of its command.
pub(super) fn step_label(step: &saute_recipe::Fired) -> String {
    let label = match &step.action {
        Action::Pan(action) => label(&action.command()),
        Action::Each(_, action) => label(&action.command(String::new(), [0.0; 2])),
        Action::Repeat(_) | Action::End => None,
    };
    label.unwrap_or_else(|| step.action.name().into())
}
