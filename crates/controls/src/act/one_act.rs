//! An act of any sort.

use super::app_act::AppAct;
use super::cook_act::CookAct;
use super::learn_act::LearnAct;
use super::time_act::TimeAct;
use super::traits::Traits;
use super::view_act::ViewAct;

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
