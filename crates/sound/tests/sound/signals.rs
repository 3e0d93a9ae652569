//! What is true of every signal: the same bits, no clicks, no overload, silence when paused.

use saute_sound::{CEILING, Event, EventKind, Snapshot, Steam, Stove, Synth, TICK_S};

use crate::ear::{bends, quantile};
use crate::steam::{PAN, RATE, hot};

const TICK: usize = RATE as usize / 10;

/// A lively cook: flows that change, blows, a lid.
fn lively(tick: usize) -> (Snapshot, Vec<Event>) {
    let snapshot = hot(Steam::Floor, 0.05 * (tick % 7) as f64).with(Steam::Butter, 1e-4).with(Steam::Water, 2e-5);
    let kind = EventKind::ALL[tick % EventKind::ALL.len()];
    let at_s = 0.013 * (tick % 8) as f32;
    let events = vec![Event { kind, strength: 0.7, at_s, side: 0.2 }, Event::now(EventKind::Spatter, 0.4)];
    (Snapshot { lid: tick % 20 > 14, covered: 0.02 * (tick % 30) as f32, ..snapshot }, events)
}

fn cooked(block: usize) -> Vec<[f32; 2]> {
    let mut synth = Synth::new(RATE, 5, &PAN);
    let mut frames = vec![[0.0; 2]; 40 * TICK];
    for (tick, frames) in frames.chunks_mut(TICK).enumerate() {
        let (snapshot, events) = lively(tick);
        synth.feed(&snapshot, &events);
        frames.chunks_mut(block).for_each(|block| synth.render(block));
    }
    frames
}

/// A recording can be made again, whatever device or file requests it.
#[test]
fn the_bits_are_the_same_for_any_block_size() {
    let whole = cooked(TICK);
    let bits = |frames: &[[f32; 2]]| frames.iter().flatten().map(|x| x.to_bits()).collect::<Vec<_>>();
    for block in [1, 64, 256, 1000] {
        assert!(bits(&cooked(block)) == bits(&whole), "blocks of {block}");
    }
}

/// Every platform, browser included, makes these bits. The number changes when the sound is meant to.
#[test]
fn the_bits_are_the_same_on_every_platform() {
    let frames = cooked(TICK);
    // FNV-1a of the bits.
    let hash = |hash: u64, x: &f32| (hash ^ u64::from(x.to_bits())).wrapping_mul(0x100_0000_01b3);
    let found = frames.iter().flatten().fold(0xcbf2_9ce4_8422_2325, hash);
    assert_eq!(found, 0x7993_af9f_4432_01ab, "{found:#x}");
}

/// A device's thread must not wait for memory: all of it is there from the beginning.
#[test]
fn nothing_is_allocated_while_it_sounds() {
    let mut synth = Synth::new(RATE, 5, &PAN);
    let ticks: Vec<_> = (0..40).map(lively).collect();
    let mut frames = vec![[0.0; 2]; TICK];
    let counted = allocation_counter::measure(|| {
        for (snapshot, events) in &ticks {
            synth.feed(snapshot, events);
            synth.render(&mut frames);
        }
    });
    assert_eq!(counted.count_total, 0);
}

/// A stove at full power, a cloth and six blows at once overload nothing.
#[test]
fn no_sample_is_above_minus_one_dbfs() {
    let mut synth = Synth::new(RATE, 5, &PAN);
    let mut frames = vec![[0.0; 2]; TICK];
    let mut loudest = 0.0f32;
    for tick in 0..60 {
        let flow = if tick % 20 < 10 { 40.0 } else { 0.0 };
        let events = [EventKind::Clank, EventKind::Bell, EventKind::Slap].map(|kind| Event::now(kind, 1.0));
        synth.feed(&hot(Steam::Cloth, flow), &[events, events].concat());
        synth.render(&mut frames);
        loudest = frames.iter().flatten().fold(loudest, |peak, x| peak.max(x.abs()));
    }
    println!("loudest {loudest}, ceiling {CEILING}");
    assert!(loudest <= CEILING && loudest > 0.8 * CEILING, "{loudest}");
}

/// Values that are not numbers, and flows beyond every stove, break nothing.
#[test]
fn values_out_of_range_break_nothing() {
    let mut synth = Synth::new(RATE, 5, &PAN);
    let mut frames = vec![[0.0; 2]; TICK];
    for odd in [f32::NAN, f32::INFINITY, -1.0, 1e30] {
        let steam = [odd; Steam::ALL.len()];
        let event = Event { kind: EventKind::Clank, strength: odd, at_s: odd, side: odd };
        let drop = Event { kind: EventKind::Drop, strength: 0.5, at_s: 0.0, side: odd };
        let (stove, stove_w) = (Stove::Flame, odd);
        synth.feed(
            &Snapshot { steam, floor_c: odd, oil_c: odd, lid: false, covered: odd, stove, stove_w },
            &[event, drop],
        );
        synth.render(&mut frames);
        assert!(frames.iter().flatten().all(|x| x.is_finite() && x.abs() <= CEILING), "{odd}");
    }
    synth.feed(&Snapshot::default(), &[]);
    (0..60).for_each(|_| synth.render(&mut frames));
    assert!(frames.iter().all(|frame| *frame == [0.0; 2]));
}

