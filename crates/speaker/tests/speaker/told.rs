//! What is sent is heard, soon and in full; what is too much is counted.

use saute_sound::{Event, EventKind, Snapshot, Told};
use saute_speaker::{BLOCK, QUEUED};

use crate::device::{frying, silent_blocks, speaker_at};

/// Act to first sample: within two blocks of those in the device's queue, 11 ms at 48 kHz; with a picture of a window, 17 ms more.
/// The device's own buffer comes on top.
#[test]
fn what_is_told_is_in_the_next_blocks() {
    let (mut speaker, played) = speaker_at(48_000);
    let quiet = Told { snapshot: Snapshot::default(), ..frying() };
    speaker.hear(quiet, &[]);
    (0..200).for_each(|_| drop(played.recv().expect("a block")));
    speaker.hear(quiet, &[Event::now(EventKind::Clank, 1.0)]);
    // Two blocks wait in the device, one is being given to it.
    let silent = silent_blocks(&played);
    assert!(silent <= 3 + 2, "{silent} blocks of {BLOCK}");
    assert_eq!((speaker.dropped_events(), speaker.trouble()), (0, None));
}

/// More events than a picture can have: the strongest are played, the others counted, and their sender never waits.
#[test]
fn of_too_many_events_the_weakest_are_dropped_and_counted() {
    let (mut speaker, played) = speaker_at(48_000);
    // The device is full and takes nothing: the queue fills, then what waits for it.
    let quiet = Told { snapshot: Snapshot::default(), ..frying() };
    let weak = Event::now(EventKind::Spatter, 0.01);
    (0..8).for_each(|_| speaker.hear(quiet, &[weak; QUEUED]));
    let dropped = speaker.dropped_events();
    assert!(dropped >= 5 * QUEUED as u64, "{dropped}");
    speaker.hear(quiet, &[Event::now(EventKind::Clank, 1.0)]);
    let loud = |block: &Vec<[f32; 2]>| block.iter().any(|frame| frame[0].abs() > 0.05);
    let mut later = played.iter().take(400).inspect(|_| speaker.hear(quiet, &[]));
    assert!(later.any(|block| loud(&block)), "the strong one is heard");
}

/// A sound card of any rate is played at its own.
#[test]
fn odd_rates_are_played() {
    for rate in [0, 8_000, 11_025, 44_100, 192_000, 384_000] {
        let (mut speaker, played) = speaker_at(rate);
        speaker.hear(frying(), &[]);
        assert!(silent_blocks(&played) < 100, "{rate} Hz");
    }
}
