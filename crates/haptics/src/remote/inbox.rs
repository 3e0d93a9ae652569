//! The inbox of a networked device: the newest data of its network thread, taken without locks.

use crate::remote::network_thread::NetworkThread;

/// Newest data of a network thread; dropping the inbox ends the thread.
pub struct Inbox<T: Copy + Send> {
    incoming: triple_buffer::Output<T>,
    last: T,
    _thread: Option<NetworkThread>,
}

impl<T: Copy + Send + Default> Inbox<T> {
    /// Creates an inbox of a thread, or of a test's buffer without one.
    pub fn new(incoming: triple_buffer::Output<T>, thread: Option<NetworkThread>) -> Self {
        Self { incoming, last: T::default(), _thread: thread }
    }

    /// Takes the newest data and returns the data before it.
    pub fn receive(&mut self) -> T {
        std::mem::replace(&mut self.last, *self.incoming.read())
    }

    /// Returns the data that was taken last.
    pub fn last(&self) -> &T {
        &self.last
    }
}

/// Returns the age of data after a step of `dt` [s]: zero if the data is fresh.
pub fn age(before: f64, fresh: bool, dt: f64) -> f64 {
    if fresh { 0.0 } else { before + dt }
}
