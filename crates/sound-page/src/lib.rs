//! The player for a page's `AudioWorkletProcessor` (web/sound_worklet.js), as a module that imports nothing.
//!
//! The worklet writes a letter ([`saute_sound::letter`]) to [`letter_at`] and calls [`hear`]; for each block it calls [`render`] and
//! reads both sides at [`left_at`] and [`right_at`]. Addresses stay the same while the module lives.
#![allow(unsafe_code, reason = "a page's script finds functions by their names, which must be unique in the module")]

use std::sync::{Mutex, MutexGuard, PoisonError};

use saute_sound::{Event, Player, letter};

/// Largest block that is rendered at once [samples]: a worklet requests 128.
const MOST_BLOCK: usize = 1024;
/// Most events of a letter [-] (chosen: as the queue of a sound card).
const MOST_EVENTS: usize = 64;
/// Longest letter [numbers].
const MOST_LETTER: usize = letter::length(MOST_EVENTS);

/// A player with the places for what comes in and goes out.
struct Desk {
    player: Option<Player>,
    events: Vec<Event>,
    letter: [f32; MOST_LETTER],
    block: [[f32; 2]; MOST_BLOCK],
    sides: [[f32; MOST_BLOCK]; 2],
}

static DESK: Mutex<Desk> = Mutex::new(Desk {
    player: None,
    events: Vec::new(),
    letter: [0.0; MOST_LETTER],
    block: [[0.0; 2]; MOST_BLOCK],
    sides: [[0.0; MOST_BLOCK]; 2],
});

/// A worklet has one thread: nobody else has the desk.
fn desk() -> MutexGuard<'static, Desk> {
    DESK.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Begins to play at a sample rate [Hz].
#[unsafe(no_mangle)]
pub extern "C" fn begin(rate: u32) {
    let mut desk = desk();
    desk.player = Some(Player::new(rate));
    desk.events = Vec::with_capacity(MOST_EVENTS);
}

/// Address of the place for a letter [byte].
#[unsafe(no_mangle)]
pub extern "C" fn letter_at() -> usize {
    desk().letter.as_ptr() as usize
}

/// Room for a letter [numbers].
#[unsafe(no_mangle)]
pub extern "C" fn letter_room() -> usize {
    MOST_LETTER
}

/// Takes a letter of so many numbers; returns 0 if it is none.
#[unsafe(no_mangle)]
pub extern "C" fn hear(length: usize) -> u32 {
    let desk = &mut *desk();
    let read = desk.letter.get(..length).and_then(letter::read);
    let (Some((told, events)), Some(player)) = (read, &mut desk.player) else { return 0 };
    desk.events.clear();
    desk.events.extend(events);
    player.hear(&told, &desk.events);
    1
}

/// Renders so many samples, at most 1024; returns how many.
#[unsafe(no_mangle)]
pub extern "C" fn render(count: usize) -> usize {
    let desk = &mut *desk();
    let block = &mut desk.block[..count.min(MOST_BLOCK)];
    match &mut desk.player {
        Some(player) => player.render(block),
        None => block.fill([0.0; 2]),
    }
    for (place, [left, right]) in block.iter().enumerate() {
        (desk.sides[0][place], desk.sides[1][place]) = (*left, *right);
    }
    block.len()
}

/// Address of the samples of the left side [byte].
#[unsafe(no_mangle)]
pub extern "C" fn left_at() -> usize {
    desk().sides[0].as_ptr() as usize
}

/// Address of the samples of the right side [byte].
#[unsafe(no_mangle)]
pub extern "C" fn right_at() -> usize {
    desk().sides[1].as_ptr() as usize
}
