//! Signals that end a cook: SIGINT (Ctrl C) and SIGTERM.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;

/// True once a signal has requested that the program end.
#[derive(Clone, Debug, Default)]
pub struct Interruption {
    asked: Arc<AtomicBool>,
}

impl Interruption {
    /// Watches for signals from now on. Where they cannot be watched, they end the program as usual.
    pub fn watch() -> Self {
        let interruption = Self::default();
        for signal in [SIGINT, SIGTERM] {
            // A second signal ends the program at once, also where the first one is not noticed.
            let _ = flag::register_conditional_shutdown(signal, 130, Arc::clone(&interruption.asked));
            let _ = flag::register(signal, Arc::clone(&interruption.asked));
        }
        interruption
    }

    /// Returns true once a signal has requested that the program end.
    pub fn is_asked(&self) -> bool {
        self.asked.load(Ordering::Relaxed)
    }
}
