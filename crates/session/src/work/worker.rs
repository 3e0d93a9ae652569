//! How one kind of work is done, wherever that is.

use web_time::Duration;

/// How one kind of work is done.
pub trait Worker {
    /// Takes an order in place of the one before; one that is empty, or cannot be read, is none.
    fn take(&mut self, order: &[u8]);

    /// Returns true while there is something to do.
    fn is_busy(&self) -> bool;

    /// Works on for about `budget`; returns an answer where one is due.
    fn go_on(&mut self, budget: Duration) -> Option<Vec<u8>>;

    /// Takes what was done here since the last call, for a twin that has the same order.
    fn share(&mut self) -> Option<Vec<u8>> {
        None
    }

    /// Takes what a twin has done; of another order it changes nothing.
    fn take_shared(&mut self, _shares: &[u8]) {}
}
