//! The emergency stop at the keyboard: Enter.

use std::io::IsTerminal;
use std::sync::mpsc::{Receiver, channel};

use crate::output::stderr;

/// Hears of Enter; of nothing where stdin is no keyboard.
pub fn listen() -> Receiver<()> {
    let (pressed, hear) = channel();
    if std::io::stdin().is_terminal() {
        stderr::say("Enter is the emergency stop");
        std::thread::spawn(move || {
            let mut line = String::new();
            if std::io::stdin().read_line(&mut line).is_ok() {
                // Nobody listens any more when the check is over.
                let _ = pressed.send(());
            }
        });
    }
    hear
}
