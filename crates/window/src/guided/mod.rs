//! A cook that a study or a lesson leads: it decides what is set out, shown and locked, and asks.

mod lesson_desk;
#[cfg(not(target_arch = "wasm32"))]
mod log_file;
mod permits;
mod study_desk;
#[cfg(test)]
mod walk;

pub use self::lesson_desk::{LessonDesk, LessonStart};
pub(crate) use self::study_desk::is_out;
pub use self::study_desk::{StudyDesk, StudyStart};
use saute_session::permits::{Permit, Permits};

/// What leads the cook.
pub enum Guided {
    /// A study.
    Study(Box<StudyDesk>),
    /// A lesson.
    Lesson(Box<LessonDesk>),
}

impl Guided {
    /// Returns true while a card asks; time waits behind it.
    pub fn asks(&self) -> bool {
        match self {
            Self::Study(desk) => !desk.is_running(),
            Self::Lesson(desk) => desk.asks(),
        }
    }

    /// Returns true if what cannot be seen in a kitchen is hidden.
    pub fn hides_read_outs(&self) -> bool {
        match self {
            Self::Study(desk) => desk.hides_read_outs(),
            Self::Lesson(desk) => desk.hides_read_outs(),
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
        self.asks() || self.permits().allow(&[Permit::Pause])
    }
}
