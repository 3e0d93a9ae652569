//! Events for sound, display and summaries: spatter, smoke, fire, steam, cuts.

use std::collections::VecDeque;

use serde::{Deserialize, Serialize};

/// Kind of an event.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, PartialOrd, Ord, Serialize)]
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
    /// A food is halved on the board; amount: its mass [kg].
    Halved,
    /// The hob states that the pan is as hot as it is to be held; amount: that temperature [K].
    DialReached,
    /// Water boils in a pan that is to be held hotter; amount: that temperature [K].
    BoilsBelowDial,
}

impl EventKind {
    /// All kinds in declaration order.
    pub const ALL: [Self; 10] = [
        Self::Spatter,
        Self::Pop,
        Self::SmokeBegins,
        Self::FlashPoint,
        Self::Fire,
        Self::WaterInHotOil,
        Self::SteamReleased,
        Self::Halved,
        Self::DialReached,
        Self::BoilsBelowDial,
    ];

    /// Returns true if the amounts are masses, which add up; temperatures do not.
    pub fn is_additive(self) -> bool {
        !matches!(self, Self::SmokeBegins | Self::FlashPoint | Self::Fire | Self::DialReached | Self::BoilsBelowDial)
    }

    /// Returns true if the event is a fire hazard.
    pub fn is_fire_hazard(self) -> bool {
        matches!(self, Self::FlashPoint | Self::Fire)
    }

    /// Returns true if summaries warn of it.
    pub fn warns(self) -> bool {
        self.is_fire_hazard() || self == Self::BoilsBelowDial
    }

    /// Returns advice for the cook, or `None` if the event is harmless.
    pub fn advice(self) -> Option<&'static str> {
        match self {
            Self::SmokeBegins => Some("the oil smokes: turn the hob down"),
            Self::FlashPoint => Some("the oil passed its flash point: turn the hob off and take the pan off it"),
            Self::Fire => Some("the oil burned: take the pan off the hob and put the lid on, never water"),
            Self::WaterInHotOil => Some("water went into hot oil: it spatters and can burn you"),
            Self::BoilsBelowDial => Some("water boils in the pan: it gets as hot as it is set only without it"),
            Self::Spatter | Self::Pop | Self::SteamReleased | Self::Halved | Self::DialReached => None,
        }
    }
}

/// An event at a time and place.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct Event {
    /// Time [s].
    pub time_s: f64,
    /// Kind.
    pub kind: EventKind,
    /// Place in the pan's frame; the origin is the centre of the floor [m].
    pub at: [f64; 3],
    /// Amount in the unit of the kind.
    pub amount: f64,
}

/// Summary of all events of one kind.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct Tally {
    /// Kind.
    pub kind: EventKind,
    /// Number of events [-].
    pub count: u64,
    /// Sum of the masses or highest temperature, in the unit of the kind.
    pub amount: f64,
    /// Time of the first event [s].
    pub first_s: f64,
    /// Time of the last event [s].
    pub last_s: f64,
}

/// Number of single events kept [-] (chosen: some minutes of lively frying). Tallies count all events.
const KEPT: usize = 512;

/// The latest events, and a tally of each kind.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
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
    /// Records an event; the oldest single event is dropped when the log is full.
    pub fn push(&mut self, event: Event) {
        if self.latest.len() == KEPT {
            self.latest.pop_front();
        }
        let tally = &mut self.tallies[event.kind as usize];
        if tally.count == 0 {
            tally.first_s = event.time_s;
        }
        tally.count += 1;
        tally.amount =
            if event.kind.is_additive() { tally.amount + event.amount } else { tally.amount.max(event.amount) };
        tally.last_s = event.time_s;
        self.latest.push_back(event);
    }

    /// Returns the latest events, oldest first.
    pub fn latest(&self) -> impl DoubleEndedIterator<Item = &Event> {
        self.latest.iter()
    }

    /// Returns the tally of one kind.
    pub fn tally(&self, kind: EventKind) -> &Tally {
        &self.tallies[kind as usize]
    }

    /// Returns the tallies of the kinds that occurred.
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
