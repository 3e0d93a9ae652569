//! Notices: a sentence that is shown for a while.

use std::sync::{Arc, Mutex};

use web_time::Instant;

/// How long a sentence stays [s].
const STAYS_S: f32 = 7.0;

/// The last sentence; clones speak into the same place, so that a picture saved later can say so.
#[derive(Clone, Debug, Default)]
pub struct Notice {
    last: Arc<Mutex<Option<(String, Instant)>>>,
}

impl Notice {
    /// Shows a sentence; it replaces the one before.
    pub fn say(&self, text: impl Into<String>) {
        if let Ok(mut last) = self.last.lock() {
            *last = Some((text.into(), Instant::now()));
        }
    }

    /// Returns the sentence while it is shown.
    pub fn current(&self) -> Option<String> {
        let last = self.last.lock().ok()?;
        last.as_ref().filter(|(_, at)| at.elapsed().as_secs_f32() < STAYS_S).map(|(text, _)| text.clone())
    }
}
