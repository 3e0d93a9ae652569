//! Notices: sentences that are shown for a while and kept in a list.

use std::collections::VecDeque;
use std::path::PathBuf;
use std::sync::{Arc, Mutex};

use web_time::Instant;

/// How long a sentence stays over the scene [s].
const STAYS_S: f32 = 7.0;
/// Sentences that are kept at most (chosen: those of an evening).
const KEPT: usize = 100;

/// A sentence that was shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Said {
    /// The sentence.
    pub text: String,
    /// The file that it is about, if it can be shown.
    pub file: Option<PathBuf>,
    /// How many were shown before it.
    pub number: u64,
    /// When.
    at: Instant,
}

/// All notices; clones add to the same list, so that a picture saved later can be reported.
#[derive(Clone, Debug, Default)]
pub struct Notice {
    said: Arc<Mutex<VecDeque<Said>>>,
}

impl Notice {
    /// Shows a sentence; it replaces the one before.
    pub fn say(&self, text: impl Into<String>) {
        self.keep(text.into(), None);
    }

    /// Shows a sentence about a file.
    pub fn say_of(&self, text: impl Into<String>, file: PathBuf) {
        self.keep(text.into(), Some(file));
    }

    fn keep(&self, text: String, file: Option<PathBuf>) {
        let Ok(mut said) = self.said.lock() else { return };
        let number = said.back().map_or(1, |last| last.number + 1);
        // What is shown again is kept once.
        if said.back().is_some_and(|last| last.text == text) {
            said.pop_back();
        }
        said.push_back(Said { text, file, number, at: Instant::now() });
        if said.len() > KEPT {
            said.pop_front();
        }
    }

    /// Returns the last sentence while it is shown.
    pub fn current(&self) -> Option<Said> {
        let said = self.said.lock().ok()?;
        said.back().filter(|last| last.at.elapsed().as_secs_f32() < STAYS_S).cloned()
    }

    /// Returns what was shown after the sentence of a number, the first first.
    pub fn after(&self, number: u64) -> Vec<Said> {
        let Ok(said) = self.said.lock() else { return Vec::new() };
        said.iter().filter(|one| one.number > number).cloned().collect()
    }

    /// Returns all that was shown, the last first.
    pub fn all(&self) -> Vec<Said> {
        self.said.lock().map(|said| said.iter().rev().cloned().collect()).unwrap_or_default()
    }
}

impl Said {
    /// How long ago it was shown [s].
    pub fn ago_s(&self) -> f32 {
        self.at.elapsed().as_secs_f32()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_said_is_kept_once_and_the_last_comes_first() {
        let notice = Notice::default();
        ["one", "two", "two"].into_iter().for_each(|text| notice.say(text));
        let texts: Vec<String> = notice.all().into_iter().map(|said| said.text).collect();
        assert_eq!(texts, ["two", "one"]);
        (0..2 * KEPT).for_each(|n| notice.say(n.to_string()));
        assert_eq!(notice.all().len(), KEPT);
    }
}
