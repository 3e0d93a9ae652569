//! The input of a player as numbers: for a page, whose sound is made by a module with separate memory.

use alloc::vec::Vec;

use crate::event::{Event, EventKind};
use crate::player::Told;
use crate::snapshot::{Snapshot, Steam};
use crate::stove::Stove;
use crate::struck::plate::{Metal, Plate};

/// Numbers before the events, and of each event.
const HEAD: usize = Steam::ALL.len() + 11;
const EVENT: usize = 4;

/// Length of a letter with so many events [numbers].
pub const fn length(events: usize) -> usize {
    HEAD + EVENT * events
}

/// Writes the input of a player, and the events, as numbers.
pub fn written(told: &Told, events: &[Event]) -> Vec<f32> {
    let Told { snapshot, pan, is_paused, volume } = told;
    let flag = |on: bool| f32::from(u8::from(on));
    let mut letter = Vec::with_capacity(length(events.len()));
    letter.extend(snapshot.steam);
    letter.extend([snapshot.floor_c, snapshot.oil_c, flag(snapshot.lid), snapshot.covered]);
    letter.extend([f32::from(snapshot.stove as u8), snapshot.stove_w]);
    letter.extend([f32::from(pan.metal as u8), pan.radius_m, pan.thickness_m, flag(*is_paused), *volume]);
    for event in events {
        letter.extend([f32::from(event.kind as u8), event.strength, event.at_s, event.side]);
    }
    letter
}

/// Reads the input of a player; none if the numbers are not such a letter.
pub fn read(letter: &[f32]) -> Option<(Told, impl Iterator<Item = Event>)> {
    let (head, events) = letter.split_at_checked(HEAD)?;
    let (steam, rest) = head.split_first_chunk::<{ Steam::ALL.len() }>()?;
    let [floor_c, oil_c, lid, covered, stove, stove_w, metal, radius_m, thickness_m, is_paused, volume] =
        *rest.first_chunk()?;
    let pan = Plate { metal: *Metal::ALL.get(metal as usize)?, radius_m, thickness_m };
    let stove = *Stove::ALL.get(stove as usize)?;
    let snapshot = Snapshot { steam: *steam, floor_c, oil_c, lid: lid != 0.0, covered, stove, stove_w };
    let is_pan = radius_m.is_normal() && thickness_m.is_normal() && events.len().is_multiple_of(EVENT);
    let told = Told { snapshot, pan, is_paused: is_paused != 0.0, volume };
    is_pan.then(|| (told, events.chunks_exact(EVENT).filter_map(event)))
}

fn event(numbers: &[f32]) -> Option<Event> {
    let [kind, strength, at_s, side] = *numbers.first_chunk()?;
    Some(Event { kind: *EventKind::ALL.get(kind as usize)?, strength, at_s, side })
}
