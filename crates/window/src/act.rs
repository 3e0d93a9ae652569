//! Everything a person can do, by button, key or mouse.

mod app_act;
mod bindings;
mod card;
mod cook_act;
mod guided_act;
mod learn_act;
#[cfg(test)]
pub(crate) mod samples;
mod setting;
mod time_act;
mod traits;
mod view_act;

pub use self::app_act::AppAct;
pub use self::bindings::{BINDINGS, Binding, CHORDS, ROLL_STEP, TOOL_STEP, hint, key_of};
pub use self::card::Card;
pub use self::cook_act::CookAct;
pub use self::guided_act::GuidedAct;
pub use self::learn_act::LearnAct;
pub use self::setting::Setting;
pub use self::time_act::TimeAct;
pub use self::traits::{Subject, Traits};
pub use self::view_act::ViewAct;

/// Acts that panels return, in order; the app carries them out once all panels are shown.
pub type Acts = Vec<Act>;

/// One thing to do.
#[derive(Clone, Debug, PartialEq)]
pub enum Act {
    /// With food, pan, hob and tools.
    Cook(CookAct),
    /// With the time of the cook.
    Time(TimeAct),
    /// With what is seen.
    View(ViewAct),
    /// With what leads, and with what is searched for.
    Learn(LearnAct),
    /// With cards, files, pictures, devices and settings.
    App(AppAct),
}

impl Act {
    /// What else is true of it.
    pub fn traits(&self) -> Traits {
        match self {
            Self::Cook(act) => act.traits(),
            Self::Time(act) => act.traits(),
            Self::View(act) => act.traits(),
            Self::Learn(act) => act.traits(),
            Self::App(act) => act.traits(),
        }
    }
}
