//! A session that was recorded, played again up to its end.

use std::borrow::Cow;
use std::sync::Arc;

use web_time::{Duration, Instant};

use saute_kitchen::Library;
use saute_recipe::Recording;
use saute_recipe::session::ReplayError;

use super::Session;
use crate::hands::Hands;

impl<H: Hands> Session<H> {
    /// Begins to play a recorded session again, up to its end, in slices of a frame's time ([`Self::travel_on`]). Curves, marks and
    /// keyframes come back on the way; time is then stopped. Its recipe goes on if nobody had taken over.
    ///
    /// # Errors
    ///
    /// If the library has not what the session needs.
    pub fn resume(&mut self, recording: Recording) -> Result<(), ReplayError> {
        let library = self.library_of(&recording)?;
        let recipe = recording.beginning().recipe(&library)?;
        self.begin_in(library, Arc::new(recipe), recording.beginning().plays)?;
        self.lay_ahead(recording);
        self.set_paused(true);
        self.timeline.catches_up = self.lies_ahead();
        Ok(())
    }

    /// The library of the kitchen in which a cook was recorded: it goes on there.
    pub(super) fn library_of(&self, recording: &Recording) -> Result<Arc<Library>, ReplayError> {
        Ok(match recording.beginning().library(self.home())? {
            Cow::Borrowed(_) => Arc::clone(self.home()),
            Cow::Owned(there) => Arc::new(there),
        })
    }

    /// Plays on to the recording's last frame, which may be within a tick, for no longer than `budget`; at least a tick.
    pub(super) fn catch_up(&mut self, budget: Duration) {
        let begun = Instant::now();
        self.timeline.catches_up = false;
        while self.lies_ahead() {
            // A step that failed has ended the recipe then, too.
            let is_tick_over = self.frame().unwrap_or(true);
            if is_tick_over && begun.elapsed() >= budget {
                break;
            }
        }
        self.set_paused(true);
        self.timeline.catches_up = self.lies_ahead();
    }
}
