//! What a participant or a student does in a study or a lesson.

use saute_study::Answers;

/// What a participant or a student does with a card or the ribbon.
#[derive(Clone, Debug, PartialEq)]
pub enum GuidedAct {
    /// Takes part.
    Agree,
    /// Does not take part.
    Decline,
    /// Tries once more whether the machine sustains the speed.
    TryMachine,
    /// Begins the trial that is next.
    BeginTrial,
    /// Ends the trial that runs.
    EndTrial,
    /// Hands in what was entered or answered.
    Answer(Answers),
    /// Writes rows again that could not be written.
    KeepRows,
    /// Saves the log of a page.
    SaveLog,
    /// Opens a shipped lesson by its id.
    Lesson(String),
    /// Begins the cook of the lesson.
    BeginLesson,
    /// Answers the question that waits.
    Predict(f64),
    /// Goes on after the truth was shown.
    GoOn,
    /// Ends the lesson.
    EndLesson,
    /// Saves the result as a file.
    SaveResult,
    /// Copies the result as a line for a sheet.
    CopyResult,
    /// Begins the lesson again.
    AgainLesson,
    /// Leaves the lesson.
    Leave,
    /// Closes the window.
    CloseWindow,
}
