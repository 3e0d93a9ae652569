//! What leads a person, and what a person asks the program to find out.

use super::guided_act::GuidedAct;
use super::traits::{Subject, Traits};
use crate::at_home::AtHomeAct;
use crate::plan::{PlanAct, PlanFile};
use saute_session::permits::Permit;

/// What leads a person, and what is searched for.
#[derive(Clone, Debug, PartialEq)]
pub enum LearnAct {
    /// Begins the tutorial, or leaves it.
    Tutorial(bool),
    /// What a study or a lesson requests.
    Guided(GuidedAct),
    /// Does something about a plan.
    Plan(PlanAct),
    /// Does something about the kitchen at home.
    AtHome(AtHomeAct),
}

impl LearnAct {
    /// What else is true of it.
    pub fn traits(&self) -> Traits {
        match self {
            Self::Tutorial(_) => asks(&[Permit::Leaving]),
            Self::Guided(act) => guided(act),
            Self::Plan(act) => planned(act),
            Self::AtHome(act) => at_home(act),
        }
    }
}

fn guided(act: &GuidedAct) -> Traits {
    match act {
        GuidedAct::Lesson(_) => asks(&[Permit::Leaving]),
        GuidedAct::Agree
        | GuidedAct::Decline
        | GuidedAct::TryMachine
        | GuidedAct::BeginTrial
        | GuidedAct::EndTrial
        | GuidedAct::Answer(_)
        | GuidedAct::KeepRows
        | GuidedAct::SaveLog
        | GuidedAct::BeginLesson
        | GuidedAct::Predict(_)
        | GuidedAct::GoOn
        | GuidedAct::EndLesson
        | GuidedAct::SaveResult
        | GuidedAct::CopyResult
        | GuidedAct::AgainLesson
        | GuidedAct::Leave
        | GuidedAct::CloseWindow => asks(&[Permit::Guide]),
    }
}

fn planned(act: &PlanAct) -> Traits {
    match act {
        PlanAct::CookLive | PlanAct::CookItself => {
            Traits { changes_cook: true, waits: true, ..asks(&[Permit::Advice, Permit::Leaving]) }
        }
        PlanAct::DoStep => Traits { changes_cook: true, waits: true, ..asks(&[Permit::Advice]) },
        PlanAct::Choose(_)
        | PlanAct::Find
        | PlanAct::Stop
        | PlanAct::Save(PlanFile::Recipe | PlanFile::Card)
        | PlanAct::Hurry
        | PlanAct::Leave => asks(&[Permit::Advice]),
    }
}

fn at_home(act: &AtHomeAct) -> Traits {
    match act {
        AtHomeAct::Rows(_)
        | AtHomeAct::Columns(_)
        | AtHomeAct::Cooked(_)
        | AtHomeAct::NoLog
        | AtHomeAct::Fit
        | AtHomeAct::Cancel
        | AtHomeAct::Keep
        | AtHomeAct::Use(_)
        | AtHomeAct::Forget => asks(&[Permit::Advice, Permit::Leaving]),
    }
}

fn asks(needs: &'static [Permit]) -> Traits {
    Traits::plain(Subject::Window, Traits::NO_WORDS, needs)
}
