//! The second hand with its queue of tasks, and the tool that a person moves.

use serde::{Deserialize, Serialize};
use std::collections::VecDeque;

use crate::dynamics::{Hand, Task};
use crate::hands::lead::Led;

/// The second hand and its tasks.
#[derive(Clone, Debug, Default, Deserialize, Serialize)]
pub(crate) struct SecondHand {
    /// The hand with its tool.
    pub(crate) hand: Hand,
    /// Tasks to do.
    pub(crate) tasks: VecDeque<Task>,
    /// Present task.
    pub(crate) current: Option<Task>,
    /// Tool that a person moves freely.
    pub(crate) free: Option<Led>,
    /// Tasks that failed because the tool was blocked.
    pub(crate) blocked: Vec<Task>,
}

impl SecondHand {
    /// Returns true while a tool is active or a task is waiting.
    pub(crate) fn is_busy(&self) -> bool {
        self.hand.is_active() || self.has_order()
    }

    /// Returns true while a task is being done or is waiting; a tool that a person moves is none.
    pub(crate) fn has_order(&self) -> bool {
        self.current.is_some() || !self.tasks.is_empty()
    }
}
