//! What a person may do in a cook that a study or a lesson leads: a list of what is allowed.

use saute_kitchen::{Command, Refused};

/// Why a command was not carried out.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NotDone {
    /// The study or the lesson that leads the cook does not allow it.
    #[error("this is locked in the study or the lesson that leads this cook")]
    Locked,
    /// The kitchen refuses it.
    #[error(transparent)]
    Refused(#[from] Refused),
}

/// One thing that may be allowed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Permit {
    /// Cooking: food in the pan, hob, liquids, tools.
    Hands,
    /// The eye goes round, the panels show another piece.
    Eye,
    /// What makes the program usable for a person: language, sizes, units, light and quality of the picture.
    Comfort,
    /// The list of keys, and past messages.
    Help,
    /// What the study or the lesson itself requires.
    Guide,
    /// Devices and the half mirror.
    Devices,
    /// Food is chosen, added or removed.
    Foods,
    /// The pan is chosen.
    Pan,
    /// Speed is chosen; single steps.
    Speed,
    /// Time is stopped.
    Pause,
    /// More is read than can be perceived in a kitchen: temperatures, doneness, curves, advice.
    ReadOuts,
    /// Other views than the look, and the cut.
    Views,
    /// Time is turned.
    Rewind,
    /// The cook is begun again.
    Restart,
    /// Another cook, file, link or lesson.
    Leaving,
    /// Photos and time lapses.
    Pictures,
    /// Goals, coach, forecasts, plans.
    Advice,
    /// Sound, and what replaces it: captions and the level.
    Sound,
}

impl Permit {
    /// All of them.
    pub const ALL: [Self; 18] = [
        Self::Hands,
        Self::Eye,
        Self::Comfort,
        Self::Help,
        Self::Guide,
        Self::Devices,
        Self::Foods,
        Self::Pan,
        Self::Speed,
        Self::Pause,
        Self::ReadOuts,
        Self::Views,
        Self::Rewind,
        Self::Restart,
        Self::Leaving,
        Self::Pictures,
        Self::Advice,
        Self::Sound,
    ];
    /// What every study and every lesson allows.
    pub const ALWAYS: [Self; 6] = [Self::Hands, Self::Eye, Self::Comfort, Self::Help, Self::Guide, Self::Devices];

    fn bit(self) -> u32 {
        1 << self as u32
    }
}

/// A set of what is allowed; what is not in it is locked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Permits(u32);

impl Default for Permits {
    /// A cook that nobody leads: everything.
    fn default() -> Self {
        Self(u32::MAX)
    }
}

impl Permits {
    /// These and no more.
    pub fn only(allowed: &[Permit]) -> Self {
        Self(allowed.iter().fold(0, |bits, permit| bits | permit.bit()))
    }

    /// The same and one more, if a condition is true.
    #[must_use]
    pub fn with(self, permit: Permit, holds: bool) -> Self {
        if holds { Self(self.0 | permit.bit()) } else { self }
    }

    /// Returns true if all of these are allowed.
    pub fn allow(self, needs: &[Permit]) -> bool {
        needs.iter().all(|permit| self.0 & permit.bit() != 0)
    }
}

/// What must be allowed for a command, whoever gives it: a button, the mouse, a gamepad, a device, a plan.
pub fn needs(command: &Command) -> &'static [Permit] {
    match command {
        Command::Hob(_)
        | Command::HobHold { .. }
        | Command::Put { .. }
        | Command::Flip { .. }
        | Command::Rest { .. }
        | Command::Halve { .. }
        | Command::MovePan { .. }
        | Command::Cool { .. }
        | Command::Toss { .. }
        | Command::Shake { .. }
        | Command::Tilt { .. }
        | Command::Press { .. }
        | Command::Baste { .. }
        | Command::Move { .. }
        | Command::Lead { .. }
        | Command::LetGo
        | Command::HoldPan { .. }
        | Command::Oil { .. }
        | Command::Butter(_)
        | Command::Water(_)
        | Command::Lid(_)
        | Command::Wipe => &[Permit::Hands],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_in_the_list_is_locked() {
        let few = Permits::only(&[Permit::Hands, Permit::Foods]).with(Permit::Pan, true).with(Permit::Speed, false);
        assert!(
            few.allow(&[]) && few.allow(&[Permit::Foods, Permit::Pan]) && !few.allow(&[Permit::Foods, Permit::Speed])
        );
        for permit in Permit::ALL {
            assert!(Permits::default().allow(&[permit]), "{permit:?}");
            assert_eq!(Permits::only(&Permit::ALWAYS).allow(&[permit]), Permit::ALWAYS.contains(&permit), "{permit:?}");
        }
    }
}