/// Pause means silence at once, for someone at the door; and it goes on where it stopped.
#[test]
fn a_pause_is_silent_within_20_ms() {
    let mut synth = Synth::new(RATE, 5, &PAN);
    let mut frames = vec![[0.0; 2]; 3 * RATE as usize];
    let loud = hot(Steam::Floor, 1.0).with(Steam::Water, 1e-3);
    let (before, after) = frames.split_at_mut(RATE as usize);
    synth.feed(&loud, &[Event { kind: EventKind::Bell, strength: 1.0, at_s: 0.09, side: 0.0 }]);
    synth.render(before);
    synth.set_paused(true);
    synth.render(&mut after[..RATE as usize]);
    assert!(after[RATE as usize / 50..RATE as usize].iter().all(|frame| *frame == [0.0; 2]));
    synth.set_paused(false);
    synth.render(&mut after[RATE as usize..]);
    assert!(after[RATE as usize + 960..].iter().any(|frame| frame[0].abs() > 0.05));
}

/// Something that is done to a synthesiser.
type Change = fn(&mut Synth);

/// Bends in the 5 ms after a change against those of the second before.
fn bend(seed: u64, change: impl Fn(&mut Synth)) -> (f64, f64) {
    let mut synth = Synth::new(RATE, seed, &PAN);
    let mut frames = vec![[0.0; 2]; 2 * RATE as usize + RATE as usize / 200];
    let (settled, rest) = frames.split_at_mut(RATE as usize);
    synth.feed(&hot(Steam::Floor, 0.2), &[]);
    synth.render(settled);
    synth.render(&mut rest[..RATE as usize]);
    change(&mut synth);
    synth.render(&mut rest[RATE as usize..]);
    let found = bends(rest);
    let (before, after) = found.split_at(RATE as usize);
    (quantile(after, 1.0), quantile(before, 0.999))
}

/// Of 24 seeds, in how many a bend after a change is above the 99.9 % of the second before, and the most that it is above it [-].
fn above(change: Change) -> (usize, f64) {
    let bent: Vec<(f64, f64)> = (0..24).map(|seed| bend(seed, change)).collect();
    let worst = bent.iter().map(|(after, before)| after / before).fold(0.0, f64::max);
    (bent.iter().filter(|(after, before)| after > before).count(), worst)
}

/// Nothing clicks when the sound stops, when the lid is laid on, when the steam ends or doubles.
///
/// In a steady hiss one of the 240 bends of 5 ms is above the 99.9 % of a second with a chance of 21 %: a change must not make that
/// more.
#[test]
fn no_change_clicks() {
    let (_, by_chance) = above(|_| ());
    let changes: [(&str, Change); 4] = [
        ("pause", |synth| synth.set_paused(true)),
        ("lid", |synth| synth.feed(&Snapshot { lid: true, ..hot(Steam::Floor, 0.2) }, &[])),
        ("end", |synth| synth.feed(&hot(Steam::Floor, 0.0), &[])),
        ("twice", |synth| synth.feed(&hot(Steam::Floor, 0.4), &[])),
    ];
    for (name, change) in changes {
        let (count, worst) = above(change);
        println!("{name}: above in {count} of 24, worst {worst:.2} times; by chance {by_chance:.2} times");
        // By chance 5 of 24; 10 or more come once in 200.
        assert!(count < 10 && worst < 1.1 * by_chance, "{name}: {count} of 24, {worst}");
    }
}

/// A resumed sound fades in: its first 5 ms bend no more than it does anyway.
#[test]
fn going_on_after_a_pause_does_not_click() {
    let above = (0..24).filter(|seed| {
        let (after, before) = bend(*seed, |synth| {
            synth.set_paused(true);
            synth.render(&mut vec![[0.0; 2]; RATE as usize / 10]);
            synth.set_paused(false);
        });
        after > before
    });
    assert_eq!(above.count(), 0);
}

/// When more events come than can wait, the weakest are lost, and that is counted.
#[test]
fn of_too_many_events_the_weakest_are_dropped_and_counted() {
    let mut synth = Synth::new(RATE, 5, &PAN);
    let weak = Event { kind: EventKind::Spatter, strength: 0.01, at_s: 0.05, side: 0.0 };
    let strong = Event { kind: EventKind::Clank, strength: 1.0, ..weak };
    synth.feed(&Snapshot::default(), &[vec![weak; 32], vec![strong]].concat());
    assert_eq!(synth.dropped_events(), 1);
    let mut frames = vec![[0.0; 2]; TICK];
    synth.render(&mut frames);
    assert!(frames.iter().any(|frame| frame[0].abs() > 0.05), "the strong one is heard");
}

/// An event within a tick starts at its own sample, not with the tick.
#[test]
fn an_event_starts_at_its_sample() {
    let first = |at_s: f32| {
        let mut synth = Synth::new(RATE, 5, &PAN);
        let mut frames = vec![[0.0; 2]; 2 * TICK];
        synth.feed(&Snapshot::default(), &[Event { at_s, ..Event::now(EventKind::Clank, 1.0) }]);
        synth.render(&mut frames);
        frames.iter().position(|frame| *frame != [0.0; 2]).expect("it is heard")
    };
    assert_eq!(first(0.5 * TICK_S) - first(0.0), TICK / 2);
}

/// What it costs: printed, not judged, as the machine is shared.
#[test]
fn a_full_pan_is_computed_many_times_faster_than_it_sounds() {
    let mut synth = Synth::new(RATE, 5, &PAN);
    let mut block = vec![[0.0; 2]; 256];
    let full = Steam::ALL.into_iter().fold(hot(Steam::Floor, 0.01), |all, place| all.with(place, 1e-5));
    synth.feed(&full, &[]);
    let begun = std::time::Instant::now();
    let blocks = 10 * RATE as usize / block.len();
    for number in 0..blocks {
        if number % 18 == 0 {
            synth.feed(&full, &[EventKind::Spatter; 10].map(|kind| Event::now(kind, 0.5)));
        }
        synth.render(&mut block);
    }
    println!("{:.2} % of a core at 48 kHz", 10.0 * begun.elapsed().as_secs_f64());
}
