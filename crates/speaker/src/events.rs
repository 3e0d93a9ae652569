//! Events on their way to the thread that plays: a bounded queue without locks.

use std::sync::mpsc::{Receiver, SyncSender, TrySendError, sync_channel};

use saute_sound::Event;

/// Largest number of events on their way [-] (chosen: those of a slow picture, thirty a second with two hands and lively spatter).
pub const QUEUED: usize = 64;

/// The end at which events go in.
#[derive(Debug)]
pub(crate) struct Events {
    ring: SyncSender<Event>,
    /// Events for which there was no room yet, the strongest first.
    waiting: Vec<Event>,
    dropped: u64,
}

/// Returns both ends of a queue. Neither waits.
pub(crate) fn queue() -> (Events, Receiver<Event>) {
    let (ring, out) = sync_channel(QUEUED);
    (Events { ring, waiting: Vec::with_capacity(QUEUED), dropped: 0 }, out)
}

impl Events {
    /// Sends events, the strongest first. Those for which there is no room wait for the next call; of too many the weakest are dropped.
    pub(crate) fn send(&mut self, events: &[Event]) {
        self.waiting.extend_from_slice(events);
        self.waiting.sort_by(|a, b| b.strength.total_cmp(&a.strength));
        let is_full = |event: &Event| matches!(self.ring.try_send(*event), Err(TrySendError::Full(_)));
        let sent = self.waiting.iter().position(is_full).unwrap_or(self.waiting.len());
        self.waiting.drain(..sent);
        self.dropped += self.waiting.len().saturating_sub(QUEUED) as u64;
        self.waiting.truncate(QUEUED);
    }

    /// Number of events that were dropped [-].
    pub(crate) fn dropped(&self) -> u64 {
        self.dropped
    }
}
