//! Marks: labelled events for the plot.

use saute_kitchen::Command;

/// An event, for the plot.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// When [s].
    pub time_s: f64,
    /// What.
    pub label: String,
}

/// Label of a command at the curves; none for what a hand does all the time.
pub(super) fn label(command: &Command) -> Option<String> {
    Some(match command {
        Command::Lead { .. } | Command::LetGo | Command::HoldPan { .. } => return None,
        Command::Hob(w) => format!("{w:.0} W"),
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

pub(super) fn step_label(step: &saute_recipe::Fired) -> String {
    match step.action {
        "hob_w" => format!("{:.0} W", step.value.as_f64().unwrap_or(0.0)),
        "put" => "in".into(),
        "rest" => "out".into(),
        "move_pan" => "pan".into(),
        "cool" => "cloth".into(),
        "lid" => if step.value == true { "lid on" } else { "lid off" }.into(),
        other => other.trim_end_matches("_g").into(),
    }
}
