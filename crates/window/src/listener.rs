//! Listeners, which play what is heard in the window: a sound card, a page, a test.

use saute_sound::{Event, Told};

/// Plays what is heard.
pub trait Listener {
    /// Takes what there is to hear. It never waits.
    fn hear(&mut self, told: &Told, events: &[Event]);

    /// Returns why nothing is heard, once for each time that sound is lost.
    fn trouble(&mut self) -> Option<String>;
}
