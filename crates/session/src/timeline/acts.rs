//! Which entries of a recording are one act of a person.

use saute_kitchen::Command;
use saute_recipe::session::{Deed, Entry};

/// Motions of a hand, or settings of the hob, that follow each other within this time are one act [frames] (chosen: a second).
const ONE_ACT: u64 = 60;

/// Returns the first entry of the last act among the first `before` entries; none if there is no act after the first `given`.
pub(super) fn last_act(entries: &[Entry], given: usize, before: usize) -> Option<usize> {
    let end = entries[..before].iter().rposition(|entry| entry.deed != Deed::TakeOver)?;
    let joined = |first: &usize| joins(&entries[first - 1], &entries[*first]);
    let mut first = end;
    while first > 0 && joined(&first) {
        first -= 1;
    }
    (end >= given).then_some(first.max(given))
}

/// Returns true if an entry belongs to the act of the one before it.
fn joins(before: &Entry, entry: &Entry) -> bool {
    let apart = entry.frame - before.frame;
    match (kind(&before.deed), kind(&entry.deed)) {
        (ActKind::Motion, ActKind::Motion) | (ActKind::Hob, ActKind::Hob) => apart < ONE_ACT,
        (ActKind::Put, ActKind::Put) | (ActKind::Add, ActKind::Add) | (ActKind::Remove, ActKind::Remove) => apart == 0,
        _ => false,
    }
}

#[derive(PartialEq)]
enum ActKind {
    Motion,
    Hob,
    Put,
    Add,
    Remove,
    Other,
}

fn kind(deed: &Deed) -> ActKind {
    match deed {
        Deed::Command(command) if command.is_motion() => ActKind::Motion,
        Deed::Command(Command::Hob(_) | Command::HobHold { .. }) => ActKind::Hob,
        Deed::Command(Command::Put { .. }) => ActKind::Put,
        Deed::Add(_) => ActKind::Add,
        Deed::Remove(_) => ActKind::Remove,
        Deed::Command(_) | Deed::TakeOver | Deed::Resume => ActKind::Other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn hob(frame: u64) -> Entry {
        Entry { frame, after_steps: false, deed: Deed::Command(Command::Hob(1.0)) }
    }

    fn flip(frame: u64) -> Entry {
        Entry { frame, after_steps: false, deed: Deed::Command(Command::Flip { food: "a".into() }) }
    }

    #[test]
    fn what_belongs_together_is_undone_together() {
        let entries = [hob(0), flip(5), hob(100), hob(130), hob(180), flip(190), flip(190)];
        assert_eq!(last_act(&entries, 0, 7), Some(6));
        assert_eq!(last_act(&entries, 0, 5), Some(2));
        assert_eq!(last_act(&entries, 0, 2), Some(1));
        assert_eq!(last_act(&entries, 0, 0), None);
        assert_eq!(last_act(&entries, 2, 2), None);
    }
}
