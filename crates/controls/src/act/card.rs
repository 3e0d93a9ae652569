//! Cards over everything.

use saute_session::permits::Permit;

/// A card over everything.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Card {
    /// The list of keys.
    Help,
    /// The settings.
    Settings,
    /// The notices so far.
    Messages,
    /// The half mirror.
    Mirror,
    /// The first steps.
    FirstSteps,
    /// What there is to learn and to try.
    Learn,
    /// Files to open and to save.
    Files,
    /// The lessons.
    Lessons,
    /// The goals of a cook.
    Goals,
    /// The result of the cook.
    Result,
    /// A plan for the chosen food.
    Plan,
    /// The kitchen at home.
    AtHome,
}

impl Card {
    /// What must be allowed to open it.
    pub fn needs(self) -> &'static [Permit] {
        match self {
            Self::Help | Self::Messages => &[Permit::Help],
            Self::Settings => &[Permit::Comfort],
            Self::Mirror => &[Permit::Devices],
            Self::FirstSteps | Self::Learn | Self::Files | Self::Lessons | Self::Goals => &[Permit::Leaving],
            // It shows the inside.
            Self::Result => &[Permit::ReadOuts, Permit::Leaving],
            Self::Plan | Self::AtHome => &[Permit::Advice, Permit::Leaving],
        }
    }
}
