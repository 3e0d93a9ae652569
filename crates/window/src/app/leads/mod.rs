//! What leads a person: studies, lessons, the tutorial, goals and results, plans, the kitchen at home.

#[cfg(test)]
mod allowed;
mod at_home;
mod goal_choice;
mod guided;
mod plan;
mod result;
mod trial_run;
mod tutorial;
#[cfg(test)]
mod walk;

use saute_session::at_home::fitting::AtHome;
use saute_session::plan::live::Live;
use saute_session::plan::planning::Planning;

use saute_controls::learning::Learning;
use saute_session::guided::Guided;

/// What leads a person, and what is searched for.
#[derive(Default)]
pub(crate) struct Leads {
    /// The study or the lesson that leads the cook.
    pub(crate) guided: Option<Guided>,
    /// What the window keeps of what it teaches.
    pub(crate) learn: Learning,
    /// What was entered about the kitchen at home, and the fit to it.
    pub(crate) at_home: AtHome,
    /// The search for a plan.
    pub(crate) planning: Planning,
    /// The cook that follows a plan.
    pub(crate) live: Option<Live>,
}
