//! The cook that goes on is kept, so that a window that is closed, or killed, can go on with it.

use crate::Session;
use crate::hands::Hands;
use saute_recipe::Recording;
use web_time::{Duration, Instant};

/// Wall time between two writings (chosen: a second is lost at most, with room for a slow disk).
const KEPT_EVERY: Duration = Duration::from_millis(400);

/// The place in which one cook is kept: a file, or the storage of a browser.
pub trait CookStore {
    /// Begins with the content of a cook, in place of what was kept here before.
    ///
    /// # Errors
    ///
    /// The reason why nothing can be kept.
    fn begin(&mut self, bytes: &[u8]) -> Result<(), String>;

    /// Appends what happened since.
    ///
    /// # Errors
    ///
    /// The reason why nothing more can be kept; a browser reports it some time after.
    fn append(&mut self, bytes: &[u8]) -> Result<(), String>;
}

/// What was last handed to the store.
#[derive(Clone, Copy)]
pub struct Written {
    /// Number of the line of time.
    line: u64,
    at: Instant,
    /// How far that line had come [s].
    pub time_s: f64,
    /// True if it went on beyond what is kept of one cook.
    is_full: bool,
}

/// The cook that is kept.
#[derive(Default)]
pub struct Autosave {
    /// Where it is kept; none where nothing is.
    pub store: Option<Box<dyn CookStore>>,
    /// What was last handed to the store.
    pub kept: Option<Written>,
    /// The cook that was kept when the window opened, until it is decided about.
    pub offered: Option<Recording>,
}

impl Autosave {
    /// Writes what happened since; returns true once for a cook that has become too long to be kept further.
    ///
    /// # Errors
    ///
    /// The reason why nothing more is kept.
    pub fn follow<H: Hands>(&mut self, session: &mut Session<H>, at_once: bool) -> Result<bool, String> {
        let Some(store) = &mut self.store else { return Ok(false) };
        let Some((line, recording)) = session.unsaved() else { return Ok(false) };
        match self.kept {
            Some(kept) if kept.line == line => {
                if !at_once && kept.at.elapsed() < KEPT_EVERY {
                    return Ok(false);
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
        let is_full = recording.is_full();
        let was_full = self.kept.is_some_and(|kept| kept.line == line && kept.is_full);
        self.kept = Some(Written { line, at: Instant::now(), time_s: recording.moment().time_s(), is_full });
        Ok(is_full && !was_full)
    }
}
