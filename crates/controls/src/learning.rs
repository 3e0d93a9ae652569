//! What is kept of what is taught while cooks go on.

use crate::tutorial::Tutorial;

/// What the window keeps of what it teaches.
#[derive(Debug, Default)]
pub struct Learning {
    /// The tutorial while it runs.
    pub tutorial: Option<Tutorial>,
    /// The cook whose result was shown by itself: when its food came out [s].
    pub shown_for: Option<f64>,
    /// When the food was taken out whose mark was kept last [s].
    pub marked_for: Option<f64>,
}

impl Learning {
    /// Another cook begins: its result was not seen.
    pub fn begin_cook(&mut self) {
        (self.shown_for, self.marked_for) = (None, None);
    }
}
