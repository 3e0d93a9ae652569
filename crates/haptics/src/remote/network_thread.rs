//! A thread that talks over a network for a device, and has ended when the device is gone.

use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{Builder, JoinHandle, sleep};
use std::time::{Duration, Instant};

/// How long the end of a thread is waited for (chosen: all end within 50 ms, but one that is just connecting or shaking hands takes
/// half a second for each; beyond that it ends by itself and nobody waits).
const LONGEST_END: Duration = Duration::from_secs(1);
/// Time between two looks whether it has ended (chosen: short beside the 50 ms).
const LOOK: Duration = Duration::from_millis(1);

/// A thread that ends with this: sockets that it owns are free, and last words are said, before the device's successor comes.
#[derive(Debug)]
pub struct NetworkThread {
    end: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl NetworkThread {
    /// Starts a thread, which is told by a flag to end.
    pub fn spawn(name: &str, run: impl FnOnce(Arc<AtomicBool>) + Send + 'static) -> io::Result<Self> {
        let end = Arc::new(AtomicBool::new(false));
        let told = Arc::clone(&end);
        let thread = Builder::new().name(name.into()).spawn(move || run(told))?;
        Ok(Self { end, thread: Some(thread) })
    }
}

impl Drop for NetworkThread {
    fn drop(&mut self) {
        self.end.store(true, Ordering::Release);
        let Some(thread) = self.thread.take() else { return };
        let patience = Instant::now() + LONGEST_END;
        while !thread.is_finished() && Instant::now() < patience {
            sleep(LOOK);
        }
        if thread.is_finished() {
            // A thread that broke off has nothing more to say.
            let _ = thread.join();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_thread_has_said_its_last_words_when_it_is_dropped() {
        let said = Arc::new(AtomicBool::new(false));
        let words = Arc::clone(&said);
        let thread = NetworkThread::spawn("test", move |end| {
            while !end.load(Ordering::Acquire) {
                sleep(LOOK);
            }
            sleep(Duration::from_millis(30));
            words.store(true, Ordering::Release);
        });
        drop(thread.expect("a thread"));
        assert!(said.load(Ordering::Acquire));
    }

    #[test]
    fn a_thread_that_does_not_end_is_not_waited_for() {
        let begun = Instant::now();
        drop(NetworkThread::spawn("test", |_| sleep(Duration::from_secs(20))).expect("a thread"));
        assert!(begun.elapsed() < Duration::from_secs(5));
    }
}
