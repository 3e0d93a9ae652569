//! Marks: labelled events for the plot.

use saute_kitchen::Command;
use saute_recipe::session::{Deed, Entry};
use saute_recipe::{Action, Moment};

use super::Session;
use crate::hands::Hands;

/// Poses of a hand that follow each other within this time are one stretch [frames] (chosen: a second).
const STRETCH: u64 = 60;

/// An event, for the plot.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize)]
pub struct Mark {
    /// When [s].
    pub time_s: f64,
    /// What.
    pub label: String,
    /// The instant after it.
    pub at: Moment,
    /// The step as a recipe states it, if a recipe's step did it; empty for what a hand did, which the recording has.
    pub step: String,
}

/// Label of a command at the curves; none for what a hand does all the time.
pub fn label(command: &Command) -> Option<String> {
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
        Command::Wipe => "wipe".into(),
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

/// Label of the last of some entries at the curves and on the strip; none for what belongs to the mark before it.
fn mark_of(entries: &[Entry]) -> Option<String> {
    let (last, before) = entries.split_last()?;
    let is_near = |entry: &&Entry| entry.frame + STRETCH > last.frame;
    let mut near = before.iter().rev().take_while(is_near);
    let at_once = before.last().is_some_and(|entry| {
        entry.frame == last.frame && std::mem::discriminant(&entry.deed) == std::mem::discriminant(&last.deed)
    });
    match &last.deed {
        Deed::Command(_) if last.deed.is_pose() => (!near.any(|entry| entry.deed.is_pose())).then(|| "hand".into()),
        Deed::Command(command) => label(command),
        Deed::Add(_) => (!at_once).then(|| "add".into()),
        Deed::Remove(_) => (!at_once).then(|| "remove".into()),
        Deed::TakeOver | Deed::Resume => None,
    }
}

impl<H: Hands> Session<H> {
    /// Notes what was recorded last in series and marks.
    pub(super) fn note_last(&mut self) {
        self.note_until(self.recording.entries().len());
    }

    /// Notes the last of the first `count` entries.
    pub(super) fn note_until(&mut self, count: usize) {
        let entries = &self.recording.entries()[..count];
        if matches!(entries.last().map(|entry| &entry.deed), Some(Deed::Command(Command::Put { .. }))) {
            self.recorder.on_put(&self.kitchen);
        }
        let Some(label) = mark_of(entries) else { return };
        let at = Moment { entries: count, ..self.recording.moment() };
        self.recorder.write_row(&self.kitchen);
        self.marks.push(Mark { time_s: self.kitchen.time_s(), label, at, step: String::new() });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn poses_of_a_hand_are_one_mark_for_each_stretch() {
        let pose = |frame| Entry {
            frame,
            after_steps: false,
            deed: Deed::Command(Command::HoldPan { pose: saute_kitchen::dynamics::Pose::default() }),
        };
        let flip = Entry { frame: 40, after_steps: false, deed: Deed::Command(Command::Flip { food: "a".into() }) };
        let entries = [pose(10), pose(11), flip, pose(50), pose(109), pose(170)];
        let marks: Vec<Option<String>> = (1..=entries.len()).map(|count| mark_of(&entries[..count])).collect();
        let hand = Some("hand".to_owned());
        assert_eq!(marks, [hand.clone(), None, Some("flip".to_owned()), None, None, hand]);
    }
}
