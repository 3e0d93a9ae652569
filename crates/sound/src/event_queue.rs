//! Events that wait for their sample.

use alloc::vec::Vec;

use crate::event::Event;

/// Largest number of events that wait [-] (chosen: three ticks of the liveliest spatter, ten a tick, with the blows of two hands).
const MOST: usize = 32;

/// An event and the sample at which it starts.
#[derive(Clone, Copy, Debug)]
struct Waiting {
    at: u64,
    event: Event,
}

/// A bounded queue: when it is full the weakest event is dropped and counted.
#[derive(Clone, Debug)]
pub(crate) struct EventQueue {
    waiting: Vec<Waiting>,
    dropped: u64,
}

impl EventQueue {
    pub(crate) fn new() -> Self {
        Self { waiting: Vec::with_capacity(MOST), dropped: 0 }
    }

    /// Number of events that were dropped [-].
    pub(crate) fn dropped(&self) -> u64 {
        self.dropped
    }

    /// Adds an event that starts at a sample.
    pub(crate) fn push(&mut self, at: u64, event: Event) {
        if self.waiting.len() == MOST {
            self.dropped += 1;
            let weakest = (0..MOST).min_by(|a, b| self.strength(*a).total_cmp(&self.strength(*b)));
            match weakest {
                Some(weakest) if self.strength(weakest) < event.strength => drop(self.waiting.remove(weakest)),
                _ => return,
            }
        }
        self.waiting.push(Waiting { at, event });
    }

    /// Takes the next event that is due at a sample; those of one sample in the order in which they came.
    pub(crate) fn due(&mut self, now: u64) -> Option<Event> {
        let next = self.waiting.iter().position(|waiting| waiting.at <= now)?;
        Some(self.waiting.remove(next).event)
    }

    fn strength(&self, index: usize) -> f32 {
        self.waiting[index].event.strength
    }
}
