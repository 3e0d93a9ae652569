//! What happens at a moment, for ears, eyes and summaries: spatter, smoke that begins, fire.

use std::collections::VecDeque;

use serde::Serialize;

/// What happened.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum EventKind {
    /// A drop of oil flies off; amount: its mass [kg].
    Spatter,
    /// A drop of water bursts under oil; amount: mass of oil that flies off [kg].
    Pop,
    /// Oil begins to smoke; amount: its temperature [K].
    SmokeBegins,
    /// Oil passes its flash point; amount: its temperature [K].
    FlashPoint,
    /// Oil catches fire; amount: its temperature [K].
    Fire,
    /// Water is thrown into hot oil; amount: its mass [kg].
    WaterInHotOil,
    /// The lid is taken off; amount: steam that rises [kg].
    SteamReleased,
    /// A food is cut in halves on the board; amount: its mass [kg].
    Halved,
}

impl EventKind {
    /// All kinds, in their order.
    pub const ALL: [Self; 8] = [
        Self::Spatter,
        Self::Pop,
        Self::SmokeBegins,
        Self::FlashPoint,
        Self::Fire,
        Self::WaterInHotOil,
        Self::SteamReleased,
        Self::Halved,
    ];

    /// Whether its amounts add up, as masses do and temperatures do not.
    pub fn adds_up(self) -> bool {
        !matches!(self, Self::SmokeBegins | Self::FlashPoint | Self::Fire)
    }

    /// Whether it can burn the kitchen down: summaries warn of it.
    pub fn endangers(self) -> bool {
        matches!(self, Self::FlashPoint | Self::Fire)
    }

    /// What the cook should know and do; nothing about what is harmless.
    pub fn advice(self) -> Option<&'static str> {
        match self {
            Self::SmokeBegins => Some("the oil smokes: turn the hob down"),
            Self::FlashPoint => Some("the oil passed its flash point: turn the hob off and take the pan off it"),
            Self::Fire => Some("the oil burned: take the pan off the hob and put the lid on, never water"),
            Self::WaterInHotOil => Some("water went into hot oil: it spatters and can burn you"),
            Self::Spatter | Self::Pop | Self::SteamReleased | Self::Halved => None,
        }
    }
}

/// Something that happened.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Event {
    /// When [s].
    pub time_s: f64,
    /// What.
    pub kind: EventKind,
    /// Where, from the middle of the pan's floor, in the pan's frame [m].
    pub at: [f64; 3],
    /// How much, in the unit of its kind.
    pub amount: f64,
}

/// All events of one kind.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Tally {
    /// What.
    pub kind: EventKind,
    /// How often.
    pub count: u64,
    /// Sum of the masses, or the highest temperature, in the unit of the kind.
    pub amount: f64,
    /// When first [s].
    pub first_s: f64,
    /// When last [s].
    pub last_s: f64,
}

/// Events that are kept one by one (chosen: some minutes of lively frying); tallies count all.
const KEPT: usize = 512;

/// The latest events, and tallies of all.
#[derive(Clone, Debug, PartialEq)]
pub struct EventLog {
    latest: VecDeque<Event>,
    tallies: [Tally; EventKind::ALL.len()],
}

impl Default for EventLog {
    fn default() -> Self {
        let none = |kind| Tally { kind, count: 0, amount: 0.0, first_s: 0.0, last_s: 0.0 };
        Self { latest: VecDeque::with_capacity(KEPT), tallies: EventKind::ALL.map(none) }
    }
}

impl EventLog {
    /// Notes an event; forgets the oldest one where too many are kept.
    pub fn push(&mut self, event: Event) {
        if self.latest.len() == KEPT {
            self.latest.pop_front();
        }
        let tally = &mut self.tallies[event.kind as usize];
        if tally.count == 0 {
            tally.first_s = event.time_s;
        }
        tally.count += 1;
        tally.amount = if event.kind.adds_up() { tally.amount + event.amount } else { tally.amount.max(event.amount) };
        tally.last_s = event.time_s;
        self.latest.push_back(event);
    }

    /// The latest events, oldest first.
    pub fn latest(&self) -> impl DoubleEndedIterator<Item = &Event> {
        self.latest.iter()
    }

    /// All events of one kind.
    pub fn tally(&self, kind: EventKind) -> &Tally {
        &self.tallies[kind as usize]
    }

    /// Tallies of the kinds that happened.
    pub fn tallies(&self) -> impl Iterator<Item = &Tally> {
        self.tallies.iter().filter(|t| t.count > 0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tallies_count_what_the_list_has_forgotten() {
        let mut log = EventLog::default();
        for i in 0..2 * KEPT {
            log.push(Event { time_s: i as f64, kind: EventKind::Pop, at: [0.0; 3], amount: 0.5 });
        }
        assert_eq!(log.latest().count(), KEPT);
        assert_eq!(log.latest().next().map(|e| e.time_s), Some(KEPT as f64));
        let tally = log.tally(EventKind::Pop);
        assert_eq!((tally.count, tally.amount, tally.first_s), (2 * KEPT as u64, KEPT as f64, 0.0));
        assert_eq!(log.tallies().count(), 1);
    }

    #[test]
    fn every_kind_stands_at_its_own_place() {
        assert!(EventKind::ALL.iter().enumerate().all(|(i, kind)| *kind as usize == i));
    }
}
