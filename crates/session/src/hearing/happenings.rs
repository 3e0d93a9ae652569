//! What happened in a tick, as blows and drops: differences between two looks at a kitchen.

use std::collections::BTreeMap;

use saute_kitchen::{Event as Told, EventKind as What, Kitchen, Piece, Place};
use saute_sound::{Event, EventKind};

/// Mass of food that falls with full strength [kg] (chosen: a large steak), of liquid that is poured with it [kg] (chosen: a small
/// glass), and of a drop of oil that flies off with it [kg] (chosen: ten times the mean).
const FOOD_KG: f64 = 0.4;
const LIQUID_KG: f64 = 0.1;
const DROP_KG: f64 = 1e-6;
/// Least liquid that counts as poured [kg] (chosen: more than drips or melts in a tick).
const POURED_KG: f64 = 2e-3;
/// Strengths of what has no mass [-] (chosen: below those of food).
const LID: f32 = 0.5;
const TOOL: f32 = 0.15;
const SCRAPE: f32 = 0.4;
const CLOTH: f32 = 0.8;
const BELL: f32 = 0.7;
const WATER_IN_OIL: f32 = 1.0;
/// Distance from the middle that is heard wholly at a side [m] (chosen: a pan's radius).
const WIDE_M: f64 = 0.13;
/// Least time between two flips of a piece [s] (chosen: its contact settles within some ticks).
const SAME_FLIP_S: f64 = 0.5;

/// What is remembered of a piece.
#[derive(Clone, Copy, Debug)]
struct Seen {
    /// Its last place that was not a tool.
    place: Place,
    flipped_at: f64,
}

/// What is remembered of a kitchen.
#[derive(Clone, Debug)]
pub(super) struct Happenings {
    pieces: BTreeMap<u32, Seen>,
    /// Events that were reported so far [-].
    told: u64,
    has_lid: bool,
    has_cloth: bool,
    hand_moves: bool,
    pan_moves: bool,
    /// Water and oil in the pan [kg].
    liquids: [f64; 2],
}

impl Happenings {
    pub(super) fn new(kitchen: &Kitchen) -> Self {
        let seen = |piece: &Piece| (piece.key, Seen::of(piece, piece.place));
        Self {
            pieces: kitchen.pieces().iter().map(seen).collect(),
            told: count_told(kitchen),
            has_lid: kitchen.pan_state().lid.is_some(),
            has_cloth: kitchen.cloth().is_some(),
            hand_moves: kitchen.hand().is_active(),
            pan_moves: kitchen.gesture().is_some(),
            liquids: liquids(kitchen),
        }
    }

    /// Returns what happened since the last look.
    pub(super) fn since(&mut self, kitchen: &Kitchen) -> Vec<Event> {
        let before = core::mem::replace(self, Self { pieces: BTreeMap::new(), ..Self::new(kitchen) });
        let mut events = Vec::new();
        for piece in kitchen.pieces() {
            let last = before.pieces.get(&piece.key).copied().unwrap_or(Seen::of(piece, Place::Waiting));
            events.extend(last.becomes(piece));
            self.pieces.insert(piece.key, Seen::of(piece, last.place));
        }
        events.extend(self.hands(&before));
        events.extend(self.poured(&before));
        let new = self.told.saturating_sub(before.told) as usize;
        events.extend(kitchen.events().latest().rev().take(new).enumerate().filter_map(told));
        events
    }

    /// Lid, cloth, tools and pan: what begins now.
    fn hands(&self, before: &Self) -> impl Iterator<Item = Event> {
        let begins = |now: bool, then: bool| now && !then;
        [
            (self.has_lid != before.has_lid, EventKind::Lid, LID),
            (begins(self.has_cloth, before.has_cloth), EventKind::WetCloth, CLOTH),
            (begins(self.hand_moves, before.hand_moves), EventKind::Clank, TOOL),
            (begins(self.hand_moves, before.hand_moves), EventKind::Scrape, SCRAPE),
            (begins(self.pan_moves, before.pan_moves), EventKind::Scrape, SCRAPE),
        ]
        .into_iter()
        .filter(|(is_heard, ..)| *is_heard)
        .map(|(_, kind, strength)| Event::now(kind, strength))
    }

    fn poured(&self, before: &Self) -> Option<Event> {
        let more = self.liquids.iter().zip(before.liquids).map(|(now, then)| now - then).fold(0.0, f64::max);
        (more > POURED_KG).then(|| Event::now(EventKind::Pour, strength(more, LIQUID_KG)))
    }
}

impl Seen {
    /// Looks at a piece; while a tool holds it, its place is the last one.
    fn of(piece: &Piece, last: Place) -> Self {
        let place = if piece.place == Place::Held { last } else { piece.place };
        Self { place, flipped_at: piece.flipped_at().unwrap_or(f64::NEG_INFINITY) }
    }

    /// Returns how it is heard that a piece is where it is now.
    fn becomes(self, piece: &Piece) -> Option<Event> {
        let now = Self::of(piece, self.place);
        let kind = match (self.place, now.place) {
            (Place::Pan(_), Place::Pan(_)) if now.flipped_at > self.flipped_at + SAME_FLIP_S => EventKind::Flip,
            (Place::Pan(_), Place::Pan(_)) => return None,
            (_, Place::Pan(_)) => EventKind::Put,
            (Place::Waiting | Place::Pan(_), Place::Rest(_)) => EventKind::Board,
            (Place::Pan(_), Place::Glass | Place::Table) => EventKind::Slap,
            _ => return None,
        };
        Some(Event::now(kind, strength(piece.mass(), FOOD_KG)))
    }
}

/// Strength of a blow by its mass over that of a full one [-]: the energy of a fall from one height goes with the mass.
fn strength(mass: f64, full: f64) -> f32 {
    (mass / full).sqrt().min(1.0) as f32
}

/// Water and oil in the pan [kg].
fn liquids(kitchen: &Kitchen) -> [f64; 2] {
    [kitchen.pan_state().water_mass(), kitchen.pan_state().oil_mass()]
}

/// Number of events that the kitchen reported so far [-].
fn count_told(kitchen: &Kitchen) -> u64 {
    kitchen.events().tallies().map(|tally| tally.count).sum()
}

/// Share of a tick between two events that it reports at once [-] (the golden section: never in step).
const APART: f32 = 0.618_034;

/// How an event that the kitchen reports is heard; several of a tick are spread over it.
fn told((number, event): (usize, &Told)) -> Option<Event> {
    let (kind, strength) = match event.kind {
        What::Spatter | What::Pop => (EventKind::Spatter, strength(event.amount, DROP_KG)),
        What::WaterInHotOil => (EventKind::Spatter, WATER_IN_OIL),
        What::DialReached => (EventKind::Bell, BELL),
        What::Halved => (EventKind::Board, SCRAPE),
        What::SmokeBegins | What::FlashPoint | What::Fire | What::SteamReleased | What::BoilsBelowDial => return None,
    };
    let turns = APART * number as f32;
    let at_s = saute_sound::TICK_S * (turns - turns.floor());
    let side = (event.at[0] / WIDE_M).clamp(-1.0, 1.0) as f32;
    Some(Event { kind, strength, at_s, side })
}
