//! A cook that a study or a lesson leads: it decides what is set out, shown and locked, and asks.

mod acts;
mod lesson_desk;
mod locks;
#[cfg(not(target_arch = "wasm32"))]
mod log_file;
mod study_desk;

pub use self::acts::GuidedAct;
pub use self::lesson_desk::{LessonDesk, LessonStart};
pub use self::locks::Locks;
pub(crate) use self::study_desk::is_out;
pub use self::study_desk::{StudyDesk, StudyStart};

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

    /// What cannot be done.
    pub fn locks(&self) -> Locks {
        match self {
            Self::Study(desk) => Locks::of_study(desk.hides_read_outs()),
            Self::Lesson(desk) => Locks::of_lesson(&desk.scenario().locked, desk.is_locked(), desk.hides_read_outs()),
        }
    }
}
