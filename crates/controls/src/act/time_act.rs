//! What a person does with the time of the cook.

use super::traits::{Subject, Traits};
use saute_session::permits::Permit;

/// What a person does with the time of the cook.
#[derive(Clone, Debug, PartialEq)]
pub enum TimeAct {
    /// Stop time or let it go on.
    Pause,
    /// One tick.
    Step,
    /// Next slower or faster speed.
    Speed(i8),
    /// Sets how fast simulated time runs [-].
    SpeedSet(f64),
    /// Fast, and at real time where a hand is needed.
    SpeedEased,
    /// Goes on with the cook of the last time, or leaves it.
    GoOn(bool),
    /// Back to before the last act.
    Undo,
    /// Forward to where the last undo began.
    Redo,
    /// Turns time to an instant [s].
    Scrub(f64),
    /// Turns time to an instant from which another way is tried [s].
    TryFrom(f64),
    /// Stops time, or lets it go on.
    HoldTime(bool),
    /// Goes over to another branch, by its place.
    Branch(usize),
}

impl TimeAct {
    /// What else is true of it.
    pub fn traits(&self) -> Traits {
        match self {
            Self::Pause => clock("key.pause", &[Permit::Pause]),
            Self::Step => Traits { changes_cook: true, waits: true, ..clock("key.step", &[Permit::Speed]) },
            Self::Speed(by) => clock(if *by > 0 { "key.faster" } else { "key.slower" }, &[Permit::Speed]),
            Self::SpeedSet(_) | Self::SpeedEased => clock(Traits::NO_WORDS, &[Permit::Speed]),
            Self::GoOn(_) => Traits { changes_cook: true, ..clock(Traits::NO_WORDS, &[Permit::Leaving]) },
            Self::Undo | Self::Redo | Self::Scrub(_) | Self::TryFrom(_) => {
                Traits { changes_cook: true, ..clock(Traits::NO_WORDS, &[Permit::Rewind]) }
            }
            Self::HoldTime(_) => clock(Traits::NO_WORDS, &[Permit::Rewind]),
            Self::Branch(_) => Traits { changes_cook: true, waits: true, ..clock(Traits::NO_WORDS, &[Permit::Rewind]) },
        }
    }
}

fn clock(words: &'static str, needs: &'static [Permit]) -> Traits {
    Traits::plain(Subject::Hob, words, needs)
}
