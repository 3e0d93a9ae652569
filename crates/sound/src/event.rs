//! What sounds once: blows, drops, signals.

/// Time from one snapshot to the next [s].
pub const TICK_S: f32 = 0.1;

/// Kind of an event.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EventKind {
    /// Food comes to lie in the pan.
    Put,
    /// Food is turned over and falls back.
    Flip,
    /// Wet food falls onto a plane face.
    Slap,
    /// Metal or food slides over the floor.
    Scrape,
    /// Metal strikes the pan.
    Clank,
    /// The lid is laid on or taken off.
    Lid,
    /// Liquid is poured in.
    Pour,
    /// A drop of oil flies off, or a drop of water bursts under oil.
    Spatter,
    /// A drop falls into liquid.
    Drop,
    /// The pan is set onto the wet cloth.
    WetCloth,
    /// Food comes to lie on the board.
    Board,
    /// A bell rings.
    Bell,
}

impl EventKind {
    /// All kinds, in declaration order.
    pub const ALL: [Self; 12] = [
        Self::Put,
        Self::Flip,
        Self::Slap,
        Self::Scrape,
        Self::Clank,
        Self::Lid,
        Self::Pour,
        Self::Spatter,
        Self::Drop,
        Self::WetCloth,
        Self::Board,
        Self::Bell,
    ];
}

/// An event within a tick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// Kind.
    pub kind: EventKind,
    /// Strength, from 0 to 1 [-].
    pub strength: f32,
    /// Time since the tick began [s], below [`crate::TICK_S`].
    pub at_s: f32,
    /// Place from left (−1) to right (1) [-]. Single drops are heard there; what is struck sounds from the middle.
    pub side: f32,
}

impl Event {
    /// An event at the beginning of a tick, in the middle.
    pub fn now(kind: EventKind, strength: f32) -> Self {
        Self { kind, strength, at_s: 0.0, side: 0.0 }
    }

    /// Returns the event within its ranges; none if it has no strength or one of its values is not a number.
    pub(crate) fn within_ranges(&self) -> Option<Self> {
        let (strength, at_s) = (self.strength.clamp(0.0, 1.0), self.at_s.clamp(0.0, TICK_S));
        let side = self.side.clamp(-1.0, 1.0);
        let is_heard = strength > 0.0 && !at_s.is_nan() && !side.is_nan();
        is_heard.then_some(Self { kind: self.kind, strength, at_s, side })
    }
}
