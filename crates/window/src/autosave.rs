//! The cook that goes on is kept, so that a window that is closed, or killed, can go on with it.

#[cfg(not(target_arch = "wasm32"))]
pub(crate) mod cook_file;

use saute_recipe::Recording;
use web_time::{Duration, Instant};

use crate::app::SauteApp;
use crate::session::Session;

/// Wall time between two writings (chosen: a second is lost at most, with room for a slow disk).
const KEPT_EVERY: Duration = Duration::from_millis(400);

/// The place in which one cook is kept: a file, or the storage of a browser.
pub trait CookStore {
    /// Begins with all that a cook holds, in place of what was kept here before.
    ///
    /// # Errors
    ///
    /// Says why nothing can be kept.
    fn begin(&mut self, bytes: &[u8]) -> Result<(), String>;

    /// Appends what happened since.
    ///
    /// # Errors
    ///
    /// Says why nothing more can be kept; a browser tells it some time after.
    fn append(&mut self, bytes: &[u8]) -> Result<(), String>;
}

/// The cook that is kept.
#[derive(Default)]
pub(crate) struct Autosave {
    store: Option<Box<dyn CookStore>>,
    /// Number of the line of time that is kept, and when it was last written.
    kept: Option<(u64, Instant)>,
    /// The cook that was kept when the window opened, until it is decided about.
    pub(crate) offered: Option<Recording>,
}

impl SauteApp {
    /// Keeps the cook from now on. What was kept of an earlier cook is offered first.
    pub fn keep_cook_by(&mut self, store: Box<dyn CookStore>, earlier: Option<&[u8]>) {
        let stored = earlier.and_then(|bytes| Recording::from_file(bytes).ok());
        // A cook in which nothing was done is set out again soon enough.
        let has_begun = |recording: &Recording| !recording.entries().is_empty() || recording.beginning().plays;
        let offered = stored.map(|opened| opened.recording).filter(has_begun);
        self.autosave = Autosave { store: Some(store), kept: None, offered };
    }

    /// How far the cook came with which the window offers to go on [s].
    pub fn offered_s(&self) -> Option<f64> {
        self.autosave.offered.as_ref().map(|recording| recording.moment().time_s())
    }

    /// Goes on with the cook that is offered, or leaves it.
    pub(crate) fn decide_on_offer(&mut self, goes_on: bool) {
        let Some(offered) = self.autosave.offered.take() else { return };
        if !goes_on {
            return;
        }
        if let Err(error) = self.session.resume(offered) {
            self.say_trouble(&error);
        }
    }

    /// Writes what happened, a few times a second, or at once. An error is said once; then nothing is kept any longer.
    pub fn keep_cook(&mut self, at_once: bool) {
        if self.autosave.offered.is_some() {
            return;
        }
        if let Err(error) = self.autosave.follow(&mut self.session, at_once) {
            self.autosave = Autosave::default();
            self.notice.say(self.settings.language.fill("notice.not_kept", &[("error", &error)]));
        }
    }
}

impl Autosave {
    fn follow(&mut self, session: &mut Session, at_once: bool) -> Result<(), String> {
        let Some(store) = &mut self.store else { return Ok(()) };
        let Some((line, recording)) = session.unsaved() else { return Ok(()) };
        match self.kept {
            Some((kept, at)) if kept == line => {
                if !at_once && at.elapsed() < KEPT_EVERY {
                    return Ok(());
                }
                let bytes = recording.unsaved();
                if !bytes.is_empty() {
                    store.append(&bytes)?;
                }
            }
            _ => {
                // Another file may hold a part of it.
                *recording = recording.fork(recording.moment());
                store.begin(&recording.unsaved())?;
            }
        }
        self.kept = Some((line, Instant::now()));
        Ok(())
    }
}
