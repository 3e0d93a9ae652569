//! Signals that end the program (SIGTERM, SIGINT, and SIGHUP of a closed terminal): running devices are stopped first.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, OnceLock};

#[cfg(unix)]
use signal_hook::consts::SIGHUP;
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::{flag, low_level};

/// Exit code of a program that a second signal ends at once (128 + SIGINT, as shells report it).
const EXIT_CODE: i32 = 130;

/// State of the signals, shared by all control loops of the program.
#[derive(Debug, Default)]
struct Signals {
    /// Signal that has requested that the program end; 0 for none.
    asked: Arc<AtomicUsize>,
    is_asked: Arc<AtomicBool>,
    /// True once a signal of a person or a service manager has come: another one then ends the program at once.
    is_insisted: Arc<AtomicBool>,
    /// True while no loop runs: a signal then ends the program at once.
    unattended: Arc<AtomicBool>,
    loops: AtomicUsize,
}

static SIGNALS: OnceLock<Signals> = OnceLock::new();

/// A control loop's interest in signals; the last one that is dropped after a signal ends the program.
#[derive(Debug)]
pub(crate) struct EndSignals(&'static Signals);

impl EndSignals {
    /// Watches for signals until this is dropped. Where they cannot be watched, they end the program as usual.
    pub fn watch() -> Self {
        let signals = SIGNALS.get_or_init(Signals::register);
        signals.loops.fetch_add(1, Ordering::AcqRel);
        signals.unattended.store(false, Ordering::Release);
        Self(signals)
    }

    /// Returns true once a signal has requested that the program end.
    pub fn is_asked(&self) -> bool {
        self.0.is_asked.load(Ordering::Acquire)
    }
}

impl Drop for EndSignals {
    fn drop(&mut self) {
        if self.0.loops.fetch_sub(1, Ordering::AcqRel) > 1 {
            return;
        }
        self.0.unattended.store(true, Ordering::Release);
        let signal = self.0.asked.load(Ordering::Acquire);
        if signal != 0 {
            // All devices are stopped: now the signal does what it does without a device.
            let _ = low_level::emulate_default_handler(signal as i32);
        }
    }
}

impl Signals {
    fn register() -> Self {
        let signals = Self::default();
        for signal in [SIGINT, SIGTERM] {
            signals.end_at(signal);
        }
        signals.end_with_terminal();
        signals
    }

    /// Lets a signal end the program; a second one ends it at once, even if a loop hangs.
    fn end_at(&self, signal: i32) {
        let _ = flag::register_conditional_default(signal, Arc::clone(&self.unattended));
        let _ = flag::register_conditional_shutdown(signal, EXIT_CODE, Arc::clone(&self.is_insisted));
        let _ = flag::register(signal, Arc::clone(&self.is_insisted));
        self.ask_at(signal);
    }

    fn ask_at(&self, signal: i32) {
        let _ = flag::register_usize(signal, Arc::clone(&self.asked), signal as usize);
        let _ = flag::register(signal, Arc::clone(&self.is_asked));
    }

    /// Lets a closed terminal end the program, unless it was started to outlive its terminal.
    ///
    /// Kernel, shell and terminal each send SIGHUP, and some send SIGTERM right after it: none of these may cut the stops short.
    #[cfg(unix)]
    fn end_with_terminal(&self) {
        if is_hangup_ignored() {
            return;
        }
        let _ = flag::register_conditional_default(SIGHUP, Arc::clone(&self.unattended));
        self.ask_at(SIGHUP);
    }

    /// Other systems have no such signal.
    #[cfg(not(unix))]
    fn end_with_terminal(&self) {}
}

/// Returns true if the program was started with SIGHUP ignored, as `nohup` does; known on Linux only.
#[cfg(unix)]
fn is_hangup_ignored() -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| u64::from_str_radix(line.strip_prefix("SigIgn:")?.trim(), 16).ok());
    mask.is_some_and(|mask| mask >> (SIGHUP - 1) & 1 == 1)
}
