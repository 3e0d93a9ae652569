//! What a study and a lesson allow.

use std::collections::BTreeSet;

use saute_study::class::Locked;

use crate::permits::{Permit, Permits};

/// Those of a study: to cook, to look, what the study itself requires, and to hear where its protocol allows it.
pub fn of_study(hidden: bool, sounds: bool) -> Permits {
    Permits::only(&Permit::ALWAYS)
        .with(Permit::ReadOuts, !hidden)
        .with(Permit::Views, !hidden)
        .with(Permit::Sound, sounds)
}

/// Those of a lesson, less what its scenario locks, or the link by which it came.
pub fn of_lesson(locked: &BTreeSet<Locked>, leaving: bool, hidden: bool) -> Permits {
    let has = |what| locked.contains(&what);
    Permits::only(&Permit::ALWAYS)
        .with(Permit::Foods, !has(Locked::Foods) && !leaving)
        .with(Permit::Pan, !has(Locked::Pan) && !leaving)
        .with(Permit::Speed, !has(Locked::Speed))
        .with(Permit::Pause, true)
        .with(Permit::ReadOuts, !hidden)
        .with(Permit::Views, !has(Locked::Views) && !hidden)
        .with(Permit::Rewind, !has(Locked::Rewind))
        .with(Permit::Restart, true)
        .with(Permit::Leaving, !leaving)
        .with(Permit::Pictures, true)
        .with(Permit::Advice, true)
        .with(Permit::Sound, true)
}
