//! What is heard of the kitchen that is shown, as captions and level show it.

use saute_kitchen::Kitchen;
use saute_sound::{Event, Snapshot};

use super::Ear;
use super::caption::nearer;

/// Time in which captions and level follow what is heard [s] (chosen: words that change faster cannot be read).
const READ_S: f64 = 0.7;

/// Listens to the kitchen that is shown.
#[derive(Default)]
pub struct Hearing {
    /// Who listens to the kitchen of a number.
    ear: Option<(u64, Ear)>,
    shown: Snapshot,
    /// When that was [s].
    shown_at: f64,
}

impl Hearing {
    /// What is heard, as captions and level show it.
    pub fn shown(&self) -> Snapshot {
        self.shown
    }

    /// Listens to the kitchen of a number at a time [s]; of another one what happened before is not heard.
    pub fn hear(&mut self, kitchen: &Kitchen, number: u64, now: f64) -> (Snapshot, Vec<Event>) {
        let ear = self.ear.take().filter(|(of, _)| *of == number).map(|(_, ear)| ear);
        let mut ear = ear.unwrap_or_else(|| Ear::new(kitchen));
        let (snapshot, events) = ear.hear(kitchen);
        self.ear = Some((number, ear));
        let share = 1.0 - (-(now - self.shown_at).max(0.0) / READ_S).exp();
        self.shown = nearer(&self.shown, &snapshot, share as f32);
        self.shown_at = now;
        (snapshot, events)
    }
}
