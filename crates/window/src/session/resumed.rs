//! A session that was recorded, played again up to its end.

use std::sync::Arc;

use saute_recipe::Recording;
use saute_recipe::session::ReplayError;

use super::Session;

impl Session {
    /// Goes to the end of a recorded session, paused; its recipe goes on if nobody had taken over. Curves, marks and keyframes come
    /// back on the way.
    ///
    /// # Errors
    ///
    /// If the library has not what the session needs.
    pub fn resume(&mut self, recording: Recording) -> Result<(), ReplayError> {
        let recipe = recording.beginning().recipe(&self.library)?;
        self.begin_with(Arc::new(recipe), recording.beginning().plays)?;
        self.lay_ahead(recording);
        while self.lies_ahead() {
            // A step that failed has ended the recipe then, too.
            let _ = self.tick();
        }
        self.set_paused(true);
        Ok(())
    }
}
