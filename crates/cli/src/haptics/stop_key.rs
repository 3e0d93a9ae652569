//! The emergency stop on the keyboard: Enter.

use std::io::IsTerminal;
use std::sync::mpsc::{Receiver, channel};

use crate::output::stderr;

/// Returns a channel that receives a message when Enter is pressed; it stays empty if stdin is not a terminal.
pub fn listen() -> Receiver<()> {
    let (pressed, stop) = channel();
    if std::io::stdin().is_terminal() {
        stderr::say("Enter is the emergency stop");
        std::thread::spawn(move || {
            let mut line = String::new();
            if std::io::stdin().read_line(&mut line).is_ok() {
                // The receiver is gone once the check is over.
                let _ = pressed.send(());
            }
        });
    }
    stop
}
