//! What a cue means, to hear: a few seconds of the sound that it names, in place of the cook's.

use saute_kitchen::advice::coaching::Cue;
use saute_plan::schedule::senses::Hiss;
use saute_sound::{Snapshot, Steam};

/// How long an example lasts [s] (chosen: long enough to tell a hiss from a crackle).
pub const LASTS_S: f64 = 3.0;
/// Steam under food of a quiet, a steady and a lively sizzle, and of a crackle [kg/s]: each within the range that its caption has.
const QUIET: f32 = 2e-5;
const STEADY: f32 = 6e-5;
const LIVELY: f32 = 1.8e-4;
const CRACKLE: f32 = 4e-6;
/// Temperature of the floor [°C] (chosen: a pan that fries).
const FLOOR_C: f32 = 190.0;

/// A sizzle that is heard as an example: it goes from one flow of steam under food to another [kg/s].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Example {
    from: f32,
    to: f32,
}

impl Example {
    /// The sound of a cue; none if it is for another sense.
    pub fn of_cue(cue: Cue) -> Option<Self> {
        match cue {
            Cue::LivelySizzle => Some(Self { from: LIVELY, to: LIVELY }),
            Cue::SizzleFades => Some(Self { from: STEADY, to: CRACKLE }),
            _ => None,
        }
    }

    /// The sound of a step of a plan.
    pub fn of_hiss(hiss: Hiss) -> Self {
        let flow = match hiss {
            Hiss::Quiet => QUIET,
            Hiss::Steady => STEADY,
            Hiss::Loud => LIVELY,
        };
        Self { from: flow, to: flow }
    }

    /// What sounds so long after its beginning [s]; none once it is over. The flow changes evenly.
    pub fn at(&self, since_s: f64) -> Option<Snapshot> {
        let share = (since_s / LASTS_S) as f32;
        let flow = self.from + share * (self.to - self.from);
        let floor = Snapshot { floor_c: FLOOR_C, oil_c: FLOOR_C, covered: 0.4, ..Snapshot::default() };
        (0.0..LASTS_S).contains(&since_s).then(|| floor.with(Steam::Floor, flow))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hearing::caption::{Caption, caption};

    #[test]
    fn an_example_sounds_as_its_caption_says_and_ends() {
        let heard = |example: Example, since_s: f64| example.at(since_s).map(|snapshot| caption(&snapshot));
        let of_cue = |cue| Example::of_cue(cue).expect("to be heard");
        for (example, first, last) in [
            (of_cue(Cue::LivelySizzle), Caption::Lively, Caption::Lively),
            (of_cue(Cue::SizzleFades), Caption::Steady, Caption::Crackle),
            (Example::of_hiss(Hiss::Quiet), Caption::Soft, Caption::Soft),
            (Example::of_hiss(Hiss::Steady), Caption::Steady, Caption::Steady),
            (Example::of_hiss(Hiss::Loud), Caption::Lively, Caption::Lively),
        ] {
            assert_eq!([heard(example, 0.0), heard(example, LASTS_S - 0.01)], [Some(first), Some(last)]);
            assert_eq!(heard(example, LASTS_S), None);
        }
        assert_eq!(Example::of_cue(Cue::EdgeBrowns), None);
    }
}
