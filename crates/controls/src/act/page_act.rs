//! What only a page lets a person do.

use saute_session::permits::Permit;

use super::traits::{Subject, Traits};

/// What only a page lets a person do.
#[derive(Clone, Debug, PartialEq)]
pub enum HostAct {
    /// The phone holds the pan, or no longer.
    TiltPhone,
    /// Copies what a report of a problem needs.
    Report,
}

impl HostAct {
    /// What else is true of it.
    pub fn traits(&self) -> Traits {
        match self {
            Self::TiltPhone => Traits::plain(Subject::Tool, Traits::NO_WORDS, &[Permit::Hands]),
            Self::Report => Traits::needing(&[Permit::Help]),
        }
    }
}
