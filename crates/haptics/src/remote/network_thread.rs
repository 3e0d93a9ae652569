//! The network thread of a device; it ends with the device.

use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{Builder, JoinHandle, sleep};
use std::time::{Duration, Instant};

/// Longest wait for the thread's end (chosen: threads end within 50 ms, but connecting and a handshake take up to half a second each;
/// a slower thread ends by itself later).
const LONGEST_END: Duration = Duration::from_secs(1);
/// Polling interval while waiting for the end (chosen: short compared with the 50 ms).
const POLL: Duration = Duration::from_millis(1);

/// A thread that ends when this is dropped: its sockets are closed and its last message is sent before the drop returns.
#[derive(Debug)]
pub struct NetworkThread {
    end: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl NetworkThread {
    /// Starts a thread; its flag requests the end.
    pub fn spawn(name: &str, run: impl FnOnce(Arc<AtomicBool>) + Send + 'static) -> io::Result<Self> {
        let end = Arc::new(AtomicBool::new(false));
        let requested = Arc::clone(&end);
        let thread = Builder::new().name(name.into()).spawn(move || run(requested))?;
        Ok(Self { end, thread: Some(thread) })
    }
}

impl Drop for NetworkThread {
    fn drop(&mut self) {
        self.end.store(true, Ordering::Release);
        let Some(thread) = self.thread.take() else { return };
        let deadline = Instant::now() + LONGEST_END;
        while !thread.is_finished() && Instant::now() < deadline {
            sleep(POLL);
        }
        if thread.is_finished() {
            // The result of a thread that panicked is of no use.
            let _ = thread.join();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_thread_has_finished_its_work_when_it_is_dropped() {
        let finished = Arc::new(AtomicBool::new(false));
        let work = Arc::clone(&finished);
        let thread = NetworkThread::spawn("test", move |end| {
            while !end.load(Ordering::Acquire) {
                sleep(POLL);
            }
            sleep(Duration::from_millis(30));
            work.store(true, Ordering::Release);
        });
        drop(thread.expect("a thread"));
        assert!(finished.load(Ordering::Acquire));
    }

    #[test]
    fn a_thread_that_does_not_end_is_not_waited_for() {
        let begun = Instant::now();
        drop(NetworkThread::spawn("test", |_| sleep(Duration::from_secs(20))).expect("a thread"));
        assert!(begun.elapsed() < Duration::from_secs(5));
    }
}
