//! A cook that a study or a lesson leads: it decides what is set out, shown and locked, and puts the questions.

mod lesson_desk;
pub mod log_keeper;
pub mod permits;
mod readiness;
mod study_desk;

pub use self::lesson_desk::{LessonDesk, LessonStart};
pub use self::readiness::{Readiness, TrialRun};
pub use self::study_desk::{StudyDesk, StudyStart};
use crate::permits::{Permit, Permits};

/// What leads the cook.
pub enum Guided {
    /// A study.
    Study(Box<StudyDesk>),
    /// A lesson.
    Lesson(Box<LessonDesk>),
}

impl Guided {
    /// Returns true while a card has a question; time waits behind it.
    pub fn asks(&self) -> bool {
        match self {
            Self::Study(desk) => !desk.is_running(),
            Self::Lesson(desk) => desk.asks(),
        }
    }

    /// What is allowed.
    pub fn permits(&self) -> Permits {
        match self {
            Self::Study(desk) => permits::of_study(desk.hides_read_outs(), desk.sounds()),
            Self::Lesson(desk) => permits::of_lesson(&desk.scenario().locked, desk.is_locked(), desk.hides_read_outs()),
        }
    }

    /// Returns true if time waits while something is read or chosen over the scene.
    pub fn time_waits(&self) -> bool {
        match self {
            Self::Study(desk) if matches!(desk.readiness(), Readiness::Tried(_)) => false,
            _ => self.asks() || self.permits().allow(&[Permit::Pause]),
        }
    }

    /// Returns true if the speed of time is to be held: nobody may set it.
    pub fn holds_speed(&self) -> bool {
        !self.permits().allow(&[Permit::Speed])
    }
}
