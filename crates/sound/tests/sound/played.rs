//! What plays live: at once, at a volume, silent in a pause and when it receives no state.

use saute_sound::letter;
use saute_sound::{Event, EventKind, Metal, Plate, Player, SILENCE_DB, Snapshot, Steam, TICK_S, Told};

use crate::ear::{bends, level, mono, quantile};
use crate::steam::{PAN, RATE, hot, steady};

const SECOND: usize = RATE as usize;
/// A block of a device [samples].
const BLOCK: usize = 256;

fn frying() -> Told {
    Told { snapshot: hot(Steam::Floor, 0.1), pan: PAN, is_paused: false, volume: 1.0 }
}

/// Renders while the same state is sent sixty times a second, as by a window.
fn played(player: &mut Player, told: &Told, samples: usize) -> Vec<[f32; 2]> {
    let mut frames = vec![[0.0; 2]; samples];
    for picture in frames.chunks_mut(SECOND / 60) {
        player.hear(told, &[]);
        picture.chunks_mut(BLOCK).for_each(|block| player.render(block));
    }
    frames
}

/// Hands and ears belong together: what is done sounds in the next block that the device requests.
#[test]
fn an_act_is_heard_in_the_next_block() {
    let mut player = Player::new(RATE);
    let quiet = Told { snapshot: Snapshot::default(), ..frying() };
    played(&mut player, &quiet, SECOND);
    player.hear(&quiet, &[Event::now(EventKind::Clank, 0.5)]);
    let mut block = [[0.0; 2]; BLOCK];
    player.render(&mut block);
    let first = block.iter().position(|frame| *frame != [0.0; 2]).expect("it is heard");
    // The limiter looks 2 ms ahead.
    assert!(first <= SECOND / 400, "{first} samples");
}

/// The pan sounds as loud as its steam implies, and its level is computed from the state alone.
#[test]
fn the_told_level_is_the_level_that_is_heard() {
    for (place, g_s) in [(Steam::Floor, 0.1), (Steam::Water, 0.5), (Steam::Butter, 0.1), (Steam::Oil, 0.2)] {
        for lid in [false, true] {
            let snapshot = Snapshot { lid, ..hot(place, g_s) };
            let heard = level(&mono(&steady(snapshot, 2)));
            println!("{place:?}, lid {lid}: told {:.1}, heard {heard:.1} dBFS", snapshot.level());
            assert!((f64::from(snapshot.level()) - heard).abs() < 3.0, "{place:?}, lid {lid}");
            assert_eq!(snapshot.level(), snapshot.level_of(place));
        }
    }
    assert_eq!(Snapshot::default().level(), SILENCE_DB);
}

/// The middle of the volume is 12 dB below the whole, and no volume is silence.
#[test]
fn the_volume_is_that_of_the_switch() {
    let heard = |volume: f32| {
        let frames = played(&mut Player::new(RATE), &Told { volume, ..frying() }, 3 * SECOND);
        level(&mono(&frames[SECOND..]))
    };
    let (whole, half) = (heard(1.0), heard(0.5));
    assert!((whole - half - 12.0).abs() < 0.2, "{whole}, {half}");
    assert!(heard(0.0) < -200.0 && heard(f32::NAN) < -200.0);
}

/// Pause and switch are silence in 20 ms, wherever the device's block begins; and what was done in the pause is not heard after it.
#[test]
fn a_pause_is_silent_within_20_ms_and_keeps_nothing() {
    let mut player = Player::new(RATE);
    played(&mut player, &frying(), SECOND);
    let paused = Told { is_paused: true, ..frying() };
    let after = played(&mut player, &paused, SECOND);
    assert!(after[SECOND / 50..].iter().all(|frame| *frame == [0.0; 2]));
    player.hear(&Told { snapshot: Snapshot::default(), ..paused }, &[Event::now(EventKind::Bell, 1.0)]);
    played(&mut player, &Told { snapshot: Snapshot::default(), ..frying() }, SECOND);
    let later = played(&mut player, &Told { snapshot: Snapshot::default(), ..frying() }, SECOND);
    assert!(later.iter().all(|frame| *frame == [0.0; 2]), "no bell");
}

/// A window that hangs, or is gone, does not sizzle on for ever.
#[test]
fn a_player_that_is_told_nothing_falls_silent() {
    let mut player = Player::new(RATE);
    played(&mut player, &frying(), SECOND);
    let mut frames = vec![[0.0; 2]; 3 * SECOND];
    frames.chunks_mut(BLOCK).for_each(|block| player.render(block));
    assert!(frames[SECOND / 2].iter().any(|x| *x != 0.0), "a slow picture is bridged");
    assert!(frames[SECOND + SECOND / 10..].iter().all(|frame| *frame == [0.0; 2]));
    assert!(played(&mut player, &frying(), SECOND)[SECOND / 2..].iter().any(|frame| frame[0] != 0.0));
}

