//! What was done is noted: a row of the series and a mark.

use saute_kitchen::Command;
use saute_recipe::Moment;
use saute_recipe::session::{Deed, Done, Entry};

use crate::Session;
use crate::hands::Hands;
use crate::mark::Mark;

/// Poses of a hand that follow each other within this time are one stretch [frames] (chosen: a second).
const STRETCH: u64 = 60;

/// What the last of some entries did, at the curves and on the strip; none for what belongs to the mark before it.
fn done_by(entries: &[Entry]) -> Option<Done> {
    let (last, before) = entries.split_last()?;
    let is_near = |entry: &&Entry| entry.frame + STRETCH > last.frame;
    let mut near = before.iter().rev().take_while(is_near);
    let at_once = before.last().is_some_and(|entry| {
        entry.frame == last.frame && std::mem::discriminant(&entry.deed) == std::mem::discriminant(&last.deed)
    });
    let is_marked = match &last.deed {
        Deed::Command(_) if last.deed.is_pose() => !near.any(|entry| entry.deed.is_pose()),
        Deed::Command(command) => !command.is_motion(),
        Deed::Add(_) | Deed::Remove(_) => !at_once,
        Deed::TakeOver | Deed::Resume => false,
    };
    is_marked.then(|| Done::from(&last.deed))
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
        let Some(done) = done_by(entries) else { return };
        let at = Moment { entries: count, ..self.recording.moment() };
        self.recorder.write_row(&self.kitchen);
        self.marks.push(Mark { time_s: self.kitchen.time_s(), done, at, step: String::new() });
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
        let marks: Vec<Option<Done>> = (1..=entries.len()).map(|count| done_by(&entries[..count])).collect();
        let [hand, flip] = [0, 2].map(|place| Some(Done::from(&entries[place].deed)));
        assert_eq!(marks, [hand.clone(), None, flip, None, None, hand]);
    }
}
