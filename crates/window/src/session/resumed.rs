//! A session that was recorded, at its end.

use std::sync::Arc;

use saute_recipe::session::ReplayError;
use saute_recipe::{Cook, Recording};

use super::Session;
use super::mark::{Mark, step_label};

impl Session {
    /// Goes to the end of a recorded session, paused; its recipe goes on if nobody had taken over.
    pub fn resume(&mut self, recording: Recording) -> Result<(), ReplayError> {
        let plays = recording.beginning().plays && !recording.is_taken_over();
        let mut cook = Cook::again(recording, Arc::clone(&self.library))?;
        while cook.stopped().is_none() {
            // A step that failed has ended the recipe then, too.
            let _ = cook.advance();
        }
        self.recipe = Some(cook.runner.recipe().as_ref().clone());
        self.runner = Some(cook.runner).filter(|runner| plays && runner.stopped().is_none());
        self.kitchen = cook.kitchen;
        self.begin();
        self.recorder = cook.recorder;
        self.marks = cook.steps.iter().map(|step| Mark { time_s: step.time_s, label: step_label(step) }).collect();
        self.paused = true;
        Ok(())
    }
}