/// Simulated time may run twenty times as fast: one tick in nine is sent, and it is the sound of that one, at its own pitch.
#[test]
fn fast_time_is_the_sound_of_the_moment() {
    let told = |tick: usize| Told { snapshot: hot(Steam::Floor, 0.1 + 0.001 * (tick % 10) as f64), ..frying() };
    let mut player = Player::new(RATE);
    let mut frames = vec![[0.0; 2]; 3 * SECOND];
    for (picture, frames) in frames.chunks_mut(SECOND / 60).enumerate() {
        player.hear(&told(9 * picture), &[]);
        player.render(frames);
    }
    let (fast, slow) = (mono(&frames[SECOND..]), mono(&steady(hot(Steam::Floor, 0.1045), 2)));
    assert!((level(&fast) - level(&slow)).abs() < 0.5);
    let pitch = |frames: &[[f32; 2]]| crate::ear::centroid(frames, f64::from(RATE));
    let (fast, slow) = (pitch(&frames[SECOND..]), pitch(&steady(hot(Steam::Floor, 0.1045), 2)));
    assert!((fast / slow - 1.0).abs() < 0.03, "{fast} Hz, {slow} Hz");
}

/// Another cook has another pan: the last one fades out, without a click, and the new one sounds.
#[test]
fn another_pan_begins_without_a_click() {
    let mut player = Player::new(RATE);
    let mut frames = played(&mut player, &frying(), SECOND);
    let pan = Plate { metal: Metal::CastIron, thickness_m: 4e-3, ..PAN };
    frames.extend(played(&mut player, &Told { pan, ..frying() }, SECOND));
    let bends = bends(&frames);
    let (before, after) =
        (quantile(&bends[SECOND / 2..SECOND], 1.0), quantile(&bends[SECOND..SECOND + SECOND / 10], 1.0));
    assert!(after <= 1.2 * before, "{after} above {before}");
    assert!(frames[SECOND + SECOND / 2..].iter().any(|frame| frame[0] != 0.0));
}

/// Devices request what they like: any rate, any length, a wait between.
#[test]
fn odd_rates_and_lengths_of_blocks_are_played() {
    for rate in [0, 8_000, 11_025, 44_100, 88_200, 192_000, 384_000] {
        let mut player = Player::new(rate);
        for block in [0, 1, 7, 441, 5_000] {
            let mut frames = vec![[0.0; 2]; block];
            player.hear(&frying(), &[Event::now(EventKind::Put, 1.0)]);
            player.render(&mut frames);
            assert!(frames.iter().flatten().all(|x| x.is_finite() && x.abs() <= 1.0), "{rate} Hz, {block} samples");
        }
    }
}

/// A page gets what a window gets: nothing is lost on the way as numbers, and what is no letter is refused.
#[test]
fn a_letter_says_what_was_told() {
    let snapshot = Snapshot { lid: true, covered: 0.4, oil_c: 175.0, ..hot(Steam::Butter, 0.2) };
    let told = Told { snapshot, volume: 0.3, pan: Plate { metal: Metal::Aluminium, ..PAN }, is_paused: true };
    let events = EventKind::ALL.map(|kind| Event { kind, strength: 0.5, at_s: 0.03, side: -0.7 });
    let letter = letter::written(&told, &events);
    let (read, read_events) = letter::read(&letter).expect("a letter");
    assert_eq!((read, read_events.collect::<Vec<_>>()), (told, events.to_vec()));
    for wrong in [&letter[..14], &letter[..letter.len() - 1], &[f32::NAN; 15], &[0.0; 15], &[]] {
        assert!(letter::read(wrong).is_none(), "{wrong:?}");
    }
}

/// The page's module makes the same bits: web/test/sound.test.mjs has this number too. It changes when the sound is meant to.
#[test]
fn a_letter_sounds_the_same_everywhere() {
    let mut player = Player::new(RATE);
    let snapshot = Snapshot { floor_c: 180.0, oil_c: 180.0, ..Snapshot::default() }.with(Steam::Floor, 1e-4);
    let told = Told { snapshot, volume: 0.5, ..frying() };
    let letter = letter::written(&told, &[Event { kind: EventKind::Clank, strength: 0.8, at_s: 0.05, side: 0.0 }]);
    let (told, events) = letter::read(&letter).expect("a letter");
    player.hear(&told, &events.collect::<Vec<_>>());
    let mut frames = vec![[0.0f32; 2]; SECOND / 2];
    frames.chunks_mut(128).for_each(|block| player.render(block));
    // FNV-1a of the bits, in 32 bits.
    let hash = |hash: u32, x: &f32| (hash ^ x.to_bits()).wrapping_mul(0x0100_0193);
    let found = frames.iter().flatten().fold(0x811c_9dc5, hash);
    assert_eq!(found, 0xc0cd_5f5a, "{found:#x}");
}

/// A device's thread does not wait for memory while one pan sounds.
#[test]
fn nothing_is_allocated_while_it_plays() {
    let mut player = Player::new(RATE);
    let mut block = vec![[0.0; 2]; SECOND / 10];
    (0..3).for_each(|_| {
        player.hear(&frying(), &[]);
        player.render(&mut block);
    });
    let events = [Event { at_s: 0.5 * TICK_S, ..Event::now(EventKind::Put, 1.0) }];
    let counted = allocation_counter::measure(|| {
        (0..20).for_each(|_| {
            player.hear(&frying(), &events);
            player.render(&mut block);
        });
    });
    assert_eq!(counted.count_total, 0);
}
