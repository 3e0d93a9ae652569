//! Whether a file dialog could be shown. The library that shows it returns nothing both where a person cancels and where the system
//! has no dialog (no desktop portal, as on kiosks and bare window managers); only its log distinguishes them.

use crate::desktop::files::DialogAnswer;
use log::{LevelFilter, Log, Metadata, Record};
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

/// The library's name in the log.
const LIBRARY: &str = "rfd";

/// Set once the library has logged an error.
static FAILED: AtomicBool = AtomicBool::new(false);

/// Receives the errors of the library, and nothing else.
struct Hears;

impl Log for Hears {
    fn enabled(&self, metadata: &Metadata) -> bool {
        metadata.level() <= LevelFilter::Error && metadata.target().starts_with(LIBRARY)
    }

    fn log(&self, record: &Record) {
        if self.enabled(record.metadata()) {
            FAILED.store(true, Ordering::SeqCst);
        }
    }

    fn flush(&self) {}
}

/// Shows a dialog; where another log is installed, a dialog that cannot be shown counts as cancelled.
pub(crate) fn show(dialog: impl FnOnce() -> Option<PathBuf>) -> DialogAnswer {
    if log::set_logger(&Hears).is_ok() {
        log::set_max_level(LevelFilter::Error);
    }
    FAILED.store(false, Ordering::SeqCst);
    match dialog() {
        Some(path) => DialogAnswer::Chosen(path),
        None if FAILED.load(Ordering::SeqCst) => DialogAnswer::NotShown,
        None => DialogAnswer::Cancelled,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failure_is_told_from_a_cancel() {
        assert_eq!(show(|| None), DialogAnswer::Cancelled);
        assert_eq!(show(|| Some("a.toml".into())), DialogAnswer::Chosen("a.toml".into()));
        log::error!(target: "wgpu", "something else");
        assert_eq!(show(|| None), DialogAnswer::Cancelled);
        let fails = || {
            log::warn!(target: "rfd::backend", "another way is tried");
            log::error!(target: "rfd::backend", "no way is left");
            None
        };
        assert_eq!(show(fails), DialogAnswer::NotShown);
    }
}
