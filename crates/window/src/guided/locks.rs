//! What a study or a lesson does not let a person do.

use std::collections::BTreeSet;

use saute_picture::View;
use saute_plan::class::Locked;

use crate::act::{Act, Card, Setting};

/// What cannot be done.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub struct Locks {
    /// Food is not chosen, added or removed.
    pub foods: bool,
    /// The pan is not chosen.
    pub pan: bool,
    /// Speed is fixed; no single steps.
    pub speed: bool,
    /// Time cannot be stopped.
    pub pause: bool,
    /// Only the look is seen.
    pub views: bool,
    /// No way back in time.
    pub rewind: bool,
    /// The cook cannot be begun again.
    pub restart: bool,
    /// No other cook, file, link or lesson.
    pub leaving: bool,
}

impl Locks {
    /// Those of a study.
    pub(super) fn of_study(hidden: bool) -> Self {
        Self {
            foods: true,
            pan: true,
            speed: true,
            pause: true,
            views: hidden,
            rewind: true,
            restart: true,
            leaving: true,
        }
    }

    /// Those of a lesson, with what its scenario locks.
    pub(super) fn of_lesson(locked: &BTreeSet<Locked>, leaving: bool, hidden: bool) -> Self {
        let has = |what| locked.contains(&what);
        Self {
            foods: has(Locked::Foods) || leaving,
            pan: has(Locked::Pan) || leaving,
            speed: has(Locked::Speed),
            pause: false,
            views: has(Locked::Views) || hidden,
            rewind: has(Locked::Rewind),
            restart: false,
            leaving,
        }
    }

    /// Returns true if an act is not to be carried out.
    pub fn forbid(self, act: &Act) -> bool {
        match act {
            Act::Remove(_) | Act::Add(_) => self.foods,
            Act::SetOut | Act::Set(Setting::Choice(_)) => self.foods || self.pan,
            Act::Speed(_) | Act::SpeedSet(_) | Act::Step => self.speed,
            Act::Pause => self.pause,
            Act::View(view) => self.views && *view != View::Look,
            Act::Split | Act::Slice | Act::SliceBy(_) | Act::SliceAt(_) | Act::Curves | Act::Pieces => self.views,
            Act::Probe | Act::Placing(_) | Act::Map => self.views,
            Act::Undo | Act::Redo | Act::Scrub(_) | Act::HoldTime(_) | Act::Branch(_) | Act::SideBySide => self.rewind,
            Act::Restart => self.restart,
            Act::Play(_) | Act::ResumeRecipe | Act::ChooseFile | Act::Export(_) | Act::CopyLink | Act::GoOn(_) => {
                self.leaving
            }
            #[cfg(not(target_arch = "wasm32"))]
            Act::OpenFile(_) | Act::TimeLapse => self.leaving,
            Act::Open(Card::Learn | Card::Lessons | Card::Goals) | Act::Tutorial(_) => self.leaving,
            Act::Set(Setting::SkillMode(_)) => self.leaving,
            // It shows the inside.
            Act::Open(Card::Result) => self.views || self.leaving,
            _ => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_study_locks_time_food_and_the_way_out_and_hides_views_by_condition() {
        let [shown, hidden] = [false, true].map(Locks::of_study);
        for act in [Act::Undo, Act::SpeedSet(20.0), Act::Pause, Act::SetOut, Act::Play("rare".into()), Act::Restart] {
            assert!(shown.forbid(&act) && hidden.forbid(&act), "{act:?}");
        }
        for act in [Act::View(View::Temperature), Act::Slice, Act::Curves] {
            assert!(!shown.forbid(&act) && hidden.forbid(&act), "{act:?}");
        }
        for act in [Act::Put, Act::Flip, Act::Out, Act::HobSet(1000.0), Act::View(View::Look), Act::Help] {
            assert!(!hidden.forbid(&act), "{act:?}");
        }
    }

    #[test]
    fn a_lesson_locks_what_its_scenario_says_and_the_way_out_only_if_it_is_locked() {
        let locked = BTreeSet::from([Locked::Speed]);
        let [free, fixed] = [false, true].map(|leaving| Locks::of_lesson(&locked, leaving, false));
        assert!(free.forbid(&Act::Step) && !free.forbid(&Act::Undo) && !free.forbid(&Act::CopyLink));
        assert!(!fixed.forbid(&Act::Restart), "it begins again");
        for act in [Act::CopyLink, Act::ChooseFile, Act::Play("rare".into()), Act::SetOut, Act::Open(Card::Lessons)] {
            assert!(fixed.forbid(&act), "{act:?}");
        }
    }
}
